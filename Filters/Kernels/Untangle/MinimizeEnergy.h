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

/// Restricts the motion of points that are not free.
class PointConstraint
{
public:
  virtual ~PointConstraint() = default;
  /// Returns the number of directions in which a point may move, at any position: 3 if it is free.
  virtual int Freedom(int point) const = 0;
  virtual PointDirections Directions(int point, const Eigen::RowVector3d& position) const = 0;
  /// Returns the position allowed for the point that is closest to `position`.
  virtual Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const = 0;
};

/// Simplices to be made positive, or better shaped, by moving some of their points.
struct SimplexPatch
{
  std::vector<ReferenceSimplex> Simplices;
  std::vector<int> FreePoints; ///< the points that may move; each belongs to a simplex
};

struct PatchOptions
{
  int MaximumSteps = 100;    ///< maximum number of Newton steps
  int FurtherSteps = 3;      ///< number of steps after every simplex is positive
  double LeastGain = 1e-3;   ///< relative gain of energy below which further steps end
  double FirstEpsilon = 1.0; ///< initial epsilon if some simplices are not positive
  /// Whether to start from the minimiser of the sum of |J|^2 if its energy is lower. Without fixed
  /// points this minimiser would collapse to a point.
  bool FromSmoothest = true;
};

struct PatchResult
{
  int Steps = 0;
  int Negative = 0; ///< number of simplices that are not positive, by exact predicates
  double EnergyBefore = 0.0, EnergyAfter = 0.0; ///< means at the last epsilon; 1 is the minimum
};

/**
 * Minimises the regularised elliptic energy of a patch by Newton's method, with a positive
 * semi-definite second derivative (NewtonSystem) and a line search.
 *
 * epsilon follows the minimum determinant by eq. 7 of the paper cited at EllipticEnergy. The paper
 * proves that all determinants become positive if such positions exist and the energy can be
 * lowered enough. If the minimiser of the sum of |J|^2 has less energy than the given positions,
 * the iteration starts there.
 *
 * points (n x 3): those of patch.FreePoints are moved, subject to `constraint` if it is not null. A
 * step is one library call that cannot be interrupted. Throws Aborted.
 */
PatchResult MinimizeEnergy(Eigen::MatrixXd& points, const SimplexPatch& patch,
  const PointConstraint* constraint, const PatchOptions& options, const Progress& progress = {});

/// A regularised elliptic energy as a function of positions (columns), for MinimizeEnergy.
class EnergyProblem
{
public:
  virtual ~EnergyProblem() = default;

  /// Returns the number of simplices that are not positive, by exact predicates.
  virtual int CountNegative(const Eigen::Matrix3Xd& x) const = 0;

  struct State
  {
    double Energy = 0.0;
    double MinimumDeterminant = std::numeric_limits<double>::max();
  };

  virtual State Evaluate(const Eigen::Matrix3Xd& x, double epsilon) const = 0;

  /// The Newton direction (3 x number of movable points), and its initial rate of energy decrease.
  struct Descent
  {
    Eigen::Matrix3Xd Direction;
    double Slope = 0.0;
  };

  virtual Descent NewtonDirection(const Eigen::Matrix3Xd& x, double epsilon) = 0;

  virtual void Move(Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& direction, double step) const = 0;
};

/// The same for positions x and an energy that the caller provides.
PatchResult MinimizeEnergy(Eigen::Matrix3Xd& x, EnergyProblem& problem, const PatchOptions& options,
  const Progress& progress);

} // namespace shape
