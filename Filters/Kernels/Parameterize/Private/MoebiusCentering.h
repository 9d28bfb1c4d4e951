#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

struct MoebiusCenteringOptions
{
  double Tolerance = 1e-13;    ///< the length of the mean at which it stops, in radii
  int MaximumIterations = 200; ///< Newton steps
};

struct MoebiusCenteringResult
{
  Eigen::MatrixXd Points;  ///< n x 3, on the unit sphere to rounding
  int Iterations = 0;      ///< Newton steps taken
  double MeanLength = 0.0; ///< distance of the weighted mean from the origin that is left
};

/**
 * The Moebius transform of the unit sphere, unique up to rotation, that brings the weighted mean of
 * the points to the origin: Baden, Crane & Kazhdan 2018, "Moebius Registration", algorithm 1, with
 * Newton steps held back if they do not shorten the mean. Each step is an inversion
 * p -> (1 - |c|^2) (p + c) / |p + c|^2 + c, which keeps orientation and turns nothing at the
 * centre.
 *
 * points: n x 3, of any length but zero (they are projected first). weights: n, not negative.
 * Throws InvalidInput if the sizes differ, a value is not finite, a weight is negative, a point
 * is at the origin, all weights are zero, or one point carries half of the weight or more (no
 * transform can centre that). Where rounding ends the descent before Tolerance, MeanLength says
 * where.
 */
MoebiusCenteringResult CenterOnSphere(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights,
  const MoebiusCenteringOptions& options = {}, const Progress& progress = {});

} // namespace shape
