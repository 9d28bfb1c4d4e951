#pragma once

#include "Base/Progress.h"
#include "Untangle/SimplexPatch.h"

#include <Eigen/Core>

#include <limits>

namespace shape
{

/// The regularised elliptic energy as a function of places (columns), for MinimizeEnergy.
class EnergyProblem
{
public:
  virtual ~EnergyProblem() = default;

  /// Simplices that are not positive, told exactly.
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

/// Lowers it as MinimizeEnergy does.
PatchResult MinimizeEnergy(Eigen::Matrix3Xd& x, EnergyProblem& problem, const PatchOptions& options,
  const Progress& progress);

} // namespace shape
