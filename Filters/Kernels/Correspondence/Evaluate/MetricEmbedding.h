#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <string>

namespace shape
{

struct MetricEmbeddingOptions
{
  int Iterations = 100; ///< maximum number of Gauss-Newton steps; >= 1
};

struct EmbeddedMetric
{
  Eigen::MatrixXd Points;   ///< n x 3
  double LengthError = 0.0; ///< root mean square of the edges' relative errors of length
};

/// Returns the surface whose points are moved by `distance` along their vertex normals
/// (GetVertexNormals), outwards if it is positive. Throws InvalidInput if a triangle is turned
/// over: the distance then exceeds a radius of curvature. name: denotes the surface in the message.
Surface OffsetSurface(const Surface& surface, double distance, const std::string& name);

/**
 * Computes positions for which the edges have given lengths: the least sum of squared relative
 * errors, found by damped Gauss-Newton steps from the positions of `start`. The damping is the
 * Laplacian of the edges, so that early steps bend the surface smoothly.
 *
 * Lengths alone leave a surface free to bend, exactly or nearly. The lengths on its offset surface
 * determine how it bends: they encode the second fundamental form (Corman et al., "Functional
 * characterization of intrinsic and extrinsic geometry", 2017, section 6). If they are given, each
 * triangle becomes a prism between the surface and its offset surface. If the normals do not twist
 * along an edge, the edge and its offset, of lengths l and l', are the parallel sides of a
 * trapezoid whose legs have the length t. The squares of its diagonals are then l l' + t^2, by
 * Ptolemy.
 *
 * sides: m x 3, the length of the edge opposite each corner, the same for both triangles of an
 * edge. offsetSides: the same on the offset surface at `distance`, or empty. Throws InvalidInput
 * if there is not one row for each triangle or a length is not positive and finite; SolveFailure;
 * Aborted.
 */
EmbeddedMetric EmbedMetric(const Surface& start, const Eigen::MatrixXd& sides,
  const Eigen::MatrixXd& offsetSides = {}, double distance = 0.0,
  const MetricEmbeddingOptions& options = {}, const Progress& progress = {});

} // namespace shape
