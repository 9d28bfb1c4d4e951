#include "Correspondence/Landmarks/FeaturedSurface.h"

#include "Correspondence/Landmarks/LandmarkEmbedding.h"
#include "Correspondence/Landmarks/Private/PersistentMaxima.h"
#include "Geodesics/EdgeGeodesics.h"
#include "Geodesics/FarthestPoints.h"
#include "Geodesics/HeatGeodesics.h"
#include "Mesh/HalfEdges.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

/// Adds the points farthest from `points` along edges until there are `count`, or no more points.
void AddFarthest(
  const Surface& surface, std::vector<int>& points, int count, const Progress& progress)
{
  while (static_cast<int>(points.size()) < count)
  {
    const auto size = static_cast<Eigen::Index>(points.size());
    Eigen::Index farthest = 0;
    ComputeEdgeGeodesics(surface, { points, Eigen::VectorXd::Zero(size) }, progress)
      .maxCoeff(&farthest);
    if (std::find(points.begin(), points.end(), static_cast<int>(farthest)) != points.end())
    {
      return;
    }
    points.push_back(static_cast<int>(farthest));
  }
}

/// The distances of the points from the boundary along edges (n); infinite without a boundary.
Eigen::VectorXd BoundaryDistances(const Surface& surface, const Progress& progress)
{
  const Eigen::MatrixXi& triangles = surface.Triangles();
  const std::vector<int>& twins = surface.Twins();
  std::vector<int> boundary;
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    if (twins[side] < 0)
    {
      boundary.push_back(
        triangles(side / 3, side % 3)); // the other end is the start of the next edge
    }
  }
  const auto size = static_cast<Eigen::Index>(boundary.size());
  return ComputeEdgeGeodesics(surface, { boundary, Eigen::VectorXd::Zero(size) }, progress);
}

} // namespace

FeaturedSurface FindFeatures(
  const Surface& surface, int samples, int features, const Progress& progress)
{
  // Relative to the root of the area.
  constexpr double minimum = 0.02; // persistence; less is noise
  constexpr int fewest = 6;
  // Candidates may be about equally good, so that the samples decide between them: these do not
  // depend on the numbers of the points.
  const GeodesicSamples sampled =
    SampleSurface(surface, samples, progress.Part(0.0, 0.9), {}, FindRemotestPoint(surface));
  // Hilaga et al., section 3.1: the integral of geodesic distance, here the mean over area-weighted
  // samples. It is largest at the tips of extremities.
  const Eigen::VectorXd remoteness = sampled.Distances * sampled.Weights;
  FeaturedSurface found;
  found.Features = FindPersistentMaxima(surface.Triangles(), remoteness, minimum, features);
  AddFarthest(surface, found.Features, fewest, progress.Part(0.9, 0.9));
  const Eigen::MatrixXd distances =
    ComputeHeatDistances(surface, found.Features, progress.Part(0.9, 1.0)) / sampled.Length;
  const Eigen::MatrixXd apart = distances(found.Features, Eigen::all);
  found.Remoteness = remoteness(found.Features);
  found.DistanceToBoundary =
    BoundaryDistances(surface, progress.Part(1.0, 1.0))(found.Features) / sampled.Length;
  found.Apart = 0.5 * (apart + apart.transpose());
  found.Samples = sampled.Points;
  found.Weights = sampled.Weights;
  found.Between = sampled.Between();
  found.ToFeatures = distances(sampled.Points, Eigen::all);
  found.Turns = ComputeGradientOrientations(surface, distances, sampled.Points);
  return found;
}

FeaturedSurface RestrictToPart(const FeaturedSurface& surface, double share)
{
  constexpr double minimum = 0.1; // from the boundary, over the root of the area
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
    scale * surface.DistanceToBoundary(kept), scale * surface.Apart(kept, kept), surface.Samples,
    surface.Weights, scale * surface.Between, scale * surface.ToFeatures(Eigen::all, kept),
    surface.Turns(Eigen::all, columns) };
  for (const int i : kept)
  {
    part.Features.push_back(surface.Features[i]);
  }
  return part;
}

} // namespace shape
