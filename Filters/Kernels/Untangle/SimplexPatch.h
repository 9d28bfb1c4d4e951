#pragma once

#include "Base/Progress.h"
#include "Untangle/EllipticEnergy.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Directions in which a point may move: orthonormal columns, none to three.
using PointDirections = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;

/// Where points that are not wholly free may go.
class PointConstraint
{
public:
  virtual ~PointConstraint() = default;
  /// How many directions a point has, wherever it is: 3 where it is free.
  virtual int Freedom(int point) const = 0;
  virtual PointDirections Directions(int point, const Eigen::RowVector3d& position) const = 0;
  /// The place closest to `place` where the point may be.
  virtual Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const = 0;
};

/// Simplices that are made positive, or better, by moving some of their points.
struct SimplexPatch
{
  std::vector<ReferenceSimplex> Simplices;
  std::vector<int> FreePoints; ///< each in a simplex
};

struct PatchOptions
{
  int MaximumSteps = 100;    ///< of Newton's method
  int FurtherSteps = 3;      ///< once every simplex is positive
  double LeastGain = 1e-3;   ///< the share of the energy below which further steps end
  double FirstEpsilon = 1.0; ///< where some are not positive
  /// Whether to start from the minimiser of the sum of |J|^2 where that is better: not where it
  /// would collapse, for want of fixed points.
  bool FromSmoothest = true;
};

struct PatchResult
{
  int Steps = 0;
  int Negative = 0;                             ///< simplices that are not positive, told exactly
  double EnergyBefore = 0.0, EnergyAfter = 0.0; ///< means at the last epsilon; 1 is the least
};

/**
 * Lowers the regularised elliptic energy of a patch by Newton's method with a positive
 * semi-definite second derivative, the sparse Cholesky factorisation and a line search; epsilon
 * follows the least determinant by the rule that the paper proves to end with all determinants
 * positive, if there is such a place and the energy can be lowered enough (eq. 7 there). Where the
 * places are so bad that the minimiser of the sum of |J|^2 has less energy, it starts from that.
 *
 * points (n x 3): those of patch.FreePoints are changed, along `constraint`, where there is one. A
 * step is one library call that cannot be interrupted. Throws Aborted.
 */
PatchResult MinimizeEnergy(Eigen::MatrixXd& points, const SimplexPatch& patch,
  const PointConstraint* constraint, const PatchOptions& options, const Progress& progress = {});

} // namespace shape
