#include "Correspondence/SampledSurface.h"

#include "Core/Errors.h"
#include "Core/Topology.h"
#include "Surface/FarthestPoints.h"
#include "Surface/HeatGeodesics.h"

#include <algorithm>
#include <cmath>

namespace shape
{

Eigen::MatrixXd SampledSurface::Between() const
{
  const Eigen::MatrixXd one = this->Distances(this->Points, Eigen::all);
  return 0.5 * (one + one.transpose());
}

SampledSurface SampleSurface(const Mesh& mesh, int count, const Progress& progress)
{
  SampledSurface sampled;
  const Eigen::VectorXd areas = PointAreas(mesh);
  sampled.Length = std::sqrt(areas.sum());
  sampled.Points = FarthestPoints(mesh, count, progress.Part(0.0, 0.3));
  sampled.Distances = HeatDistances(mesh, sampled.Points, progress.Part(0.3, 1.0)) / sampled.Length;
  sampled.Weights = Eigen::VectorXd::Zero(sampled.Distances.cols());
  for (Eigen::Index i = 0; i < areas.size(); ++i)
  {
    Eigen::Index nearest = 0;
    sampled.Distances.row(i).minCoeff(&nearest);
    sampled.Weights(nearest) += areas(i) / areas.sum();
  }
  return sampled;
}

void RequireConnected(const Mesh& mesh, const std::string& name)
{
  const Topology topology = RequireManifold(mesh, name);
  if (topology.Components > 1)
  {
    throw InvalidInput(name + " has " + std::to_string(topology.Components) +
      " components, between which there are no distances; keep one with Connectivity / Extract "
      "Largest");
  }
  const auto unused = (topology.ComponentId.array() < 0).count();
  if (unused > 0)
  {
    const auto first = std::find(topology.ComponentId.begin(), topology.ComponentId.end(), -1) -
      topology.ComponentId.begin();
    throw InvalidInput(name + " has " + std::to_string(unused) +
      " points that no triangle uses (first at point " + std::to_string(first) +
      "); remove them with Clean");
  }
  const double area = PointAreas(mesh).sum();
  if (!(area > 0.0 && std::isfinite(area)))
  {
    throw InvalidInput(name + " has no area that double precision can hold (its longest side is " +
      std::to_string(LongestSide(mesh.Points)) + "); scale it or check its coordinates");
  }
}

} // namespace shape
