#include "Mesh/Topology.h"

#include "Base/DisjointSets.h"
#include "Base/Errors.h"
#include "Mesh/SurfaceWork.h"
#include "Mesh/TouchingSheets.h"

#include <vector>

namespace shape
{
namespace
{

void RequireDistinctCorners(const Mesh& mesh)
{
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = mesh.Triangles.row(t);
    if (corners(0) == corners(1) || corners(1) == corners(2) || corners(2) == corners(0))
    {
      throw InvalidInput("triangle " + std::to_string(t) + " uses point " +
        std::to_string(corners(0) == corners(1) ? corners(0) : corners(2)) +
        " twice; remove such triangles with Clean");
    }
  }
}

/// Every point must have one fan of triangles. Counts, for each point, the groups of its triangles
/// that are connected by edges at the point.
void CountPinchedPoints(const Mesh& mesh, const std::vector<HalfEdge>& sides, Topology& topology)
{
  const std::vector<int> fans = FindFans(mesh, sides);
  std::vector<int> fanOfPoint(mesh.Points.rows(), -1);
  std::vector<char> pinched(mesh.Points.rows(), 0);
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int point = mesh.Triangles(t, corner);
      const int fan = fans[3 * t + corner];
      if (fanOfPoint[point] == -1)
      {
        fanOfPoint[point] = fan;
      }
      // A second fan at the same point.
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

} // namespace

void RequireIndices(const Mesh& mesh)
{
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = mesh.Triangles.row(t);
    if (corners.minCoeff() < 0 || corners.maxCoeff() >= mesh.Points.rows())
    {
      throw InvalidInput("triangle " + std::to_string(t) + " uses a point that does not exist; " +
        "the surface has " + std::to_string(mesh.Points.rows()) + " points");
    }
  }
}

Topology ComputeTopology(const Mesh& mesh)
{
  RequireIndices(mesh);
  return ComputeTopology(mesh, SortHalfEdges(mesh.Triangles, mesh.Points.rows()));
}

Topology ComputeTopology(const Mesh& mesh, const std::vector<HalfEdge>& sides)
{
  SurfaceWork::Note(SurfaceWork::Kind::Topology, mesh.Points);
  RequireDistinctCorners(mesh);
  Topology topology;
  CountComponents(mesh, topology);
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
    // One half-edge: the boundary. Two: an inner edge, in opposite directions if the triangles
    // agree. More: not a manifold.
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
      topology.BoundaryLoops += loops.Find(i) == i;
      topology.FirstOpenPoint = topology.FirstOpenPoint == -1 ? i : topology.FirstOpenPoint;
    }
  }
  CountPinchedPoints(mesh, sides, topology);
  const int usedPoints = static_cast<int>((topology.ComponentId.array() >= 0).count());
  // V - E + F.
  topology.EulerNumber = usedPoints - edges + static_cast<int>(mesh.Triangles.rows());
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
