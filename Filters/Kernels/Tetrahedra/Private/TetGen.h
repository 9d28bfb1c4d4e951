#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

namespace shape
{

/// What TetGen is asked for.
struct TetGenInput
{
  const Mesh& Surfaces;          ///< facets over distinct points, each used; none crosses another
  const Eigen::MatrixXd& Holes;  ///< n x 3: a place in each void inside
  double MaximumRadiusEdgeRatio; ///< > 1, or 0 for none
  double MaximumVolume;          ///< of a tetrahedron; 0 for none
  bool PreserveBoundary;         ///< no new points on the facets
  int MaximumNewPoints;          ///< where refinement stops although bounds are not met
};

/// What it made.
struct TetGenOutput
{
  Eigen::MatrixXd Points;     ///< n x 3: those of the facets first
  Eigen::MatrixXi Tetrahedra; ///< m x 4, all of the same orientation
  Eigen::MatrixXi Faces;      ///< k x 3: the faces of tetrahedra that lie on facets
};

/**
 * Runs TetGen (Hang Si, "TetGen, a Delaunay-based quality tetrahedral mesh generator", 2015).
 *
 * TetGen 1.5 asserts, crashes or loops on some inputs, so it works in a forked copy of this
 * process, which shares nothing with it but a pipe: whatever happens there ends there, and an abort
 * kills it. Throws InvalidInput where ShapeMap was built without TetGen or TetGen refuses the
 * input, SolveFailure where TetGen gives up or crashes, Aborted within 0.2 s.
 */
TetGenOutput RunTetGen(const TetGenInput& input, const Progress& progress = {});

} // namespace shape
