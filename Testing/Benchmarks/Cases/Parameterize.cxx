// Sphere, disk, free-boundary and orbifold maps of one surface.
#include "Driver/BenchmarkData.h"
#include "Driver/Case.h"

#include "Base/Errors.h"
#include "Geodesics/EdgeGeodesics.h"
#include "Geodesics/FarthestPoints.h"
#include "Geometry/Orientation.h"
#include "Mesh/HalfEdges.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfaceCut.h"
#include "Mesh/Topology.h"
#include "Parameterize/ConformalFlattening.h"
#include "Parameterize/Parameterize.h"

#include <array>
#include <cmath>
#include <exception>
#include <limits>
#include <set>
#include <string>
#include <vector>

namespace
{

constexpr const char* Usage = R"(MODEL

MODEL  an OFF file; points at the same position are joined, the longest side of its box is made 1

The first row is what the surface is. If it is one component of genus 0, a row for each map follows:
triangles that exact orientations call flipped (-1 if the map is refused), the mean symmetric
Dirichlet energy, the mean conformal distortion, iterations, CPU seconds and what it says.
A closed surface is mapped to the sphere and to orbifolds whose cones are far from each other, and
cut open along a tree of paths between points far from each other for the others.)";

using Domain = shape::ParameterizeOptions::DomainType;
using Refine = shape::RefineType;

int FlipsOnSphere(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& image)
{
  int flips = 0;
  for (const auto& corners : triangles.rowwise())
  {
    // The origin lies behind a triangle that faces outwards.
    flips += shape::EvaluateOrientation(image.row(corners(0)), image.row(corners(1)),
               image.row(corners(2)), Eigen::RowVector3d::Zero()) >= 0;
  }
  return flips;
}

int FlipsInPlane(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& image)
{
  int flips = 0;
  for (const auto& corners : triangles.rowwise())
  {
    flips += shape::EvaluateOrientation(image.row(corners(0)).head<2>(),
               image.row(corners(1)).head<2>(), image.row(corners(2)).head<2>()) <= 0;
  }
  return flips;
}

void Report(benchmark::Figures& figures, const std::string& name, const shape::Mesh& mesh,
  const Eigen::MatrixXd& landmarks, const shape::ParameterizeOptions& options)
{
  shape::ParameterizeResult map;
  std::string message;
  int flips = -1;
  const benchmark::Cost cost = benchmark::Measure(
    [&]
    {
      try
      {
        map = shape::Parameterize(mesh, landmarks, options);
        flips = 0;
      }
      catch (const std::exception& problem)
      {
        message = problem.what();
      }
    });
  if (flips == 0)
  {
    flips = options.Domain == Domain::Sphere ? FlipsOnSphere(mesh.Triangles, map.Positions)
      : options.Domain == Domain::Orbifold
      ? FlipsInPlane(map.Cut.Surface.Triangles, map.CutPositions)
      : FlipsInPlane(mesh.Triangles, map.Positions);
  }
  figures.Print(benchmark::Row()
                  .Add("map", name)
                  .Add("flips", flips)
                  .Add("energy", map.Energy)
                  .Add("conformal", map.ConformalDistortion)
                  .Add("iterations", map.Iterations)
                  .Add(cost)
                  .Add("message", message.empty() ? map.Method : message));
}

/// Cut along shortest paths that join each point to the tree of those before it.
shape::Mesh CutAlongTree(const shape::Mesh& mesh, const std::vector<int>& points)
{
  std::vector<std::vector<int>> neighbours(mesh.Points.rows());
  for (const shape::HalfEdge& side : shape::SortHalfEdges(mesh.Triangles, mesh.Points.rows()))
  {
    neighbours[side.Begin].push_back(side.End);
  }
  std::set<int> tree = { points.front() };
  std::vector<std::array<int, 2>> edges;
  for (const int point : points)
  {
    const Eigen::VectorXd distances = shape::ComputeEdgeGeodesics(
      mesh, { { tree.begin(), tree.end() }, Eigen::VectorXd::Zero(tree.size()) });
    // Down to the tree, each time to where the path from there led.
    for (int at = point; distances(at) > 0.0;)
    {
      double best = std::numeric_limits<double>::infinity();
      int next = at;
      for (const int neighbour : neighbours[at])
      {
        const double length =
          distances(neighbour) + (mesh.Points.row(neighbour) - mesh.Points.row(at)).norm();
        if (length < best && distances(neighbour) < distances(at))
        {
          best = length;
          next = neighbour;
        }
      }
      edges.push_back({ at, next });
      tree.insert(at);
      at = next;
    }
  }
  return shape::CutAlongEdges(mesh, edges).Surface;
}

void MapToPlane(benchmark::Figures& figures, const shape::Mesh& mesh, bool hasOneLoop)
{
  const Eigen::MatrixXd none(0, 3);
  shape::ParameterizeOptions options;
  options.Domain = Domain::Disk;
  if (hasOneLoop)
  {
    Report(figures, "Disk", mesh, none, options);
  }
  options.Domain = Domain::FreeBoundary;
  Report(figures, "Conformal", mesh, none, options);
  options.Refine = Refine::SymmetricDirichlet;
  Report(figures, "FreeBoundary", mesh, none, options);
}

void Run(benchmark::Arguments& arguments, benchmark::Figures& figures)
{
  const std::string path = arguments.NextWord();
  arguments.RequireAllRead();
  shape::Mesh mesh = benchmark::ReadOff(path, true);
  const shape::Topology topology = shape::RequireManifold(mesh, "the surface");
  const double genus = 0.5 * (2 - topology.BoundaryLoops - topology.EulerNumber);
  figures.Print(benchmark::Row()
                  .Add("points", mesh.Points.rows())
                  .Add("triangles", mesh.Triangles.rows())
                  .Add("components", topology.Components)
                  .Add("loops", topology.BoundaryLoops)
                  .Add("genus", genus));
  if (topology.Components != 1 || genus != 0.0)
  {
    return;
  }
  mesh = shape::SplitComponents(mesh).front(); // without points that no triangle uses
  if (topology.BoundaryLoops > 0)
  {
    MapToPlane(figures, mesh, topology.BoundaryLoops == 1);
    return;
  }
  mesh = shape::OrientOutwards(mesh);
  Report(figures, "Sphere", mesh, Eigen::MatrixXd(0, 3), {});
  constexpr int branches = 12;
  std::vector<int> far = shape::SampleFarthestPoints(mesh, branches + 1);
  far.erase(far.begin()); // which is anywhere
  shape::ParameterizeOptions options;
  options.Domain = Domain::Orbifold;
  for (const std::size_t cones : { 3, 4 })
  {
    if (far.size() >= cones)
    {
      const std::vector<int> first(far.begin(), far.begin() + static_cast<std::ptrdiff_t>(cones));
      Report(
        figures, "Orbifold" + std::to_string(cones), mesh, mesh.Points(first, Eigen::all), options);
    }
  }
  MapToPlane(figures, CutAlongTree(mesh, far), true);
}

const benchmark::Entry Parameterize("parameterize", { Usage, Run });

} // namespace
