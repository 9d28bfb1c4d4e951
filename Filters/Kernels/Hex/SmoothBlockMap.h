#pragma once

#include "Base/Progress.h"
#include "Geometry/FeatureAngle.h"
#include "Hex/StructuredBlocks.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct SmoothBlockMapOptions : BlockSplineOptions
{
  double FeatureAngle = DefaultFeatureAngle; ///< of creases (FindFeatures); degrees, in (0, 180]
};

/// Throws InvalidInput if FeatureAngle is out of its range.
void RequireInRange(const SmoothBlockMapOptions& options);

struct SmoothBlockMap
{
  Eigen::MatrixXd Targets; ///< n x 3: the new position of each point
  /// n x 3: the positions of the points on the splines. Splines fitted to these go through them.
  Eigen::MatrixXd Splines;
  double LargestMotion = 0.0; ///< of a point; 0 if no better map was found
  int Inverted = 0;           ///< cells with a scaled Jacobian <= 0
};

/**
 * Moves the points of a grid so that splines over its blocks follow them (FitBlockSpline). Points
 * of the boundary slide along a surface, so that only the shape of the solid, and not the places of
 * points on it, has to be followed.
 *
 * 1. The control points of the boundary minimise the sum of squared distances of its points from
 *    the tangent planes at the nearest positions of the surface, and from creases, plus a factor
 *    times that of second differences. The factor falls from 1 to 1e-4 (tangent distance
 *    minimisation: Wang, Pottmann and Liu, "Fitting B-spline curves to point clouds by
 *    curvature-based squared distance minimization", 2006, here for surfaces).
 * 2. The squares are weighted, so that the largest distance falls (Lawson's iteration: Rice and
 *    Usow, "The Lawson algorithm and extensions", 1968). After each step, the weight of a point is
 *    multiplied by the root of its distance; weights stay within a factor of 10 of their mean.
 * 3. After each step, the motion of the boundary is extended by discrete harmonic functions. Points
 *    inside are then put on the splines, and points of the boundary on the surface.
 * 4. Of these maps and the given one, that with the smallest error of its splines is taken. None
 *    may invert more cells than the given one.
 *
 * Points on creases stay on creases, and points where other than two edges along creases meet stay
 * where they are.
 *
 * blocks: of FindGridBlocks. cells: m x 8. targets (n x 3): where the points are. surface: closed
 * and consistently oriented; points of the boundary are put on it. Throws InvalidInput if an option
 * is out of range, SolveFailure and Aborted.
 */
SmoothBlockMap SmoothMapOfBlocks(const std::vector<GridBlock>& blocks, const Eigen::MatrixXi& cells,
  const Eigen::MatrixXd& targets, const Surface& surface, const SmoothBlockMapOptions& options = {},
  const Progress& progress = {});

/// Returns the positions, on splines fitted to all blocks, of the points of a grid (n x 3).
Eigen::MatrixXd EvaluateAtNodes(const std::vector<GridBlock>& blocks,
  const Eigen::MatrixXd& targets, const BlockSplineOptions& options = {},
  const Progress& progress = {});

} // namespace shape
