#include "Geometry/SheetRepair.h"

#include "Base/DisjointSets.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <numeric>
#include <set>
#include <utility>

namespace shape
{
namespace
{

using Edge = std::vector<const HalfEdge*>; ///< the half-edges of one edge

/// Joins the ends of edges without length. Returns the first of the joined points for each point.
std::vector<int> JoinShortEdges(const Mesh& mesh)
{
  constexpr double share = 1e-12;
  std::vector<std::pair<int, int>> joined;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(mesh, t);
    Eigen::Vector3d lengths;
    for (int k = 0; k < 3; ++k)
    {
      lengths(k) = (corners.row((k + 1) % 3) - corners.row(k)).norm();
    }
    for (int k = 0; k < 3; ++k)
    {
      const int a = mesh.Triangles(t, k), b = mesh.Triangles(t, (k + 1) % 3);
      if (a != b && lengths(k) <= share * lengths.maxCoeff())
      {
        joined.emplace_back(a, b);
      }
    }
  }
  std::vector<int> first(mesh.Points.rows());
  std::iota(first.begin(), first.end(), 0);
  if (joined.empty())
  {
    return first;
  }
  DisjointSets sets(static_cast<int>(first.size()));
  for (const auto& [a, b] : joined)
  {
    sets.Merge(a, b);
  }
  std::vector<int> firstOf(first.size(), -1);
  for (int point = 0; point < static_cast<int>(first.size()); ++point)
  {
    int& lowest = firstOf[sets.Find(point)];
    lowest = lowest == -1 ? point : lowest;
    first[point] = lowest;
  }
  return first;
}

/// The corners of a triangle, the lowest first, in the same cyclic order.
std::array<int, 3> Turned(const Eigen::RowVector3i& corners)
{
  std::array<int, 3> turned = { corners(0), corners(1), corners(2) };
  std::rotate(turned.begin(), std::min_element(turned.begin(), turned.end()), turned.end());
  return turned;
}

/// Removes triangles without three points and repeated ones.
void RemoveTriangles(const Eigen::MatrixXi& triangles, RepairedSheets& repaired)
{
  std::vector<std::pair<std::array<int, 3>, int>> sorted;
  std::vector<char> isKept(triangles.rows(), 1);
  for (int t = 0; t < triangles.rows(); ++t)
  {
    const auto corners = triangles.row(t);
    if (corners(0) == corners(1) || corners(1) == corners(2) || corners(2) == corners(0))
    {
      isKept[t] = 0;
      ++repaired.DegenerateTriangles;
    }
    else
    {
      sorted.emplace_back(Turned(corners), t);
    }
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
  {
    if (sorted[i].first == sorted[i - 1].first)
    {
      isKept[sorted[i].second] = 0;
      ++repaired.DuplicateTriangles;
    }
  }
  for (int t = 0; t < triangles.rows(); ++t)
  {
    if (isKept[t])
    {
      repaired.Triangles.push_back(t);
    }
    else if (repaired.FirstRemoved == -1)
    {
      repaired.FirstRemoved = t;
    }
  }
  repaired.Surface.Triangles = triangles(repaired.Triangles, Eigen::all);
}

/// Chooses the triangles that stay connected at edges with three or more triangles.
class SheetSeparation
{
public:
  SheetSeparation(const Mesh& mesh, const std::vector<HalfEdge>& sorted)
    : Surface(mesh)
    , Sheets(static_cast<int>(mesh.Triangles.rows()))
  {
    for (std::size_t i = 0, end = 0; i < sorted.size(); i = end)
    {
      Edge edge;
      for (end = i; end < sorted.size() && sorted[end].Low() == sorted[i].Low() &&
           sorted[end].High() == sorted[i].High();
           ++end)
      {
        edge.push_back(&sorted[end]);
      }
      if (edge.size() == 2)
      {
        this->Connected.emplace_back(edge[0], edge[1]);
        this->Sheets.Merge(edge[0]->Triangle, edge[1]->Triangle);
      }
      else if (edge.size() > 2)
      {
        this->NonManifold.push_back(std::move(edge));
      }
    }
    for (const Edge& edge : this->NonManifold)
    {
      this->Connect(edge);
    }
  }

  std::vector<Edge> NonManifold;
  /// Half-edges of one edge whose triangles are connected.
  std::vector<std::pair<const HalfEdge*, const HalfEdge*>> Connected;

private:
  bool AreOpposite(const HalfEdge* a, const HalfEdge* b) const { return a->Begin != b->Begin; }

  void Connect(const Edge& edge)
  {
    std::map<int, Edge> bySheet;
    for (const HalfEdge* side : edge)
    {
      bySheet[this->Sheets.Find(side->Triangle)].push_back(side);
    }
    Edge left;
    for (const HalfEdge* side : edge)
    {
      const Edge& same = bySheet[this->Sheets.Find(side->Triangle)];
      if (same.size() != 2 || !this->AreOpposite(same[0], same[1]))
      {
        left.push_back(side);
      }
      else if (side == same[0])
      {
        this->Connected.emplace_back(same[0], same[1]);
      }
    }
    if (left.size() == 3)
    {
      this->ConnectStraightest(left);
    }
    else if (left.size() > 1)
    {
      this->ConnectWedges(left);
    }
  }

  /// Returns the direction from an edge into a triangle, perpendicular to the edge.
  Eigen::RowVector3d FindDirection(const HalfEdge& side) const
  {
    const auto position = [&](int point) { return this->Surface.Points.row(point); };
    const Eigen::RowVector3d along = position(side.High()) - position(side.Low());
    const int third = this->Surface.Triangles(side.Triangle, (side.Corner + 2) % 3);
    const Eigen::RowVector3d into = position(third) - position(side.Low());
    return (into - into.dot(along) / along.squaredNorm() * along).normalized();
  }

  void ConnectStraightest(const Edge& sides)
  {
    double straightest = 2.0;
    std::pair<const HalfEdge*, const HalfEdge*> best = { nullptr, nullptr };
    for (std::size_t i = 0; i < sides.size(); ++i)
    {
      for (std::size_t j = i + 1; j < sides.size(); ++j)
      {
        const double cosine = this->FindDirection(*sides[i]).dot(this->FindDirection(*sides[j]));
        if (this->AreOpposite(sides[i], sides[j]) && cosine < straightest)
        {
          straightest = cosine;
          best = { sides[i], sides[j] };
        }
      }
    }
    if (best.first)
    {
      this->Connected.push_back(best);
    }
  }

  /// Around the edge, seen from its lower point, the solid follows a triangle that runs down the
  /// edge, and ends at one that runs up.
  void ConnectWedges(const Edge& sides)
  {
    const HalfEdge& first = *sides.front();
    const Eigen::RowVector3d axis =
      (this->Surface.Points.row(first.High()) - this->Surface.Points.row(first.Low())).normalized();
    const Eigen::RowVector3d x = this->FindDirection(first);
    const Eigen::RowVector3d y = axis.cross(x);
    std::vector<std::pair<double, const HalfEdge*>> around;
    for (const HalfEdge* side : sides)
    {
      const Eigen::RowVector3d direction = this->FindDirection(*side);
      around.emplace_back(std::atan2(direction.dot(y), direction.dot(x)), side);
    }
    std::stable_sort(
      around.begin(), around.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (std::size_t i = 0; i < around.size(); ++i)
    {
      const HalfEdge* begin = around[i].second;
      const HalfEdge* end = around[(i + 1) % around.size()].second;
      if (begin->Begin == begin->High() && end->Begin == end->Low())
      {
        this->Connected.emplace_back(begin, end);
      }
    }
  }

  const Mesh& Surface;
  DisjointSets Sheets; ///< of triangles
};

/// Finds the triangles that are not part of a fin, by the pieces that the sheets form.
std::vector<int> FindWithoutFins(const Mesh& mesh, const SheetSeparation& sheets)
{
  const auto count = static_cast<int>(mesh.Triangles.rows());
  DisjointSets pieces(count);
  std::set<const HalfEdge*> connected;
  for (const auto& [a, b] : sheets.Connected)
  {
    pieces.Merge(a->Triangle, b->Triangle);
    connected.insert({ a, b });
  }
  const Eigen::VectorXd areas = 0.5 * ComputeAreaVectors(mesh).rowwise().norm();
  Eigen::VectorXd areaOf = Eigen::VectorXd::Zero(count);
  std::vector<char> isOnEdge(mesh.Points.rows(), 0), isFin(count, 0);
  for (const Edge& edge : sheets.NonManifold)
  {
    isOnEdge[edge.front()->Low()] = isOnEdge[edge.front()->High()] = 1;
  }
  for (int t = 0; t < count; ++t)
  {
    areaOf(pieces.Find(t)) += areas(t);
  }
  constexpr double share = 0.01;
  for (const Edge& edge : sheets.NonManifold)
  {
    double largest = 0.0;
    for (const HalfEdge* side : edge)
    {
      largest = std::max(largest, areaOf(pieces.Find(side->Triangle)));
    }
    for (const HalfEdge* side : edge)
    {
      const int piece = pieces.Find(side->Triangle);
      isFin[piece] |= static_cast<char>(connected.count(side) == 0 && areaOf(piece) < largest &&
        areaOf(piece) <= share * areas.sum());
    }
  }
  for (int t = 0; t < count; ++t)
  {
    const auto corners = mesh.Triangles.row(t);
    if (!isOnEdge[corners(0)] && !isOnEdge[corners(1)] && !isOnEdge[corners(2)])
    {
      isFin[pieces.Find(t)] = 0;
    }
  }
  std::vector<int> kept;
  for (int t = 0; t < count; ++t)
  {
    if (!isFin[pieces.Find(t)])
    {
      kept.push_back(t);
    }
  }
  return kept;
}

void KeepTriangles(const std::vector<int>& kept, RepairedSheets& repaired)
{
  std::vector<int> triangles;
  std::size_t next = 0;
  for (int t = 0; t < static_cast<int>(repaired.Triangles.size()); ++t)
  {
    if (next < kept.size() && kept[next] == t)
    {
      triangles.push_back(repaired.Triangles[t]);
      ++next;
    }
    else if (repaired.FirstRemoved == -1 || repaired.Triangles[t] < repaired.FirstRemoved)
    {
      repaired.FirstRemoved = repaired.Triangles[t];
    }
  }
  repaired.FinTriangles =
    static_cast<int>(repaired.Triangles.size()) - static_cast<int>(kept.size());
  repaired.Triangles = std::move(triangles);
  repaired.Surface.Triangles = repaired.Surface.Triangles(kept, Eigen::all).eval();
}

/// Gives each fan of connected triangles a point of its own.
void SplitFans(const SheetSeparation& sheets, RepairedSheets& repaired)
{
  Eigen::MatrixXi& triangles = repaired.Surface.Triangles;
  DisjointSets fans(static_cast<int>(triangles.size()));
  const auto cornerOf = [&](const HalfEdge* side, int point)
  { return 3 * side->Triangle + (side->Begin == point ? side->Corner : (side->Corner + 1) % 3); };
  for (const auto& [a, b] : sheets.Connected)
  {
    fans.Merge(cornerOf(a, a->Begin), cornerOf(b, a->Begin));
    fans.Merge(cornerOf(a, a->End), cornerOf(b, a->End));
  }
  std::vector<int> firstFan(repaired.Points.size(), -1);
  std::map<int, int> copyOf; // from further fans to their points
  for (int t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int point = triangles(t, k), fan = fans.Find(3 * t + k);
      if (firstFan[point] == -1)
      {
        firstFan[point] = fan;
      }
      if (firstFan[point] == fan)
      {
        continue;
      }
      const auto [copy, isNew] = copyOf.insert({ fan, static_cast<int>(repaired.Points.size()) });
      if (isNew)
      {
        repaired.Points.push_back(point);
        repaired.FirstSplit = repaired.SplitPoints++ == 0 ? point : repaired.FirstSplit;
      }
      triangles(t, k) = copy->second;
    }
  }
}

} // namespace

RepairedSheets RepairSheets(const Mesh& mesh, const SheetRepairOptions& options)
{
  RepairedSheets repaired;
  repaired.Points.resize(mesh.Points.rows());
  std::iota(repaired.Points.begin(), repaired.Points.end(), 0);
  repaired.Representatives = JoinShortEdges(mesh);
  for (int point = 0; point < static_cast<int>(repaired.Representatives.size()); ++point)
  {
    repaired.JoinedPoints += repaired.Representatives[point] != point;
  }
  repaired.Surface.Points = mesh.Points;
  RemoveTriangles(
    mesh.Triangles.unaryExpr([&](int point) { return repaired.Representatives[point]; }).eval(),
    repaired);
  std::vector<HalfEdge> sorted = SortHalfEdges(repaired.Surface.Triangles, mesh.Points.rows());
  auto sheets = std::make_unique<SheetSeparation>(repaired.Surface, sorted);
  if (!sheets->NonManifold.empty())
  {
    repaired.NonManifoldEdges = static_cast<int>(sheets->NonManifold.size());
    repaired.FirstNonManifold = sheets->NonManifold.front().front()->Low();
    const std::vector<int> kept = FindWithoutFins(repaired.Surface, *sheets);
    if (kept.size() < repaired.Triangles.size())
    {
      KeepTriangles(kept, repaired);
      sorted = SortHalfEdges(repaired.Surface.Triangles, mesh.Points.rows());
      sheets = std::make_unique<SheetSeparation>(repaired.Surface, sorted);
    }
  }
  if (options.Separate)
  {
    SplitFans(*sheets, repaired);
  }
  else
  {
    repaired.SharedEdges = static_cast<int>(sheets->NonManifold.size());
  }
  repaired.Surface.Points = mesh.Points(repaired.Points, Eigen::all);
  return repaired;
}

} // namespace shape
