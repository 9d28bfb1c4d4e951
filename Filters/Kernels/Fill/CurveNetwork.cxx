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

/// A segment of a curve with a direction: from one point to another.
using CurveSegment = std::pair<int, int>;

/// The segments of all curves over the points; of coincident points the first one stands for all.
struct SegmentGraph
{
  const Eigen::MatrixXd& Points;
  Eigen::MatrixXd Normals;            ///< n x 3: unit, or 0
  std::vector<std::vector<int>> Near; ///< of each point, those that a segment joins to it
  std::set<CurveSegment> Forward;     ///< in the direction of the first polyline that contains them

  int Size() const { return static_cast<int>(this->Near.size()); }
  bool HasNormal(int point) const { return this->Normals.row(point).squaredNorm() > 0.0; }
  bool IsBranch(int point) const { return this->Near[point].size() > 2; }
};

SegmentGraph BuildSegmentGraph(const Eigen::MatrixXd& points,
  const std::vector<std::vector<int>>& polylines, const Eigen::MatrixXd& normals)
{
  SegmentGraph graph{ points, Eigen::MatrixXd::Zero(points.rows(), 3),
    std::vector<std::vector<int>>(points.rows()), {} };
  const std::vector<int> position = FindCoincidentPoints(points);
  for (const std::vector<int>& line : polylines)
  {
    for (std::size_t i = 0; i + 1 < line.size(); ++i)
    {
      const int a = position[line[i]], b = position[line[i + 1]];
      std::vector<int>& near = graph.Near[a];
      if (a != b && std::find(near.begin(), near.end(), b) == near.end())
      {
        near.push_back(b);
        graph.Near[b].push_back(a);
        graph.Forward.insert({ a, b });
      }
    }
  }
  for (Eigen::Index i = 0; i < normals.rows(); ++i)
  {
    graph.Normals.row(position[i]) += normals.row(i).stableNormalized();
  }
  return graph;
}

/// Removes open ends, segment by segment; returns how many segments it has removed.
/// A segment with an open end bounds no patch. Removing it may open the next one.
int RemoveOpenEnds(SegmentGraph& graph)
{
  std::vector<int> ends;
  for (int point = 0; point < graph.Size(); ++point)
  {
    if (graph.Near[point].size() == 1)
    {
      ends.push_back(point);
    }
  }
  int removed = 0;
  while (!ends.empty())
  {
    const int end = ends.back();
    ends.pop_back();
    if (graph.Near[end].size() != 1)
    {
      continue;
    }
    const int other = graph.Near[end].front();
    std::vector<int>& near = graph.Near[other];
    graph.Near[end].clear();
    near.erase(std::find(near.begin(), near.end(), end));
    ++removed;
    if (near.size() == 1)
    {
      ends.push_back(other);
    }
  }
  return removed;
}

/// Gives the members of a component that have no normal the mean of their neighbours'.
/// Values spread from point to point within a pass and from pass to pass, until all are set.
void SpreadNormals(SegmentGraph& graph, const std::vector<int>& members)
{
  for (bool changed = true; changed;)
  {
    changed = false;
    for (const int point : members)
    {
      if (!graph.HasNormal(point))
      {
        RowVector3d sum = RowVector3d::Zero();
        for (const int other : graph.Near[point])
        {
          sum += graph.Normals.row(other);
        }
        graph.Normals.row(point) = sum.stableNormalized();
        changed = changed || graph.HasNormal(point);
      }
    }
  }
}

/// The normal of the plane that a component with branches lies in, upwards in z, else y, else x.
RowVector3d FitPlaneNormal(const SegmentGraph& graph, const std::vector<int>& members, int branches)
{
  Eigen::MatrixXd offsets(members.size(), 3);
  for (std::size_t i = 0; i < members.size(); ++i)
  {
    offsets.row(static_cast<Eigen::Index>(i)) = graph.Points.row(members[i]);
  }
  offsets.rowwise() -= offsets.colwise().mean().eval();
  const Eigen::JacobiSVD<Eigen::MatrixXd> axes(offsets, Eigen::ComputeThinV);
  // The thickness of the network relative to its width.
  constexpr double flat = 0.1;
  if (axes.singularValues()(2) > flat * axes.singularValues()(1))
  {
    const int first = *std::find_if(
      members.begin(), members.end(), [&](int point) { return graph.IsBranch(point); });
    throw InvalidInput("three or more curves meet at " + std::to_string(branches) +
      " points (first at point " + std::to_string(first) +
      "), but without normals the patches between them are ambiguous; add point Normals");
  }
  RowVector3d normal = axes.matrixV().col(2).transpose();
  // The sign of an axis is arbitrary; this rule makes it the same for every order of the points.
  const RowVector3d reversed(normal.z(), normal.y(), normal.x());
  for (const double part : reversed)
  {
    if (std::abs(part) > 1e-6)
    {
      return part > 0.0 ? normal : RowVector3d(-normal);
    }
  }
  return normal;
}

/// The unit area vector of a closed curve without branches, which runs counter-clockwise around it.
RowVector3d ComputeCurveNormal(const SegmentGraph& graph, int first)
{
  const std::vector<int>& start = graph.Near[first];
  const int second = graph.Forward.count({ first, start[0] }) > 0 ? start[0] : start[1];
  RowVector3d sum = RowVector3d::Zero();
  const RowVector3d origin = graph.Points.row(first);
  int before = first, at = second;
  while (at != first)
  {
    const int next = graph.Near[at][0] == before ? graph.Near[at][1] : graph.Near[at][0];
    const RowVector3d offset = graph.Points.row(at) - origin;
    sum += offset.cross(RowVector3d(graph.Points.row(next) - origin));
    before = at;
    at = next;
  }
  return sum.stableNormalized();
}

/// Completes the normals of each connected component; one without any gets that of its own plane.
void FillNetworkNormals(SegmentGraph& graph)
{
  DisjointSets components(graph.Size());
  for (int point = 0; point < graph.Size(); ++point)
  {
    for (const int other : graph.Near[point])
    {
      components.Merge(point, other);
    }
  }
  std::map<int, std::vector<int>> membersOf;
  for (int point = 0; point < graph.Size(); ++point)
  {
    graph.Normals.row(point).stableNormalize();
    if (graph.Near[point].empty())
    {
      graph.Normals.row(point).setZero();
    }
    else
    {
      membersOf[components.Find(point)].push_back(point);
    }
  }
  for (const auto& [component, members] : membersOf)
  {
    const auto branches = static_cast<int>(std::count_if(
      members.begin(), members.end(), [&](int point) { return graph.IsBranch(point); }));
    if (std::any_of(
          members.begin(), members.end(), [&](int point) { return graph.HasNormal(point); }))
    {
      SpreadNormals(graph, members);
      continue;
    }
    const RowVector3d normal = branches > 0 ? FitPlaneNormal(graph, members, branches)
                                            : ComputeCurveNormal(graph, members.front());
    for (const int point : members)
    {
      graph.Normals.row(point) = normal;
    }
  }
}

/// Sorts the neighbours of a point with branches counter-clockwise around its normal.
void SortNeighbours(SegmentGraph& graph, int point)
{
  if (!graph.IsBranch(point))
  {
    return;
  }
  std::vector<int>& near = graph.Near[point];
  const RowVector3d normal = graph.Normals.row(point);
  const RowVector3d x = normal.unitOrthogonal(), y = normal.cross(x);
  const auto angle = [&](int other)
  {
    const RowVector3d offset = graph.Points.row(other) - graph.Points.row(point);
    return std::atan2(offset.dot(y), offset.dot(x));
  };
  std::stable_sort(near.begin(), near.end(), [&](int a, int b) { return angle(a) < angle(b); });
}

/// The segments in both directions; those along polylines first, in the order of their points.
std::vector<CurveSegment> ListSegments(const SegmentGraph& graph)
{
  std::vector<CurveSegment> segments, backward;
  for (int a = 0; a < graph.Size(); ++a)
  {
    for (const int b : graph.Near[a])
    {
      (graph.Forward.count({ a, b }) > 0 ? segments : backward).emplace_back(a, b);
    }
  }
  segments.insert(segments.end(), backward.begin(), backward.end());
  return segments;
}

/// The points of the face to the left of a segment: at each point it turns into the next segment
/// clockwise. Marks its segments as visited.
/// The faces of a rotation system: in the counter-clockwise order around a point, the segment
/// before the one on which the walk arrives is the next one of the face to its left.
std::vector<int> TraceFace(
  const SegmentGraph& graph, CurveSegment segment, std::set<CurveSegment>& visited)
{
  std::vector<int> face;
  while (visited.insert(segment).second)
  {
    face.push_back(segment.first);
    const std::vector<int>& near = graph.Near[segment.second];
    const auto back = std::find(near.begin(), near.end(), segment.first) - near.begin();
    const auto count = static_cast<std::ptrdiff_t>(near.size());
    segment = { segment.second, near[(back + count - 1) % count] };
  }
  return face;
}

/// Whether most segments of a face run as the polylines do.
bool RunsForward(const SegmentGraph& graph, const std::vector<int>& face)
{
  std::size_t forward = 0;
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    forward += graph.Forward.count({ face[i], face[(i + 1) % face.size()] });
  }
  const auto minimum = std::min_element(face.begin(), face.end()) - face.begin();
  const int next = face[(minimum + 1) % face.size()];
  const int last = face[(minimum + face.size() - 1) % face.size()];
  return 2 * forward > face.size() || (2 * forward == face.size() && next < last);
}

/// The area that a face runs around counter-clockwise, seen from its normals, over the square of
/// its length.
double ComputeSignedArea(const SegmentGraph& graph, const std::vector<int>& face)
{
  RowVector3d centre = RowVector3d::Zero();
  for (const int point : face)
  {
    centre += graph.Points.row(point) / static_cast<double>(face.size());
  }
  double sum = 0.0, length = 0.0;
  for (std::size_t i = 0; i < face.size(); ++i)
  {
    const int point = face[i], next = face[(i + 1) % face.size()];
    const RowVector3d from = graph.Points.row(point) - centre;
    const RowVector3d to = graph.Points.row(next) - centre;
    const RowVector3d normal = graph.Normals.row(point) + graph.Normals.row(next);
    // Half of the cross product is the area, half of the sum the mean normal.
    sum += 0.25 * normal.dot(from.cross(to));
    length += (to - from).norm();
  }
  return sum / (length * length);
}

/// Whether a face is to be filled. Of the two faces of a closed curve, it is the one that its
/// normals determine, else that of its direction.
bool IsPatch(const SegmentGraph& graph, const std::vector<int>& face)
{
  const double area = ComputeSignedArea(graph, face);
  const bool isCurve =
    std::all_of(face.begin(), face.end(), [&](int point) { return graph.Near[point].size() == 2; });
  // For a circle the value is 1 / (4 pi) = 0.08. Below a thousandth the normals lie in the plane of
  // the curve and do not determine the sign.
  constexpr double unclear = 1e-3;
  const bool isWanted = isCurve && std::abs(area) < unclear ? RunsForward(graph, face) : area > 0.0;
  return isWanted && face.size() >= 3;
}

} // namespace

// 1. Join coincident points, and remove open ends.
// 2. Complete the normals (FillNetworkNormals).
// 3. Sort the segments around each point by its normal, which determines the faces.
// 4. Trace each face once; those that run counter-clockwise are loops (IsPatch).
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
        throw InvalidInput("a curve contains point " + std::to_string(point) + ", but there are " +
          std::to_string(points.rows()) + " points; correct its connectivity");
      }
    }
  }
  CurveNetwork network;
  SegmentGraph graph = BuildSegmentGraph(points, polylines, normals);
  network.LooseSegments = RemoveOpenEnds(graph);
  FillNetworkNormals(graph);
  for (int point = 0; point < graph.Size(); ++point)
  {
    SortNeighbours(graph, point);
  }
  std::set<CurveSegment> visited;
  for (const CurveSegment& segment : ListSegments(graph))
  {
    std::vector<int> face = TraceFace(graph, segment, visited);
    if (face.empty() || !IsPatch(graph, face))
    {
      continue;
    }
    if (std::set<int>(face.begin(), face.end()).size() < face.size())
    {
      ++network.SkippedFaces;
      continue;
    }
    // The first point does not depend on the segment at which the walk begins.
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    network.Loops.push_back(std::move(face));
  }
  network.Normals = std::move(graph.Normals);
  return network;
}

} // namespace shape
