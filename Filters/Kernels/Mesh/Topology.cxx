#include "Mesh/Topology.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/HalfEdges.h"

#include <vector>

namespace shape
{
namespace
{

void CheckIndices(const Mesh& mesh)
{
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = mesh.Triangles.row(t);
    if (corners.minCoeff() < 0 || corners.maxCoeff() >= mesh.Points.rows())
    {
      throw InvalidInput("triangle " + std::to_string(t) + " uses a point that does not exist; " +
        "the surface has " + std::to_string(mesh.Points.rows()) + " points");
    }
    if (corners(0) == corners(1) || corners(1) == corners(2) || corners(2) == corners(0))
    {
      throw InvalidInput("triangle " + std::to_string(t) + " uses point " +
        std::to_string(corners(0) == corners(1) ? corners(0) : corners(2)) +
        " twice; remove such triangles with Clean");
    }
  }
}

/// Every point must have one fan of triangles: count the groups of triangles around it that hang
/// together by edges at the point.
void CountPinchedPoints(const Mesh& mesh, const std::vector<HalfEdge>& sides, Topology& topology)
{
  // A corner is 3 * triangle + corner; corners of one point are joined across a shared edge.
  DisjointSets fans(static_cast<int>(3 * mesh.Triangles.rows()));
  const auto cornerOf = [&](int triangle, int point)
  {
    const auto row = mesh.Triangles.row(triangle);
    return 3 * triangle + (row(0) == point ? 0 : row(1) == point ? 1 : 2);
  };
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    const HalfEdge& a = sides[i];
    const HalfEdge& b = sides[i + 1];
    if (a.Low() == b.Low() && a.High() == b.High())
    {
      fans.Merge(cornerOf(a.Triangle, a.Low()), cornerOf(b.Triangle, a.Low()));
      fans.Merge(cornerOf(a.Triangle, a.High()), cornerOf(b.Triangle, a.High()));
    }
  }
  std::vector<int> fanOfPoint(mesh.Points.rows(), -1);
  std::vector<char> pinched(mesh.Points.rows(), 0);
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int point = mesh.Triangles(t, corner);
      const int fan = fans.Find(3 * t + corner);
      if (fanOfPoint[point] == -1)
      {
        fanOfPoint[point] = fan;
      }
      pinched[point] = pinched[point] || fanOfPoint[point] != fan;
    }
  }
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    if (pinched[i])
    {
      topology.FirstPinchedPoint =
        topology.NonManifoldPoints++ == 0 ? i : topology.FirstPinchedPoint;
    }
  }
}

void CountComponents(const Mesh& mesh, Topology& topology)
{
  DisjointSets pieces(static_cast<int>(mesh.Points.rows()));
  topology.ComponentId = Eigen::VectorXi::Constant(mesh.Points.rows(), -1);
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    pieces.Merge(mesh.Triangles(t, 0), mesh.Triangles(t, 1));
    pieces.Merge(mesh.Triangles(t, 1), mesh.Triangles(t, 2));
    for (int corner = 0; corner < 3; ++corner)
    {
      topology.ComponentId(mesh.Triangles(t, corner)) = 0;
    }
  }
  std::vector<int> idOfRoot(mesh.Points.rows(), -1);
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    if (topology.ComponentId(i) == 0)
    {
      int& id = idOfRoot[pieces.Find(i)];
      id = id == -1 ? topology.Components++ : id;
      topology.ComponentId(i) = id;
    }
  }
}

/// "the boundary has 3 open loops (first at point 118)"
std::string Found(const std::string& name, int count, const std::string& singular,
  const std::string& plural, int first)
{
  return name + " has " + std::to_string(count) + " " + (count == 1 ? singular : plural) +
    " (first at point " + std::to_string(first) + "); ";
}

void RequireSize(const Eigen::MatrixXd& points, const std::string& name)
{
  if (LongestSide(points) == 0.0)
  {
    throw InvalidInput(
      name + " has no area: its points are all at one place; check its coordinates");
  }
  RequireExtent(points, name);
}

/// The topology of a surface that has triangles and finite coordinates.
Topology TopologyOfSound(const Mesh& mesh, const std::string& name, const std::string& needed)
{
  if (mesh.Triangles.rows() == 0)
  {
    throw InvalidInput(name + " has no triangles; give " + needed);
  }
  RequireFinite(mesh.Points, name);
  RequireSize(mesh.Points, name);
  return SurfaceTopology(mesh);
}

/// Whether no choice of sides for the triangles agrees across all edges, as on a Moebius strip.
bool IsOneSided(const Mesh& mesh)
{
  // Twice as many as triangles: those as they are, then those turned over, joined where they agree.
  const auto m = static_cast<int>(mesh.Triangles.rows());
  DisjointSets sheets(2 * m);
  const std::vector<HalfEdge> sides = SortedHalfEdges(mesh.Triangles, mesh.Points.rows());
  for (std::size_t i = 0; i + 1 < sides.size(); ++i)
  {
    const HalfEdge& p = sides[i];
    const HalfEdge& q = sides[i + 1];
    if (p.Low() == q.Low() && p.High() == q.High())
    {
      const int turned = p.Begin == q.Begin ? m : 0;
      sheets.Merge(p.Triangle, q.Triangle + turned);
      sheets.Merge(p.Triangle + m, q.Triangle + m - turned);
    }
  }
  for (int t = 0; t < m; ++t)
  {
    if (sheets.Find(t) == sheets.Find(t + m))
    {
      return true;
    }
  }
  return false;
}

void CheckManifold(const Mesh& mesh, const Topology& topology, const std::string& name)
{
  if (topology.NonManifoldEdges > 0)
  {
    throw InvalidInput(Found(name, topology.NonManifoldEdges, "edge with three or more triangles",
                         "edges with three or more triangles", topology.FirstNonManifold) +
      "keep the outer surface alone");
  }
  if (topology.NonManifoldPoints > 0)
  {
    throw InvalidInput(Found(name, topology.NonManifoldPoints, "point where two sheets touch",
                         "points where two sheets touch", topology.FirstPinchedPoint) +
      "duplicate them, one for each sheet");
  }
  if (topology.MisorientedEdges > 0 && IsOneSided(mesh))
  {
    throw InvalidInput(name +
      " is one-sided, as a Moebius strip is: its triangles cannot all face " +
      "the same way (they do not at point " + std::to_string(topology.FirstMisoriented) +
      "); cut it open across the strip");
  }
  if (topology.MisorientedEdges > 0)
  {
    throw InvalidInput(
      Found(name, topology.MisorientedEdges, "edge between triangles of opposite orientation",
        "edges between triangles of opposite orientation", topology.FirstMisoriented) +
      "make them agree with Generate Surface Normals (Consistency on)");
  }
}

} // namespace

Topology SurfaceTopology(const Mesh& mesh)
{
  CheckIndices(mesh);
  Topology topology;
  CountComponents(mesh, topology);
  const std::vector<HalfEdge> sides = SortedHalfEdges(mesh.Triangles, mesh.Points.rows());
  DisjointSets loops(static_cast<int>(mesh.Points.rows()));
  std::vector<char> open(mesh.Points.rows(), 0);
  int edges = 0;
  for (std::size_t i = 0; i < sides.size();)
  {
    std::size_t next = i + 1;
    while (next < sides.size() && sides[next].Low() == sides[i].Low() &&
      sides[next].High() == sides[i].High())
    {
      ++next;
    }
    ++edges;
    const int sharing = static_cast<int>(next - i);
    if (sharing == 1)
    {
      loops.Merge(sides[i].Begin, sides[i].End);
      open[sides[i].Begin] = open[sides[i].End] = 1;
    }
    else if (sharing > 2)
    {
      topology.FirstNonManifold =
        topology.NonManifoldEdges++ == 0 ? sides[i].Low() : topology.FirstNonManifold;
    }
    else if (sides[i].Begin == sides[i + 1].Begin)
    {
      topology.FirstMisoriented =
        topology.MisorientedEdges++ == 0 ? sides[i].Low() : topology.FirstMisoriented;
    }
    i = next;
  }
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    if (open[i])
    {
      topology.OpenLoops += loops.Find(i) == i;
      topology.FirstOpenPoint = topology.FirstOpenPoint == -1 ? i : topology.FirstOpenPoint;
    }
  }
  CountPinchedPoints(mesh, sides, topology);
  const int usedPoints = static_cast<int>((topology.ComponentId.array() >= 0).count());
  topology.EulerNumber = usedPoints - edges + static_cast<int>(mesh.Triangles.rows());
  return topology;
}

std::vector<Mesh> SplitComponents(const Mesh& mesh)
{
  const Topology topology = SurfaceTopology(mesh);
  std::vector<std::vector<int>> triangles(topology.Components), points(topology.Components);
  std::vector<int> newId(mesh.Points.rows(), -1);
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    if (topology.ComponentId(i) >= 0)
    {
      std::vector<int>& own = points[topology.ComponentId(i)];
      newId[i] = static_cast<int>(own.size());
      own.push_back(i);
    }
  }
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    triangles[topology.ComponentId(mesh.Triangles(t, 0))].push_back(t);
  }
  std::vector<Mesh> components;
  for (int c = 0; c < topology.Components; ++c)
  {
    components.push_back({ mesh.Points(points[c], Eigen::all),
      mesh.Triangles(triangles[c], Eigen::all).unaryExpr([&](int i) { return newId[i]; }) });
  }
  return components;
}

Topology RequireManifold(const Mesh& mesh, const std::string& name)
{
  Topology topology = TopologyOfSound(mesh, name, "a surface");
  CheckManifold(mesh, topology, name);
  return topology;
}

Topology RequireClosedSurface(const Mesh& mesh, const std::string& name)
{
  Topology topology = TopologyOfSound(mesh, name, "a closed surface");
  if (topology.OpenLoops > 0)
  {
    throw InvalidInput(
      Found(name, topology.OpenLoops, "open loop", "open loops", topology.FirstOpenPoint) +
      "close it with Fill Holes, or merge its duplicate points with Clean");
  }
  CheckManifold(mesh, topology, name);
  return topology;
}

void RequireFinite(const Eigen::MatrixXd& values, const std::string& name)
{
  if (values.allFinite())
  {
    return;
  }
  int count = 0;
  Eigen::Index first = -1;
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    if (!values.row(i).allFinite())
    {
      first = count++ == 0 ? i : first;
    }
  }
  throw InvalidInput(name + " has " + std::to_string(count) + (count == 1 ? " point" : " points") +
    " with a value that is not finite (first at point " + std::to_string(first) +
    "); remove or repair " + (count == 1 ? "it" : "them"));
}

} // namespace shape
