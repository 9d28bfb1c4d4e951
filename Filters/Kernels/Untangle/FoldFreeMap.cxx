#include "Untangle/FoldFreeMap.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Search/ClosestPoint.h"
#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/SolidCells.h"

#include <cstddef>
#include <vector>

namespace shape
{

namespace
{

constexpr double OnSurface = 1e-6;

} // namespace

UntangleResult ComputeFoldFreeMap(const Cells& domain, const Eigen::MatrixXd& moved,
  const Mesh& boundary, const Eigen::MatrixXd& targets, const Progress& progress)
{
  RequireFinite(domain.Points, "the Domain");
  SolidCells solid(domain, {}, "the Domain", progress.Part(0.0, 0.0));
  std::vector<int> outer;
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    if (solid.OnBoundary(point))
    {
      outer.push_back(point);
    }
  }
  const ClosestPoints closest =
    SurfaceLocator(boundary).Find(domain.Points(outer, Eigen::all), progress.Part(0.0, 0.1));
  const Eigen::MatrixXd images = PullBack(closest, boundary.Triangles, targets);
  Cells carried = domain;
  carried.Points = moved;
  // The user asks for the cells that the map inverts, not for those left by the exact boundary.
  solid.Points = moved;
  const auto invertedBefore = static_cast<int>(FindInverted(solid).size());
  const double farthest = OnSurface * ComputeLongestBoxEdge(boundary);
  for (std::size_t i = 0; i < outer.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    if (closest.Distances(row) <= farthest)
    {
      // At a point of the surface exactly its image.
      int corner = 0;
      const bool atCorner = closest.Barycentrics.row(row).maxCoeff(&corner) > 1.0 - 1e-9;
      carried.Points.row(outer[i]) = atCorner
        ? targets.row(boundary.Triangles(closest.Triangles(row), corner))
        : images.row(row);
    }
  }
  UntangleResult result = Untangle(carried, domain.Points, {}, progress.Part(0.1, 1.0));
  result.InvertedBefore = invertedBefore;
  return result;
}

} // namespace shape
