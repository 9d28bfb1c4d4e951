#pragma once

#include "Base/Progress.h"
#include "Untangle/EllipticEnergy.h"

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace shape
{

/// The directions in which a point may move: none to three orthonormal columns.
using PointDirections = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;

/// Restricts the motion of points that are not free.
class PointConstraint
{
public:
  virtual ~PointConstraint() = default;
  /// Returns the number of directions in which a point may move: 0 if it is fixed, 3 if it is free.
  /// The number is the same at every position.
  virtual int Freedom(int point) const = 0;
  /// Returns the directions in which a point may move from `position`. The point must be neither
  /// fixed nor free.
  virtual PointDirections Directions(int point, const Eigen::RowVector3d& position) const = 0;
  /// Returns, among the positions allowed for the point, the one closest to `position`. The point
  /// must not be free.
  virtual Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const = 0;
};

/// Simplices that are made positive and better shaped by moving some of their points.
struct SimplexPatch
{
  std::vector<ReferenceSimplex> Simplices;
  std::vector<int> FreePoints; ///< the points that may move; each is a corner of a simplex
};

struct PatchOptions
{
  int MaximumSteps = 100; ///< maximum number of Newton steps
  int FurtherSteps = 3;   ///< number of steps that follow once all simplices are positive
  /// The further steps end early when one lowers the energy by less than this fraction of it.
  double LeastGain = 1e-3;
  /// The iteration stalls, and ends, after this many steps without progress while a simplex is not
  /// positive. A step makes progress if it lowers the number of such simplices, or raises the
  /// minimum determinant by 1 % of its amount.
  int Patience = std::numeric_limits<int>::max();
  double FirstEpsilon = 1.0; ///< the initial epsilon if a simplex is not positive
  /// Whether to start from the minimiser of the sum of |J|^2 if a simplex is not positive and the
  /// minimiser has less energy. Set it to false if no point is fixed, because all points of this
  /// minimiser then coincide.
  bool FromSmoothest = true;
};

struct PatchResult
{
  int Steps = 0;
  int Negative = 0; ///< number of simplices that are not positive (exact predicates)
  double EnergyBefore = 0.0, EnergyAfter = 0.0; ///< mean energies at the first and last epsilon
};

/**
 * Minimises the regularised elliptic energy of a patch. Newton's method is used with a positive
 * semi-definite second derivative (NewtonSystem) and a line search.
 *
 * epsilon depends on the minimum determinant by eq. 7 of the paper cited at EllipticEnergy. The
 * paper proves that all determinants become positive if such positions exist and each step lowers
 * the energy enough. The iteration may start from other positions than the given ones
 * (FromSmoothest).
 *
 * points (n x 3): the positions of all points. The points in patch.FreePoints are moved, subject to
 * `constraint` unless it is null. Throws Aborted; no point has moved then.
 */
PatchResult MinimizeEnergy(Eigen::MatrixXd& points, const SimplexPatch& patch,
  const PointConstraint* constraint, const PatchOptions& options, const Progress& progress = {});

/// A regularised elliptic energy as a function of positions x (columns), for MinimizeEnergy.
class EnergyProblem
{
public:
  virtual ~EnergyProblem() = default;

  /// Returns the number of simplices that are not positive (exact predicates).
  virtual int CountNegative(const Eigen::Matrix3Xd& x) const = 0;

  struct State
  {
    double Energy = 0.0;
    double MinimumDeterminant = std::numeric_limits<double>::max();
  };

  virtual State Evaluate(const Eigen::Matrix3Xd& x, double epsilon) const = 0;

  /// The Newton direction (3 x number of movable points), and the rate at which the energy
  /// initially falls along it.
  struct Descent
  {
    Eigen::Matrix3Xd Direction;
    double Slope = 0.0;
  };

  virtual Descent NewtonDirection(
    const Eigen::Matrix3Xd& x, double epsilon, const Progress& progress) = 0;

  /// Moves x by `step` times `direction`, within the constraints of the energy.
  virtual void Move(Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& direction, double step) const = 0;
};

/// Minimises an energy that the caller provides. x (columns): the positions, which are moved.
/// Throws Aborted.
PatchResult MinimizeEnergy(Eigen::Matrix3Xd& x, EnergyProblem& problem, const PatchOptions& options,
  const Progress& progress);

} // namespace shape
