#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

struct MoebiusCenteringOptions
{
  double Tolerance = 1e-13;    ///< stops when the mean is at most this far from the origin
  int MaximumIterations = 200; ///< maximum number of Newton steps; >= 0
};

struct MoebiusCenteringResult
{
  Eigen::MatrixXd Points;  ///< n x 3, on the unit sphere to rounding
  int Iterations = 0;      ///< number of Newton steps taken
  double MeanLength = 0.0; ///< remaining distance of the weighted mean from the origin
};

/**
 * Applies the Moebius transform of the unit sphere that moves the weighted mean of the points to
 * the origin. This transform is unique up to rotation (Baden, Crane & Kazhdan 2018, "Moebius
 * Registration", algorithm 1). A Newton step that does not bring the mean closer to the origin is
 * shortened. Each step is an inversion p -> (1 - |c|^2) (p + c) / |p + c|^2 + c, which preserves
 * orientation and does not rotate around the centre.
 *
 * points: n x 3, none at the origin; they are normalised first. weights: n values >= 0. Throws
 * InvalidInput if the sizes differ, a value is not finite, a weight is negative, a point is at the
 * origin, or all weights are zero. It also throws if one point has at least half of the total
 * weight, because no transform can then centre the points. If rounding stops the descent before
 * Tolerance is reached, MeanLength is larger than Tolerance.
 */
MoebiusCenteringResult CenterOnSphere(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights,
  const MoebiusCenteringOptions& options = {}, const Progress& progress = {});

} // namespace shape
