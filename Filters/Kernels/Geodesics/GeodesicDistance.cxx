#include "Geodesics/GeodesicDistance.h"

#include "Base/Errors.h"
#include "Geodesics/EdgeGeodesics.h"
#include "Geodesics/ExactGeodesics.h"
#include "Geodesics/HeatGeodesics.h"
#include "Mesh/SoundTriangles.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"

#include <cmath>

namespace shape
{
namespace
{

using MethodType = GeodesicDistanceOptions::MethodType;

/// The corners of the triangles that contain the positions, and their distances. Edges start at
/// points: the path from a seed inside a triangle begins with a straight piece to a corner.
GraphSources CornersAround(const Mesh& mesh, const ClosestPoints& positions)
{
  GraphSources seeds;
  seeds.Distances.resize(3 * positions.Triangles.size());
  for (Eigen::Index i = 0; i < positions.Triangles.size(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int point = mesh.Triangles(positions.Triangles(i), k);
      seeds.Distances(3 * i + k) = (mesh.Points.row(point) - positions.Positions.row(i)).norm();
      seeds.Nodes.push_back(point);
    }
  }
  return seeds;
}

Eigen::VectorXd Distances(
  const Surface& surface, const ClosestPoints& seeds, MethodType method, const Progress& progress)
{
  switch (method)
  {
    case MethodType::Exact:
      return ComputeExactGeodesics(surface, seeds, progress);
    case MethodType::Dijkstra:
      return ComputeEdgeGeodesics(surface, CornersAround(surface, seeds), progress);
    case MethodType::Heat:
      break;
  }
  return GetHeatGeodesics(surface, progress)->Distances(seeds);
}

} // namespace

GeodesicDistanceResult ComputeGeodesicDistance(const Surface& surface, const Eigen::MatrixXd& seeds,
  const GeodesicDistanceOptions& options, const Progress& progress)
{
  if (options.Method == MethodType::Exact)
  {
    RequireManifold(surface, "the surface");
  }
  else
  {
    RequireTriangles(surface, "the surface");
  }
  RequireFinite(seeds, "the Seeds");
  if (seeds.rows() == 0)
  {
    throw InvalidInput("the Seeds have no points; give at least one position to measure from");
  }
  const ClosestPoints positions = SurfaceLocator(surface).Find(
    seeds, progress.Part(0.0, 0.1, "finding the seeds on the surface"));
  GeodesicDistanceResult result;
  result.Distances = Distances(
    surface, positions, options.Method, progress.Part(0.1, 1.0, "computing geodesic distances"));
  for (double& distance : result.Distances)
  {
    if (std::isinf(distance))
    {
      distance = -1.0;
      ++result.Unreached;
    }
  }
  progress(1.0);
  return result;
}

} // namespace shape
