#include "Correspondence/Landmarks/Private/FeaturedSurface.h"

#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Correspondence/Landmarks/Private/PersistentMaxima.h"
#include "Geodesics/EdgeGeodesics.h"
#include "Geodesics/HeatGeodesics.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

/// Adds the points farthest along edges from `points` until there are `count`, or all.
void AddFarthest(const Mesh& mesh, std::vector<int>& points, int count, const Progress& progress)
{
  while (static_cast<int>(points.size()) < count)
  {
    const auto size = static_cast<Eigen::Index>(points.size());
    Eigen::Index farthest = 0;
    ComputeEdgeGeodesics(mesh, { points, Eigen::VectorXd::Zero(size) }, progress)
      .maxCoeff(&farthest);
    if (std::find(points.begin(), points.end(), static_cast<int>(farthest)) != points.end())
    {
      return;
    }
    points.push_back(static_cast<int>(farthest));
  }
}

/// How far points are from the border along edges (n), infinite without one.
Eigen::VectorXd BoundaryDistances(const Mesh& mesh, const Progress& progress)
{
  const std::vector<int> twins = FindTwins(mesh.Triangles, mesh.Points.rows());
  std::vector<int> boundary;
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    if (twins[side] < 0)
    {
      boundary.push_back(mesh.Triangles(side / 3, side % 3)); // the other end begins the next side
    }
  }
  const auto size = static_cast<Eigen::Index>(boundary.size());
  return ComputeEdgeGeodesics(mesh, { boundary, Eigen::VectorXd::Zero(size) }, progress);
}

} // namespace

FeaturedSurface FindFeatures(const Mesh& mesh, int samples, int features, const Progress& progress)
{
  constexpr double minimum = 0.02; // persistence; less is noise
  constexpr int fewest = 6;
  const SampledSurface sampled = SampleSurface(mesh, samples, progress.Part(0.0, 0.9));
  const Eigen::VectorXd remoteness = sampled.Distances * sampled.Weights;
  FeaturedSurface surface;
  surface.Features = FindPersistentMaxima(mesh.Triangles, remoteness, minimum, features);
  AddFarthest(mesh, surface.Features, fewest, progress.Part(0.9, 0.9));
  const Eigen::MatrixXd distances =
    ComputeHeatDistances(mesh, surface.Features, progress.Part(0.9, 1.0)) / sampled.Length;
  const Eigen::MatrixXd apart = distances(surface.Features, Eigen::all);
  surface.Remoteness = remoteness(surface.Features);
  surface.DistanceToBoundary =
    BoundaryDistances(mesh, progress.Part(1.0, 1.0))(surface.Features) / sampled.Length;
  surface.Apart = 0.5 * (apart + apart.transpose());
  surface.Weights = sampled.Weights;
  surface.Between = sampled.Between();
  surface.ToFeatures = distances(sampled.Points, Eigen::all);
  surface.Turns = ComputeGradientOrientations(mesh, distances, sampled.Points);
  return surface;
}

FeaturedSurface RestrictToPart(const FeaturedSurface& surface, double share)
{
  constexpr double minimum = 0.1; // from the border, over the root of the area
  const Eigen::Index all = surface.DistanceToBoundary.size();
  const double scale = std::sqrt(share);
  std::vector<int> kept, columns;
  for (int i = 0; i < static_cast<int>(all); ++i)
  {
    if (surface.DistanceToBoundary(i) >= minimum)
    {
      kept.push_back(i);
    }
  }
  for (const int i : kept)
  {
    for (const int j : kept)
    {
      columns.push_back(i * static_cast<int>(all) + j);
    }
  }
  FeaturedSurface part{ {}, scale * surface.Remoteness(kept),
    scale * surface.DistanceToBoundary(kept), scale * surface.Apart(kept, kept), surface.Weights,
    scale * surface.Between, scale * surface.ToFeatures(Eigen::all, kept),
    surface.Turns(Eigen::all, columns) };
  for (const int i : kept)
  {
    part.Features.push_back(surface.Features[i]);
  }
  return part;
}

} // namespace shape
