// What is hard about a surface.
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Geometry/SelfIntersections.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(MODEL

MODEL  an OFF file; points at the same position are joined, the longest side of its box is made 1

Sizes, genus and whether it is a closed manifold; pairs of triangles that cross and how many triangles
that are; triangles without area, and points whose triangles have none; then percentiles of the triangles:
aspect (50, 90, 99, 100 %; 1 if equilateral), mean edge (1, 50, 99, 100 %), and thickness of the solid
over the mean edge there (1, 5, 25, 50 %).)";

constexpr double None = 1e30;

std::vector<double> Percentiles(std::vector<double> values, const std::vector<double>& shares)
{
  std::sort(values.begin(), values.end());
  std::vector<double> found;
  for (const double share : values.empty() ? std::vector<double>() : shares)
  {
    found.push_back(
      values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1))]);
  }
  return found;
}

/// How far from a triangle's centroid, against its normal, the surface is hit again; None where it
/// is not.
double Thickness(const shape::Mesh& mesh, const Eigen::MatrixXd& normals, int triangle)
{
  const Eigen::RowVector3d from = shape::GetCorners(mesh, triangle).colwise().mean();
  const Eigen::RowVector3d along = -normals.row(triangle);
  double nearest = None;
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = mesh.Points.row(mesh.Triangles(t, 0)) - from;
    const Eigen::RowVector3d b = mesh.Points.row(mesh.Triangles(t, 1)) - from;
    const Eigen::RowVector3d c = mesh.Points.row(mesh.Triangles(t, 2)) - from;
    const double u = along.dot(b.cross(c)), v = along.dot(c.cross(a)), w = along.dot(a.cross(b));
    const double sum = u + v + w;
    if (t != triangle && sum != 0.0 && u / sum >= 0.0 && v / sum >= 0.0 && w / sum >= 0.0)
    {
      const double distance = (u * a + v * b + w * c).dot(along) / sum;
      nearest = distance > 0.0 ? std::min(nearest, distance) : nearest;
    }
  }
  return nearest;
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string path = arguments.NextWord();
  arguments.RequireAllRead();
  const shape::Mesh mesh = benchmark::ReadOff(path, true);
  const shape::Topology topology = shape::ComputeTopology(mesh);
  const std::vector<int> flat = shape::FindDegenerateTriangles(mesh);
  std::vector<int> round;
  for (int t = 0; t < mesh.Triangles.rows(); ++t)
  {
    if (!std::binary_search(flat.begin(), flat.end(), t))
    {
      round.push_back(t);
    }
  }
  const auto crossings =
    shape::FindSelfIntersections({ mesh.Points, mesh.Triangles(round, Eigen::all) });
  std::set<int> crossed;
  for (const shape::Crossing& crossing : crossings)
  {
    crossed.insert({ crossing.First, crossing.Second });
  }
  const Eigen::MatrixXd areas = shape::ComputeAreaVectors(mesh);
  const Eigen::MatrixXd normals = areas.rowwise().normalized();
  std::vector<double> aspects, thickness, edges;
  const int step = std::max(1, static_cast<int>(mesh.Triangles.rows() / 3000));
  for (const int t : round)
  {
    const Eigen::Matrix3d corners = shape::GetCorners(mesh, t);
    double longest = 0.0, mean = 0.0;
    for (int k = 0; k < 3; ++k)
    {
      const double length = (corners.row(k) - corners.row((k + 1) % 3)).norm();
      longest = std::max(longest, length);
      mean += length / 3.0;
    }
    edges.push_back(mean);
    // 1 for the equilateral triangle
    aspects.push_back(longest * longest * std::sqrt(0.75) / areas.row(t).norm());
    if (t % step == 0)
    {
      const double thick = Thickness(mesh, normals, t);
      if (thick < None)
      {
        thickness.push_back(thick / mean);
      }
    }
  }
  int withoutArea = 0;
  const Eigen::VectorXd pointAreas = shape::ComputePointAreas(mesh);
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    withoutArea += topology.ComponentId(i) >= 0 && pointAreas(i) < 1e-14 ? 1 : 0;
  }
  const bool closed = topology.BoundaryLoops == 0 && topology.NonManifoldEdges == 0 &&
    topology.NonManifoldPoints == 0;
  figures.Print(benchmark::Row()
                  .Add("vertices", mesh.Points.rows())
                  .Add("triangles", mesh.Triangles.rows())
                  .Add("components", topology.Components)
                  .Add("genus", topology.Components - 0.5 * topology.EulerNumber)
                  .Add("closed", closed)
                  .Add("openloops", topology.BoundaryLoops)
                  .Add("nonmanifold", topology.NonManifoldEdges)
                  .Add("pinched", topology.NonManifoldPoints)
                  .Add("misoriented", topology.MisorientedEdges)
                  .Add("crossingpairs", crossings.size())
                  .Add("crossing", crossed.size())
                  .Add("flat", flat.size())
                  .Add("withoutarea", withoutArea)
                  .Add("aspect", Percentiles(aspects, { 0.5, 0.9, 0.99, 1 }))
                  .Add("edge", Percentiles(edges, { 0.01, 0.5, 0.99, 1 }))
                  .Add("thickness", Percentiles(thickness, { 0.01, 0.05, 0.25, 0.5 })));
}

const benchmark::Entry SurfaceFacts("surface_facts", { Usage, Run });

} // namespace
