#include "Laplacian/Private/TuftedCover.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace shape
{
namespace
{

/// Calls visit(begin, end) with the indices of the half-edges of each edge.
template <typename Visit>
void ForEachEdge(const std::vector<HalfEdge>& sorted, const Visit& visit)
{
  for (std::size_t begin = 0, end = 0; begin < sorted.size(); begin = end)
  {
    while (end < sorted.size() && sorted[end].Low() == sorted[begin].Low() &&
      sorted[end].High() == sorted[begin].High())
    {
      ++end;
    }
    visit(begin, end);
  }
}

/// Returns the angle of a triangle around one of its edges. x, y: a basis of the plane across the
/// edge.
double FindAngle(
  const Mesh& mesh, const HalfEdge& side, const Eigen::RowVector3d& x, const Eigen::RowVector3d& y)
{
  const Eigen::RowVector3d into =
    mesh.Points.row(mesh.Triangles(side.Triangle, (side.Corner + 2) % 3)) -
    mesh.Points.row(side.Low());
  return std::atan2(into.dot(y), into.dot(x));
}

} // namespace

GluedTriangles BuildTuftedCover(const Mesh& mesh)
{
  const auto count = static_cast<int>(mesh.Triangles.rows());
  GluedTriangles cover{ Eigen::MatrixXi(2 * count, 3), std::vector<int>(6 * count) };
  cover.Triangles.topRows(count) = mesh.Triangles;
  cover.Triangles.bottomRows(count) << mesh.Triangles.col(0), mesh.Triangles.col(2),
    mesh.Triangles.col(1);
  const std::vector<HalfEdge> sorted = SortHalfEdges(mesh.Triangles, mesh.Points.rows());
  ForEachEdge(sorted,
    [&](std::size_t begin, std::size_t end)
    {
      const Eigen::RowVector3d along =
        mesh.Points.row(sorted[begin].High()) - mesh.Points.row(sorted[begin].Low());
      const bool hasLength = along.squaredNorm() > 0.0;
      const Eigen::RowVector3d x =
        hasLength ? Eigen::RowVector3d(along.unitOrthogonal()) : Eigen::RowVector3d::UnitX();
      const Eigen::RowVector3d y = along.normalized().cross(x);
      std::vector<std::pair<double, const HalfEdge*>> around;
      for (std::size_t i = begin; i < end; ++i)
      {
        around.emplace_back(FindAngle(mesh, sorted[i], x, y), &sorted[i]);
      }
      std::stable_sort(around.begin(), around.end(),
        [](const auto& a, const auto& b) { return a.first < b.first; });
      // Seen along the edge, the copy that runs up the edge faces the larger angles. Corner k of a
      // triangle is corner 0, 2 or 1 of its other copy, so the edge from corner k to k + 1 runs
      // from corner 2 - k there.
      const auto copyOf = [&](const HalfEdge& side, bool up)
      {
        return (side.Begin < side.End) == up ? 3 * side.Triangle + side.Corner
                                             : 3 * (count + side.Triangle) + 2 - side.Corner;
      };
      for (std::size_t i = 0; i < around.size(); ++i)
      {
        const int facing = copyOf(*around[i].second, true);
        const int back = copyOf(*around[(i + 1) % around.size()].second, false);
        cover.Twins[facing] = back;
        cover.Twins[back] = facing;
      }
    });
  return cover;
}

bool AreEdgesManifold(const std::vector<HalfEdge>& sorted)
{
  bool isManifold = true;
  ForEachEdge(sorted,
    [&](std::size_t begin, std::size_t end)
    {
      isManifold &=
        end - begin == 1 || (end - begin == 2 && sorted[begin].Begin != sorted[begin + 1].Begin);
    });
  return isManifold;
}

} // namespace shape
