#include "Correspondence/FeaturedSurface.h"

#include "Correspondence/LandmarkPlaces.h"
#include "Correspondence/PersistentMaxima.h"
#include "Surface/EdgeGeodesics.h"
#include "Surface/HeatGeodesics.h"

#include <algorithm>

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
    EdgeGeodesics(mesh, { points, Eigen::VectorXd::Zero(size) }, progress).maxCoeff(&farthest);
    if (std::find(points.begin(), points.end(), static_cast<int>(farthest)) != points.end())
    {
      return;
    }
    points.push_back(static_cast<int>(farthest));
  }
}

} // namespace

FeaturedSurface FindFeatures(const Mesh& mesh, int samples, int features, const Progress& progress)
{
  constexpr double least = 0.02; // persistence; less is noise
  constexpr int fewest = 6;
  const SampledSurface sampled = SampleSurface(mesh, samples, progress.Part(0.0, 0.9));
  const Eigen::VectorXd remoteness = sampled.Distances * sampled.Weights;
  FeaturedSurface surface;
  surface.Features = PersistentMaxima(mesh.Triangles, remoteness, least, features);
  AddFarthest(mesh, surface.Features, fewest, progress.Part(0.9, 0.9));
  const Eigen::MatrixXd distances =
    HeatDistances(mesh, surface.Features, progress.Part(0.9, 1.0)) / sampled.Length;
  const Eigen::MatrixXd apart = distances(surface.Features, Eigen::all);
  surface.Remoteness = remoteness(surface.Features);
  surface.Apart = 0.5 * (apart + apart.transpose());
  surface.Weights = sampled.Weights;
  surface.Between = sampled.Between();
  surface.ToFeatures = distances(sampled.Points, Eigen::all);
  surface.Turns = DirectionTurns(mesh, distances, sampled.Points);
  return surface;
}

} // namespace shape
