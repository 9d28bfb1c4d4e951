#include "Hex/Fit/Private/Settling.h"

#include "Hex/Optimize/HexOptimization.h"

#include <algorithm>

namespace shape
{

void Settle(HexMesh& mesh, const PointConstraint& constraint,
  const std::function<void(Eigen::MatrixXd& points)>& spread, const SettlingOptions& options,
  const Progress& progress)
{
  SmoothHexahedra(
    mesh, constraint, options.Smoothings, progress.Part(0.0, 0.1, "smoothing the hexahedra"));
  // Points of layers lie at the points that they copy: the layers get their thickness here.
  spread(mesh.Points);
  SmoothInverted(mesh, constraint, progress.Part(0.1, 0.15));
  HexOptimizationOptions optimization;
  optimization.Sweeps = options.Sweeps;
  optimization.SweepFirst = options.SweepFirst;
  optimization.UntanglingSteps = options.UntanglingSteps;
  optimization.RaiseTo = options.RaisedTo;
  optimization.RaiseAgainFrom = options.RaisedFrom;
  optimization.Bad = std::min(optimization.Bad, options.RaisedTo + BadAbove);
  OptimizeHexahedra(
    mesh, constraint, optimization, progress.Part(0.15, 1.0, "optimizing the hexahedra"));
}

} // namespace shape
