#include "Transfer/PreciseArrays.h"

#include "Mesh/Extent.h"
#include "Mesh/Provenance.h"
#include "Mesh/Topology.h"

#include <cmath>
#include <functional>
#include <vector>

namespace shape
{

namespace
{

constexpr double SingleRounding = 1e-6; ///< the arrays may have been stored in single precision

/// Throws if a point is invalid: "the Input has `what` at 3 points (first at point 7); give ...".
template <typename Error>
void RequireAll(Eigen::Index points, const std::function<bool(Eigen::Index)>& isSound,
  const std::string& pointsName, const std::string& what, const std::string& targetName)
{
  int count = 0;
  Eigen::Index first = 0;
  for (Eigen::Index i = 0; i < points; ++i)
  {
    if (!isSound(i))
    {
      first = count++ == 0 ? i : first;
    }
  }
  if (count > 0)
  {
    throw Error(pointsName + " has " + what + " at " + std::to_string(count) +
      (count == 1 ? " point" : " points") + " (first at point " + std::to_string(first) +
      "); give the surface that the map was made for as " + targetName +
      ", or remove TargetCell with Pass Arrays to use the closest points");
  }
}

} // namespace

SurfacePoints RequirePreciseMap(const PreciseArrays& arrays, const NumberedSurface& target,
  double tolerance, const std::string& pointsName, const std::string& targetName)
{
  const Eigen::Index n = arrays.TargetCell.size();
  RequireFinite(arrays.TargetCell, "TargetCell of " + pointsName);
  RequireFinite(arrays.TargetBarycentric, "TargetBarycentric of " + pointsName);
  RequireFinite(arrays.TargetPosition, "the map array of " + pointsName);
  const double begin = target.First;
  const double end = begin + static_cast<double>(target.Surface.Triangles.rows());
  RequireAll<InvalidInput>(
    n,
    [&](Eigen::Index i)
    {
      const auto weights = arrays.TargetBarycentric.row(i);
      return weights.minCoeff() >= -SingleRounding &&
        std::abs(weights.sum() - 1.0) < SingleRounding;
    },
    pointsName, "a TargetBarycentric that is negative or does not sum to 1", targetName);
  RequireAll<MapOfAnotherSurface>(
    n,
    [&](Eigen::Index i)
    {
      const double cell = arrays.TargetCell(i);
      return cell >= begin && cell < end && cell == std::floor(cell);
    },
    pointsName,
    "a TargetCell that is no triangle of " + targetName + ", whose triangles are numbered " +
      std::to_string(target.First) + " to " + std::to_string(static_cast<long long>(end) - 1) + ",",
    targetName);
  SurfacePoints map{ (arrays.TargetCell.array() - begin).cast<int>(), arrays.TargetBarycentric };
  // The position that the cell and the weights give must be the stored one; else the map was made
  // for another surface.
  const Eigen::VectorXd apart =
    (PullBack(map, target.Surface.Triangles, target.Surface.Points) - arrays.TargetPosition)
      .rowwise()
      .norm();
  // Single precision rounds relative to the coordinates, not to the size of the shape.
  const double farthest = tolerance * ComputeLongestBoxEdge(target.Surface) +
    SingleRounding * target.Surface.Points.cwiseAbs().maxCoeff();
  RequireAll<MapOfAnotherSurface>(
    n, [&](Eigen::Index i) { return apart(i) <= farthest; }, pointsName,
    "a TargetCell that lies elsewhere on " + targetName + " than its TargetPosition says,",
    targetName);
  return map;
}

TransferWeights LocateOnTriangles(const SurfacePoints& map, const NumberedSurface& giver)
{
  ProvenanceWriter points(giver.Surface.Points.rows());
  for (Eigen::Index i = 0; i < map.Triangles.size(); ++i)
  {
    points.AddOnTriangle(giver.Surface.Triangles.row(map.Triangles(i)), map.Barycentrics.row(i));
  }
  return { points.Finish({}).Weights, giver.Cells(map.Triangles),
    Eigen::VectorXi::Zero(map.Triangles.size()) };
}

} // namespace shape
