#include "Untangle/Private/PatchCollar.h"

#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/StarCollar.h"
#include "Untangle/Private/StarKernel.h"

#include <Eigen/Geometry>
#include <Eigen/SparseCholesky>
#include <Eigen/SparseCore>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr double Pi = 3.14159265358979323846;

/// A boundary triangle at a boundary point: its other corners, counter-clockwise as seen from
/// outside, and the inner point of its tetrahedron.
struct Sector
{
  int From, To, Apex;
};

/// The inner points around a boundary point v: the link of v without the boundary.
struct InnerLink
{
  std::vector<Sector> Sectors;            ///< counter-clockwise
  std::vector<std::vector<int>> Fans;     ///< after each sector, the points around the edge to To
                                          ///< that are opposite to no triangle
  std::vector<std::pair<int, int>> Edges; ///< between inner points of the link
};

int CountBoundaryPoints(const SolidCells& solid, int cell)
{
  const std::vector<int>& points = solid.PointsOf(cell);
  return static_cast<int>(std::count_if(
    points.begin(), points.end(), [&](int point) { return solid.OnBoundary(point); }));
}

/// Returns a face, turned so that the given corner comes first.
StarFace Turn(StarFace face, int corner)
{
  std::rotate(face.begin(), std::find(face.begin(), face.end(), corner), face.end());
  return face;
}

InnerLink FindInnerLink(const SolidCells& solid, int point)
{
  InnerLink link;
  std::map<int, Sector> sectors;
  std::map<std::pair<int, int>, int> steps;
  for (const int cell : solid.CellsOf(point))
  {
    const StarFace face = FindFaceOpposite(solid.PointsOf(cell), point);
    std::vector<int> boundary, inner;
    for (const int corner : face)
    {
      (solid.OnBoundary(corner) ? boundary : inner).push_back(corner);
    }
    if (boundary.size() == 2)
    {
      const StarFace turned = Turn(face, inner[0]);
      sectors[turned[1]] = { turned[1], turned[2], turned[0] };
    }
    else if (boundary.size() == 1)
    {
      const StarFace turned = Turn(face, boundary[0]);
      steps[{ turned[0], turned[2] }] = turned[1];
      link.Edges.emplace_back(turned[1], turned[2]);
    }
    else
    {
      for (int k = 0; k < 3; ++k)
      {
        link.Edges.emplace_back(face[k], face[(k + 1) % 3]);
      }
    }
  }
  const int first = sectors.begin()->first;
  for (int at = first;;)
  {
    const Sector sector = sectors.at(at);
    link.Sectors.push_back(sector);
    at = sector.To;
    const int last = sectors.at(at).Apex;
    std::vector<int> fan;
    for (int x = sector.Apex; x != last;)
    {
      x = steps.at({ at, x });
      if (x != last)
      {
        fan.push_back(x);
      }
    }
    link.Fans.push_back(std::move(fan));
    if (at == first)
    {
      break;
    }
  }
  return link;
}

/// Consecutive places of a point on the circle around a boundary point, as angles, and what has to
/// be split for the point to have none there.
struct Arc
{
  int Point;
  double First, Last;
  std::set<std::vector<int>> Simplices;
};

/// Splits tetrahedra and inner faces at boundary points so that each point of their inner link has
/// at most one arc or, if it has only one already, that the arc has no width. Returns whether there
/// is anything to split.
bool SplitArcs(
  SolidCells& solid, const std::map<int, std::vector<Arc>>& arcs, const Progress& progress)
{
  std::set<std::vector<int>> simplices;
  for (const auto& [point, around] : arcs)
  {
    std::map<int, int> counts;
    int most = 0;
    for (const Arc& arc : around)
    {
      most = std::max(most, ++counts[arc.Point]);
    }
    for (const Arc& arc : around)
    {
      if (most > 1 ? counts[arc.Point] > 1 : arc.Last > arc.First)
      {
        simplices.insert(arc.Simplices.begin(), arc.Simplices.end());
      }
    }
  }
  // Tetrahedra first, whose faces then still exist.
  for (const std::size_t size : { 4U, 3U })
  {
    for (const std::vector<int>& simplex : simplices)
    {
      progress(0.0);
      if (simplex.size() == size)
      {
        solid.Split(simplex);
      }
    }
  }
  return !simplices.empty();
}

/// Where the inner link of a boundary point is put: in coordinates of the tangential plane, whose
/// unit is the distance of the point from the centre.
class LinkLayout
{
public:
  LinkLayout(const SolidCells& solid, int point, const Eigen::RowVector3d& centre)
    : Outward((solid.Points.row(point) - centre).normalized())
  {
    this->Across.row(0) = this->Outward.unitOrthogonal();
    this->Across.row(1) = this->Outward.cross(this->Across.row(0));
    const InnerLink link = FindInnerLink(solid, point);
    this->Radius = 0.25;
    for (const Sector& sector : link.Sectors)
    {
      const Eigen::RowVector2d a = this->Project(solid.Points.row(sector.From) - centre),
                               b = this->Project(solid.Points.row(sector.To) - centre);
      const Eigen::RowVector2d side = b - a;
      const double share = std::clamp(-a.dot(side) / side.squaredNorm(), 0.0, 1.0);
      this->Radius = std::min(this->Radius, 0.25 * (a + share * side).norm());
    }
    this->PutOnCircle(solid, point, link, centre);
    this->PutInside(link);
  }

  const std::map<int, Eigen::RowVector2d>& Places() const { return this->Known; }
  const std::vector<Arc>& GetArcs() const { return this->Arcs; }

  /// Returns the direction of a place on a circle of radius 1, shrunk by a factor.
  Eigen::RowVector3d Lift(const Eigen::RowVector2d& place, double factor) const
  {
    return (this->Outward + this->Radius * factor * place * this->Across).normalized();
  }

private:
  Eigen::RowVector2d Project(const Eigen::RowVector3d& ray) const
  {
    const Eigen::RowVector3d difference = ray.normalized() - this->Outward;
    return difference * this->Across.transpose();
  }

  void PutOnCircle(
    const SolidCells& solid, int point, const InnerLink& link, const Eigen::RowVector3d& centre)
  {
    const std::size_t count = link.Sectors.size();
    std::vector<double> middles, widths;
    for (const Sector& sector : link.Sectors)
    {
      const Eigen::RowVector2d a = this->Project(solid.Points.row(sector.From) - centre),
                               b = this->Project(solid.Points.row(sector.To) - centre);
      const double width = std::atan2(a(0) * b(1) - a(1) * b(0), a.dot(b));
      widths.push_back(width < 0.0 ? width + 2.0 * Pi : width);
      middles.push_back(std::atan2(a(1), a(0)) + 0.5 * widths.back());
    }
    std::vector<Arc>& arcs = this->Arcs;
    const auto append = [&](int x, double angle, std::vector<int> simplex)
    {
      if (arcs.empty() || arcs.back().Point != x)
      {
        arcs.push_back({ x, angle, angle, {} });
      }
      arcs.back().Last = angle;
      std::sort(simplex.begin(), simplex.end());
      arcs.back().Simplices.insert(std::move(simplex));
    };
    double angle = middles[0];
    for (std::size_t i = 0; i < count; ++i)
    {
      const Sector& sector = link.Sectors[i];
      append(sector.Apex, angle, { point, sector.From, sector.To, sector.Apex });
      append(sector.Apex, angle, { point, sector.From, sector.Apex });
      append(sector.Apex, angle, { point, sector.To, sector.Apex });
      const double gap = 0.5 * (widths[i] + widths[(i + 1) % count]);
      const auto parts = static_cast<double>(link.Fans[i].size() + 1);
      for (std::size_t k = 0; k < link.Fans[i].size(); ++k)
      {
        append(link.Fans[i][k], angle + gap * static_cast<double>(k + 1) / parts,
          { point, sector.To, link.Fans[i][k] });
      }
      angle += gap;
    }
    if (arcs.size() > 1 && arcs.front().Point == arcs.back().Point)
    {
      arcs.front().First = arcs.back().First - 2.0 * Pi;
      arcs.front().Simplices.insert(arcs.back().Simplices.begin(), arcs.back().Simplices.end());
      arcs.pop_back();
    }
    std::map<int, std::vector<Eigen::RowVector2d>> places;
    for (const Arc& arc : arcs)
    {
      const double middle = 0.5 * (arc.First + arc.Last);
      places[arc.Point].emplace_back(std::cos(middle), std::sin(middle));
    }
    for (const auto& [x, all] : places)
    {
      Eigen::RowVector2d mean = Eigen::RowVector2d::Zero();
      for (const Eigen::RowVector2d& place : all)
      {
        mean += place / static_cast<double>(all.size());
      }
      this->Known[x] = arcs.size() == 1 ? Eigen::RowVector2d(0.0, 0.0) : mean;
    }
  }

  /// The other points of the link are at the means of their neighbours.
  void PutInside(const InnerLink& link)
  {
    std::map<int, int> unknown;
    for (const auto& [a, b] : link.Edges)
    {
      for (const int x : { a, b })
      {
        if (this->Known.count(x) == 0)
        {
          unknown.emplace(x, static_cast<int>(unknown.size()));
        }
      }
    }
    if (unknown.empty())
    {
      return;
    }
    const auto count = static_cast<Eigen::Index>(unknown.size());
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(count, 2);
    std::vector<Eigen::Triplet<double>> entries;
    const auto pull = [&](int x, int y)
    {
      const auto row = unknown.find(x);
      if (row == unknown.end())
      {
        return;
      }
      entries.emplace_back(row->second, row->second, 1.0);
      const auto other = unknown.find(y);
      if (other == unknown.end())
      {
        right.row(row->second) += this->Known.at(y);
      }
      else
      {
        entries.emplace_back(row->second, other->second, -1.0);
      }
    };
    for (const auto& [a, b] : link.Edges)
    {
      pull(a, b);
      pull(b, a);
    }
    Eigen::SparseMatrix<double> matrix(count, count);
    matrix.setFromTriplets(entries.begin(), entries.end());
    const Eigen::MatrixXd solved =
      Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(matrix).solve(right);
    for (const auto& [x, row] : unknown)
    {
      this->Known[x] = solved.row(row);
    }
  }

  Eigen::RowVector3d Outward;
  Eigen::Matrix<double, 2, 3> Across;
  double Radius = 0.0;
  std::vector<Arc> Arcs;
  std::map<int, Eigen::RowVector2d> Known;
};

/// A collar, and the boundary points with inverted tetrahedra of it.
struct TriedCollar
{
  PatchCollar Collar;
  std::map<int, std::vector<Arc>> Bad;
};

TriedCollar TryCollar(SolidCells& solid, const Eigen::RowVector3d& centre,
  const Eigen::MatrixXd& targets, const Progress& progress)
{
  MoveBoundary(solid, targets);
  double radius = std::numeric_limits<double>::max();
  std::map<int, LinkLayout> layouts;
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    if (solid.OnBoundary(point))
    {
      progress(0.0);
      layouts.emplace(point, LinkLayout(solid, point, centre));
      radius = std::min(radius, 0.5 * (solid.Points.row(point) - centre).norm());
    }
  }
  std::map<int, int> ends;
  for (const auto& [point, layout] : layouts)
  {
    progress(0.5);
    for (const auto& [other, place] : layout.Places())
    {
      const int middle = solid.Split({ point, other });
      ends[middle] = point;
      solid.Points.row(middle) = centre + radius * layout.Lift(place, 1.0);
    }
  }
  TriedCollar tried;
  for (int cell = 0; cell < solid.CellCount(); ++cell)
  {
    const int boundary = CountBoundaryPoints(solid, cell);
    if (boundary == 0)
    {
      continue;
    }
    const std::vector<int>& corners = solid.PointsOf(cell);
    if (solid.Inverted(cell))
    {
      ++tried.Collar.Inverted;
      for (const int corner : corners)
      {
        const int point = solid.OnBoundary(corner) ? corner : ends.at(corner);
        tried.Bad[point] = layouts.at(point).GetArcs();
      }
    }
    if (boundary == 1)
    {
      const int point = *std::find_if(
        corners.begin(), corners.end(), [&](int corner) { return solid.OnBoundary(corner); });
      tried.Collar.Inside.push_back(FindFaceOpposite(corners, point));
    }
  }
  return tried;
}

} // namespace

PatchCollar BuildPatchCollar(SolidCells& solid, const Eigen::RowVector3d& centre,
  const Eigen::MatrixXd& targets, const Progress& progress)
{
  for (;;)
  {
    SolidCells trial = solid;
    TriedCollar tried = TryCollar(trial, centre, targets, progress);
    if (tried.Collar.Inverted == 0 || !SplitArcs(solid, tried.Bad, progress))
    {
      solid = std::move(trial);
      return std::move(tried.Collar);
    }
  }
}

} // namespace shape
