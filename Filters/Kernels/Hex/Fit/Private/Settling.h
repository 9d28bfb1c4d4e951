#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

#include <functional>

namespace shape
{

/// If the worst scaled Jacobian is at least this, no further sweeps are spent on it.
inline constexpr double RaisedTo = 0.55;

struct SettlingOptions
{
  int Smoothings = 2;                ///< sweeps that smooth the positions first
  int Sweeps = 6;                    ///< see HexOptimizationOptions
  bool SweepFirst = false;           ///< see HexOptimizationOptions
  int UntanglingSteps = 40;          ///< see HexOptimizationOptions
  double RaisedFrom = 0.0;           ///< see HexFitOptions
  double RaisedTo = shape::RaisedTo; ///< the target for the minimum scaled Jacobian
};

/// Makes do with few sweeps: a single one at each sharpness, which comes before the untangling and
/// leaves it less to do, and none for the worst hexahedra unless they are very bad.
inline void SettleAsDraft(SettlingOptions& options)
{
  options.Sweeps = 1;
  options.SweepFirst = true;
  options.UntanglingSteps = 20;
  options.RaisedTo = 0.0;
}

/**
 * Moves the points of hexahedra whose layers have no thickness yet. They are smoothed, `spread`
 * gives layers their thickness, and OptimizeHexahedra repairs inverted hexahedra and raises the
 * worst.
 */
void Settle(HexMesh& mesh, const PointConstraint& constraint,
  const std::function<void(Eigen::MatrixXd& points)>& spread, const SettlingOptions& options,
  const Progress& progress);

} // namespace shape
