#pragma once

#include "Base/Progress.h"
#include "Untangle/EllipticEnergy.h"

#include <Eigen/Core>

#include <limits>
#include <vector>

namespace shape
{

/// Directions in which a point may move: orthonormal columns, none to three.
using PointDirections = Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3>;

/// Where points that are not free may go.
class PointConstraint
{
public:
  virtual ~PointConstraint() = default;
  /// How many directions a point has, wherever it is: 3 if it is free.
  virtual int Freedom(int point) const = 0;
  virtual PointDirections Directions(int point, const Eigen::RowVector3d& position) const = 0;
  /// The position closest to `position` that the point may have.
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
  double FirstEpsilon = 1.0; ///< if some are not positive
  /// Whether to start from the minimiser of the sum of |J|^2 if that is better; without fixed
  /// points it would collapse.
  bool FromSmoothest = true;
};

struct PatchResult
{
  int Steps = 0;
  int Negative = 0; ///< simplices that are not positive, by exact predicates
  double EnergyBefore = 0.0, EnergyAfter = 0.0; ///< means at the last epsilon; 1 is the minimum
};

/**
 * Minimises the regularised elliptic energy of a patch by Newton's method with a positive
 * semi-definite second derivative (NewtonSystem) and a line search; epsilon follows the minimum
 * determinant by the rule that the paper proves to end with all determinants positive, if there are
 * such positions and the energy can be lowered enough (eq. 7 of the paper of EllipticEnergy). If
 * the minimiser of the sum of |J|^2 has less energy than the given positions, it starts from that.
 *
 * points (n x 3): those of patch.FreePoints are moved, along `constraint` if there is one. A step
 * is one library call that cannot be interrupted. Throws Aborted.
 */
PatchResult MinimizeEnergy(Eigen::MatrixXd& points, const SimplexPatch& patch,
  const PointConstraint* constraint, const PatchOptions& options, const Progress& progress = {});

/// The regularised elliptic energy as a function of positions (columns), for MinimizeEnergy.
class EnergyProblem
{
public:
  virtual ~EnergyProblem() = default;

  /// Simplices that are not positive, by exact predicates.
  virtual int CountNegative(const Eigen::Matrix3Xd& x) const = 0;

  struct State
  {
    double Energy = 0.0;
    double MinimumDeterminant = std::numeric_limits<double>::max();
  };

  virtual State Evaluate(const Eigen::Matrix3Xd& x, double epsilon) const = 0;

  /// The Newton direction (3 x points that may move) and by how much it lowers the energy at first.
  struct Descent
  {
    Eigen::Matrix3Xd Direction;
    double Slope = 0.0;
  };

  virtual Descent NewtonDirection(const Eigen::Matrix3Xd& x, double epsilon) = 0;

  virtual void Move(Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& direction, double step) const = 0;
};

/// The same for positions x and an energy of the caller's.
PatchResult MinimizeEnergy(Eigen::Matrix3Xd& x, EnergyProblem& problem, const PatchOptions& options,
  const Progress& progress);

} // namespace shape
