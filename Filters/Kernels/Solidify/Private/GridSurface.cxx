#include "Solidify/Private/GridSurface.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/Surface.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"
#include "Solidify/Private/JoinedSoup.h"
#include "Solidify/SurfaceDefects.h"

#include <vector>

namespace shape
{

double ChooseDetailSize(const Mesh& surface, double size)
{
  constexpr double share = 1.0 / 128.0;
  return size > 0.0 ? size : share * ComputeLongestBoxEdge(surface);
}

MendedSurface AdoptGridSurface(const Mesh& made, double spacing, const Mesh& input, double smallest,
  const std::string& name, const Progress& progress)
{
  std::vector<Mesh> pieces;
  int removed = 0;
  for (Mesh& piece : SplitComponents(made))
  {
    if (ComputeLongestBoxEdge(piece.Points) < smallest)
    {
      ++removed;
      continue;
    }
    pieces.push_back(std::move(piece));
  }
  if (pieces.empty())
  {
    throw InvalidInput(name +
      " of the surface is empty: its triangles enclose nothing larger than " +
      "DetailSize and SmallestPiece (" + std::to_string(removed) + " pieces are smaller); lower " +
      "these, or choose the method Wrap");
  }
  MendedSurface result;
  result.Surface = JoinMeshes(pieces);
  const SurfaceDefects defects =
    FindSurfaceDefects(result.Surface, {}, progress.Part(0.0, 0.7, "checking the solid"));
  if (!defects.Defects.empty())
  {
    throw InvalidInput(name + " of the surface has " + std::to_string(defects.Defects.size()) +
      " defects; change DetailSize");
  }
  result.GridSpacing = spacing;
  result.RemovedPieces = removed;
  result.RemovedTriangles = static_cast<int>(input.Triangles.rows());
  const Eigen::Index points = result.Surface.Points.rows();
  Eigen::MatrixXd positions(points + result.Surface.Triangles.rows(), 3);
  positions << result.Surface.Points, ComputeCentroids(result.Surface);
  const JoinedSoup soup = JoinSoup(input, 0.0, {}); // without what has no position or no area
  const ClosestPoints nearest =
    SurfaceLocator(soup.Surface).Find(positions, progress.Part(0.7, 1.0, "carrying data"));
  ProvenanceWriter writer(input.Points.rows());
  writer.Reserve(points);
  for (Eigen::Index i = 0; i < points; ++i)
  {
    writer.AddOnTriangle(
      soup.Surface.Triangles.row(nearest.Triangles(i)), nearest.Barycentrics.row(i));
  }
  result.Provenance = writer.Finish(nearest.Triangles.tail(result.Surface.Triangles.rows())
                                      .unaryExpr([&](int t) { return soup.Triangles[t]; }));
  result.Origin = Eigen::VectorXi::Constant(
    result.Surface.Triangles.rows(), static_cast<int>(TriangleOrigin::Made));
  return result;
}

} // namespace shape
