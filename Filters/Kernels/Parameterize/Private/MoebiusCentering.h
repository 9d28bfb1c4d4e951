#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

struct MoebiusCenteringOptions
{
  double Tolerance = 1e-13;    ///< stops when the mean is this short, relative to the radius
  int MaximumIterations = 200; ///< maximum number of Newton steps
};

struct MoebiusCenteringResult
{
  Eigen::MatrixXd Points;  ///< n x 3, on the unit sphere to rounding
  int Iterations = 0;      ///< Newton steps taken
  double MeanLength = 0.0; ///< remaining distance of the weighted mean from the origin
};

/**
 * Applies the Moebius transform of the unit sphere that moves the weighted mean of the points to
 * the origin; it is unique up to rotation (Baden, Crane & Kazhdan 2018, "Moebius Registration",
 * algorithm 1). Newton steps are shortened if they do not reduce the mean's length. Each step is an
 * inversion p -> (1 - |c|^2) (p + c) / |p + c|^2 + c, which preserves orientation and does not
 * rotate around the centre.
 *
 * points: n x 3, of any length except zero (they are normalised first). weights: n, not negative.
 * Throws InvalidInput if the sizes differ, a value is not finite, a weight is negative, a point is
 * at the origin, or all weights are zero. It also throws if one point has at least half of the
 * weight, because no transform can centre that. If rounding ends the descent before Tolerance,
 * MeanLength is the length reached.
 */
MoebiusCenteringResult CenterOnSphere(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights,
  const MoebiusCenteringOptions& options = {}, const Progress& progress = {});

} // namespace shape
