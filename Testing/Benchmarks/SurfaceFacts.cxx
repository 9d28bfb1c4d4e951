// What is hard about surfaces: surface_facts MODEL ... prints one line for each OFF file, with
// points at the same place joined.
#include "BenchmarkData.h"

#include "Geometry/SelfIntersections.h"
#include "Mesh/Topology.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace
{

constexpr double None = 1e30;

std::string Percentiles(std::vector<double> values, const std::vector<double>& shares)
{
  std::sort(values.begin(), values.end());
  std::string text;
  for (const double share : shares)
  {
    const auto position = static_cast<std::size_t>(share * static_cast<double>(values.size() - 1));
    char number[32];
    std::snprintf(number, sizeof(number), "%s%.3g", text.empty() ? "" : "/", values[position]);
    text += number;
  }
  return text;
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

void Print(const std::string& path)
{
  const shape::Mesh mesh = benchmark::ReadOff(path, true);
  const std::string name = std::filesystem::path(path).stem().string();
  shape::Topology topology;
  try
  {
    topology = shape::ComputeTopology(mesh);
  }
  catch (const std::exception& problem)
  {
    std::printf("%s: %s\n", name.c_str(), problem.what());
    return;
  }
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
  std::printf("%s: vertices %d, triangles %d, components %d, genus %g, closed manifold %s (open "
              "loops %d, non-manifold edges %d, pinched points %d, misoriented edges %d); "
              "crossing pairs %d (%d triangles); flat triangles %d, vertices without area %d; "
              "aspect (50/90/99/100 %%) %s; mean edge / size (1/50/99/100 %%) %s; thickness / "
              "local edge (1/5/25/50 %%) %s\n",
    name.c_str(), static_cast<int>(mesh.Points.rows()), static_cast<int>(mesh.Triangles.rows()),
    topology.Components, topology.Components - 0.5 * topology.EulerNumber, closed ? "yes" : "NO",
    topology.BoundaryLoops, topology.NonManifoldEdges, topology.NonManifoldPoints,
    topology.MisorientedEdges, static_cast<int>(crossings.size()), static_cast<int>(crossed.size()),
    static_cast<int>(flat.size()), withoutArea, Percentiles(aspects, { 0.5, 0.9, 0.99, 1 }).c_str(),
    Percentiles(edges, { 0.01, 0.5, 0.99, 1 }).c_str(),
    Percentiles(thickness, { 0.01, 0.05, 0.25, 0.5 }).c_str());
  std::fflush(stdout);
}

} // namespace

int main(int count, char** paths)
{
  for (int i = 1; i < count; ++i)
  {
    try
    {
      Print(paths[i]);
    }
    catch (const std::exception& problem)
    {
      std::printf("%s: %s\n", paths[i], problem.what());
    }
  }
  return count > 1 ? 0 : 1;
}
