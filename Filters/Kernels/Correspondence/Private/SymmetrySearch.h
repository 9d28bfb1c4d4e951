#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace shape
{

/// A map of a surface to itself, of points to points.
struct PointSymmetry
{
  Eigen::VectorXi Images;  ///< n: for each point, the point that is its image
  double Distortion = 0.0; ///< mean change of the distance of two samples
};

/// The symmetries of a surface, which are a group.
struct PointSymmetries
{
  std::vector<PointSymmetry> Elements; ///< the identity first
  Eigen::MatrixXi Composition;         ///< (i, j): element i after element j
  std::vector<int> Generators;         ///< elements of which all others are products
  double Bound = 0.0;                  ///< maps that distort more are no symmetries
  /// The smallest distortion of a map that is no symmetry; infinite if none was tried.
  double Rejected = std::numeric_limits<double>::infinity();
};

/**
 * Finds the maps of a surface to itself that keep the distances along it.
 *
 * Such a map is determined by the images of three points that tell all others apart by their
 * distances. Triples with the same distances, and the same distances from all of the surface, are
 * the candidates. Each gives a map of samples, which is fitted to more and more samples
 * (as in generalised multidimensional scaling: Bronstein et al. 2006). It is a symmetry if
 * distances change by at most `tolerance` of the root of the area on average, and what the spacing
 * of the points causes. The products of symmetries are symmetries, too; they may distort by half
 * more than this bound.
 *
 * surface: connected, of about 1000 points, each with a triangle. Throws SolveFailure if there are
 * more than maximumOrder symmetries; Aborted.
 */
PointSymmetries FindPointSymmetries(
  const Surface& surface, double tolerance, int maximumOrder, const Progress& progress = {});

} // namespace shape
