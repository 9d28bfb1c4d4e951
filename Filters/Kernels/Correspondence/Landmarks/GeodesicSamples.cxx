#include "Correspondence/Landmarks/GeodesicSamples.h"

#include "Geodesics/FarthestPoints.h"
#include "Geodesics/HeatGeodesics.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

Eigen::VectorXd NearestShares(const Eigen::MatrixXd& distances, const Eigen::VectorXd& areas)
{
  // A sample in a fold may be nearest to no point, not even itself, since distances are not exact.
  const double minimum = 1e-3 * areas.sum() / static_cast<double>(distances.cols());
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(distances.cols());
  for (Eigen::Index i = 0; i < areas.size(); ++i)
  {
    Eigen::Index nearest = 0;
    distances.row(i).minCoeff(&nearest);
    shares(nearest) += areas(i);
  }
  shares = shares.cwiseMax(minimum);
  return shares / shares.sum();
}

} // namespace

Eigen::MatrixXd GeodesicSamples::Between() const
{
  // Heat distances from i to j and from j to i differ slightly.
  const Eigen::MatrixXd one = this->Distances(this->Points, Eigen::all);
  return 0.5 * (one + one.transpose());
}

GeodesicSamples SampleSurface(const Surface& surface, int count, const Progress& progress,
  const std::vector<int>& first, int start)
{
  GeodesicSamples sampled;
  const Eigen::VectorXd areas = ComputePointAreas(surface);
  sampled.Length = std::sqrt(areas.sum());
  sampled.Points = first;
  for (const int point : SampleFarthestPoints(surface, count, progress.Part(0.0, 0.3), start))
  {
    if (std::find(first.begin(), first.end(), point) == first.end())
    {
      sampled.Points.push_back(point);
    }
  }
  sampled.Distances =
    ComputeHeatDistances(surface, sampled.Points, progress.Part(0.3, 1.0)) / sampled.Length;
  sampled.Weights = NearestShares(sampled.Distances, areas);
  return sampled;
}

/// Farthest-point samples are nested: the first ones of many are as evenly spread as few ones are.
GeodesicSamples GetFirstSamples(
  const GeodesicSamples& sampled, int count, const Eigen::VectorXd& areas)
{
  GeodesicSamples part;
  const auto size =
    std::min<std::ptrdiff_t>(count, static_cast<std::ptrdiff_t>(sampled.Points.size()));
  part.Points.assign(sampled.Points.begin(), sampled.Points.begin() + size);
  part.Distances = sampled.Distances.leftCols(size);
  part.Weights = NearestShares(part.Distances, areas);
  part.Length = sampled.Length;
  return part;
}

} // namespace shape
