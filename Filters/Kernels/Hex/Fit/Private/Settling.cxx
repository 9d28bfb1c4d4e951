#include "Hex/Fit/Private/Settling.h"

#include "Distance/HausdorffDistance.h"
#include "Hex/Optimize/HexOptimization.h"
#include "Quality/ScaledJacobian.h"

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
  optimization.RaiseTo = options.RaisedTo;
  optimization.RaiseAgainFrom = options.RaisedFrom;
  optimization.Bad = std::min(optimization.Bad, options.RaisedTo + BadAbove);
  OptimizeHexahedra(
    mesh, constraint, optimization, progress.Part(0.15, 1.0, "optimizing the hexahedra"));
}

void Judge(HexFit& fit)
{
  const Eigen::VectorXd quality = ComputeScaledJacobians(fit.Solid);
  fit.MinimumScaledJacobian = quality.minCoeff();
  fit.MeanScaledJacobian = quality.mean();
  fit.Inverted = static_cast<int>((quality.array() <= 0.0).count());
}

void Measure(HexFit& fit, const Surface& surface, const Progress& progress)
{
  fit.Distance = ComputeHausdorffDistance(
    surface, { fit.Solid.Points, SplitQuads(FindFittedQuads(fit)) }, progress)
                   .Larger();
}

Eigen::MatrixXi FindFittedQuads(const HexFit& fit)
{
  if (fit.QuadRegions.size() == 0)
  {
    return fit.Quads;
  }
  Eigen::MatrixXi quads(fit.QuadRegions.rows(), 4);
  Eigen::Index row = fit.Quads.rows();
  quads.topRows(row) = fit.Quads;
  for (const Eigen::MatrixXi& interface : fit.Interfaces)
  {
    quads.middleRows(row, interface.rows()) = interface;
    row += interface.rows();
  }
  return quads;
}

} // namespace shape
