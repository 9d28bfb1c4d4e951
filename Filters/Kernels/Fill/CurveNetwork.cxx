#include "Fill/CurveNetwork.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

class NetworkSearch
{
public:
  NetworkSearch(const Eigen::MatrixXd& points, const std::vector<std::vector<int>>& polylines,
    const Eigen::MatrixXd& normals)
    : Points(points)
    , Near(points.rows())
  {
    this->Network.Normals = Eigen::MatrixXd::Zero(points.rows(), 3);
    const std::vector<int> position = FindCoincidentPoints(points);
    for (const std::vector<int>& line : polylines)
    {
      for (std::size_t i = 0; i + 1 < line.size(); ++i)
      {
        const int a = position[line[i]], b = position[line[i + 1]];
        if (a != b &&
          std::find(this->Near[a].begin(), this->Near[a].end(), b) == this->Near[a].end())
        {
          this->Near[a].push_back(b);
          this->Near[b].push_back(a);
          this->Forward.insert({ a, b });
        }
      }
    }
    for (Eigen::Index i = 0; i < normals.rows(); ++i)
    {
      this->Network.Normals.row(position[i]) += normals.row(i).stableNormalized();
    }
    this->Prune();
    this->FillNormals();
  }

  CurveNetwork Find()
  {
    for (int point = 0; point < static_cast<int>(this->Near.size()); ++point)
    {
      this->Order(point);
    }
    for (const auto& [a, b] : this->Sides())
    {
      if (this->Visited.count({ a, b }) == 0)
      {
        this->Follow(a, b);
      }
    }
    return this->Network;
  }

private:
  using Side = std::pair<int, int>;

  /// Takes away what ends in the open.
  void Prune()
  {
    std::vector<int> ends;
    for (int point = 0; point < static_cast<int>(this->Near.size()); ++point)
    {
      if (this->Near[point].size() == 1)
      {
        ends.push_back(point);
      }
    }
    while (!ends.empty())
    {
      const int end = ends.back();
      ends.pop_back();
      if (this->Near[end].size() != 1)
      {
        continue;
      }
      const int other = this->Near[end].front();
      this->Near[end].clear();
      this->Near[other].erase(std::find(this->Near[other].begin(), this->Near[other].end(), end));
      ++this->Network.LooseSegments;
      if (this->Near[other].size() == 1)
      {
        ends.push_back(other);
      }
    }
  }

  /// Where there are none in a connected part, those of its own plane.
  void FillNormals()
  {
    const auto count = static_cast<int>(this->Near.size());
    DisjointSets parts(count);
    for (int point = 0; point < count; ++point)
    {
      for (const int other : this->Near[point])
      {
        parts.Merge(point, other);
      }
    }
    std::map<int, std::vector<int>> points;
    for (int point = 0; point < count; ++point)
    {
      this->Network.Normals.row(point).stableNormalize();
      if (this->Near[point].empty())
      {
        this->Network.Normals.row(point).setZero();
      }
      else
      {
        points[parts.Find(point)].push_back(point);
      }
    }
    for (const auto& [part, members] : points)
    {
      const bool hasNormals = std::any_of(
        members.begin(), members.end(), [&](int point) { return this->HasNormal(point); });
      const auto branches = std::count_if(
        members.begin(), members.end(), [&](int point) { return this->Near[point].size() > 2; });
      if (hasNormals)
      {
        this->SpreadNormals(members);
        continue;
      }
      const RowVector3d normal = branches > 0 ? this->PlaneOf(members, static_cast<int>(branches))
                                              : this->AreaVector(members.front());
      for (const int point : members)
      {
        this->Network.Normals.row(point) = normal;
      }
    }
  }

  bool HasNormal(int point) const { return this->Network.Normals.row(point).squaredNorm() > 0.0; }

  /// To points without one, from their neighbours.
  void SpreadNormals(const std::vector<int>& members)
  {
    for (bool changed = true; changed;)
    {
      changed = false;
      for (const int point : members)
      {
        if (!this->HasNormal(point))
        {
          RowVector3d sum = RowVector3d::Zero();
          for (const int other : this->Near[point])
          {
            sum += this->Network.Normals.row(other);
          }
          this->Network.Normals.row(point) = sum.stableNormalized();
          changed = changed || this->HasNormal(point);
        }
      }
    }
  }

  /// The normal of the plane that a network lies in, upwards in z, y or x.
  RowVector3d PlaneOf(const std::vector<int>& members, int branches) const
  {
    Eigen::MatrixXd ways(members.size(), 3);
    for (std::size_t i = 0; i < members.size(); ++i)
    {
      ways.row(static_cast<Eigen::Index>(i)) = this->Points.row(members[i]);
    }
    ways.rowwise() -= ways.colwise().mean().eval();
    const Eigen::JacobiSVD<Eigen::MatrixXd> axes(ways, Eigen::ComputeThinV);
    constexpr double flat = 0.1;
    if (axes.singularValues()(2) > flat * axes.singularValues()(1))
    {
      const int first = *std::find_if(
        members.begin(), members.end(), [&](int point) { return this->Near[point].size() > 2; });
      throw InvalidInput("three or more curves meet at " + std::to_string(branches) +
        " points (first at point " + std::to_string(first) +
        "), and they have no normals to tell the patches between them; add point Normals");
    }
    RowVector3d normal = axes.matrixV().col(2).transpose();
    const RowVector3d turned(normal.z(), normal.y(), normal.x());
    for (const double part : turned)
    {
      if (std::abs(part) > 1e-6)
      {
        return part > 0.0 ? normal : RowVector3d(-normal);
      }
    }
    return normal;
  }

  /// The unit normal of a closed curve without branches, counter-clockwise around it in its sense.
  RowVector3d AreaVector(int first) const
  {
    const int second = this->Forward.count({ first, this->Near[first][0] }) > 0
      ? this->Near[first][0]
      : this->Near[first][1];
    RowVector3d sum = RowVector3d::Zero();
    const RowVector3d origin = this->Points.row(first);
    int before = first, at = second;
    while (at != first)
    {
      const int next = this->Near[at][0] == before ? this->Near[at][1] : this->Near[at][0];
      const RowVector3d way = this->Points.row(at) - origin;
      sum += way.cross(RowVector3d(this->Points.row(next) - origin));
      before = at;
      at = next;
    }
    return sum.stableNormalized();
  }

  /// Sorts what is around a point counter-clockwise around its normal.
  void Order(int point)
  {
    std::vector<int>& near = this->Near[point];
    if (near.size() < 3)
    {
      return;
    }
    const RowVector3d normal = this->Network.Normals.row(point);
    const RowVector3d x = normal.unitOrthogonal(), y = normal.cross(x);
    const auto angle = [&](int other)
    {
      const RowVector3d way = this->Points.row(other) - this->Points.row(point);
      return std::atan2(way.dot(y), way.dot(x));
    };
    std::stable_sort(near.begin(), near.end(), [&](int a, int b) { return angle(a) < angle(b); });
  }

  /// The sides in both senses; those along polylines first, in the order of their points.
  std::vector<Side> Sides() const
  {
    std::vector<Side> sides, back;
    for (int a = 0; a < static_cast<int>(this->Near.size()); ++a)
    {
      for (const int b : this->Near[a])
      {
        (this->Forward.count({ a, b }) > 0 ? sides : back).emplace_back(a, b);
      }
    }
    sides.insert(sides.end(), back.begin(), back.end());
    return sides;
  }

  /// Goes around the face to the left of a side.
  void Follow(int a, int b)
  {
    std::vector<int> face;
    bool isSimple = true;
    std::set<int> positions;
    Side side(a, b);
    while (this->Visited.insert(side).second)
    {
      face.push_back(side.first);
      isSimple = positions.insert(side.first).second && isSimple;
      const std::vector<int>& near = this->Near[side.second];
      const auto back = std::find(near.begin(), near.end(), side.first) - near.begin();
      const auto count = static_cast<std::ptrdiff_t>(near.size());
      side = { side.second, near[(back + count - 1) % count] };
    }
    const double turning = this->Turning(face);
    const bool isCurve = std::all_of(
      face.begin(), face.end(), [&](int point) { return this->Near[point].size() == 2; });
    // Both sides of a closed curve: the one that its normals ask for, else that of its sense.
    constexpr double unclear = 1e-3;
    const bool isWanted =
      isCurve && std::abs(turning) < unclear ? this->IsForward(face) : turning > 0.0;
    if (!isWanted || face.size() < 3)
    {
      return;
    }
    if (!isSimple)
    {
      ++this->Network.SkippedFaces;
      return;
    }
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    this->Network.Loops.push_back(std::move(face));
  }

  /// Whether most of a face's sides run as the polylines do.
  bool IsForward(const std::vector<int>& face) const
  {
    std::size_t forward = 0;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      forward += this->Forward.count({ face[i], face[(i + 1) % face.size()] });
    }
    const auto minimum = std::min_element(face.begin(), face.end()) - face.begin();
    const int next = face[(minimum + 1) % face.size()];
    const int last = face[(minimum + face.size() - 1) % face.size()];
    return 2 * forward > face.size() || (2 * forward == face.size() && next < last);
  }

  /// How much of the area that a face goes around is seen from its normals, counter-clockwise: in
  /// shares of the squared length of its border.
  double Turning(const std::vector<int>& face) const
  {
    RowVector3d centre = RowVector3d::Zero();
    for (const int point : face)
    {
      centre += this->Points.row(point) / static_cast<double>(face.size());
    }
    double sum = 0.0, length = 0.0;
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const int point = face[i], next = face[(i + 1) % face.size()];
      const RowVector3d from = this->Points.row(point) - centre;
      const RowVector3d to = this->Points.row(next) - centre;
      const RowVector3d normal = this->Network.Normals.row(point) + this->Network.Normals.row(next);
      sum += 0.25 * normal.dot(from.cross(to));
      length += (to - from).norm();
    }
    return sum / (length * length);
  }

  const Eigen::MatrixXd& Points;
  std::vector<std::vector<int>> Near; ///< of each place, those joined to it by a segment
  std::set<Side> Forward;             ///< segments in the sense of the first polyline with them
  std::set<Side> Visited;
  CurveNetwork Network;
};

} // namespace

CurveNetwork FindCurveLoops(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const Eigen::MatrixXd& normals)
{
  RequireFinite(points, "the curves");
  RequireFinite(normals, "the curves' normals");
  for (const std::vector<int>& line : polylines)
  {
    for (const int point : line)
    {
      if (point < 0 || point >= points.rows())
      {
        throw InvalidInput("a curve names point " + std::to_string(point) + " of " +
          std::to_string(points.rows()) + "; give points that exist");
      }
    }
  }
  return NetworkSearch(points, polylines, normals).Find();
}

} // namespace shape
