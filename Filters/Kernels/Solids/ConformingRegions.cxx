#include "Solids/ConformingRegions.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"
#include "Solids/SurfaceComplex.h"

#include <cmath>
#include <string>
#include <vector>

namespace shape
{

ConformingRegions::ConformingRegions(
  const Mesh& surfaces, const Eigen::MatrixXi& labels, const Progress& progress)
{
  if (labels.rows() != surfaces.Triangles.rows() || labels.cols() != 2)
  {
    throw InvalidInput("each triangle must have two labels, those of the regions on its sides");
  }
  std::map<int, std::vector<int>> trianglesOf;
  for (int t = 0; t < static_cast<int>(labels.rows()); ++t)
  {
    if (labels(t, 0) == labels(t, 1))
    {
      throw InvalidInput("triangle " + std::to_string(t) + " has region " +
        std::to_string(labels(t, 0)) +
        " on both sides; remove such triangles, or correct the array Regions");
    }
    for (const int label : { labels(t, 0), labels(t, 1) })
    {
      if (label != Outside)
      {
        trianglesOf[label].push_back(t);
      }
    }
  }
  double done = 0.0;
  for (const auto& [label, triangles] : trianglesOf)
  {
    progress(done++ / static_cast<double>(trianglesOf.size()));
    Mesh boundary = surfaces;
    boundary.Triangles = surfaces.Triangles(triangles, Eigen::all);
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      if (labels(triangles[i], 0) != label)
      {
        boundary.Triangles.row(static_cast<Eigen::Index>(i)).reverseInPlace();
      }
    }
    const std::vector<int> used = FindUsedPoints(boundary.Triangles, boundary.Points.rows());
    boundary.Triangles = RenumberPoints(boundary.Triangles, used, surfaces.Points.rows());
    boundary.Points = surfaces.Points(used, Eigen::all);
    const std::string name = "the surface of region " + std::to_string(label);
    Surface surface(std::move(boundary));
    RequireClosed(surface, name);
    const double volume = ComputeEnclosedVolume(surface);
    if (!(volume > 0.0))
    {
      throw InvalidInput(name +
        " faces inwards; the normal of a triangle must leave the first region of its Regions");
    }
    this->RegionVolumes[label] = volume;
    this->Boundaries.emplace(label, std::move(surface));
  }
  if (this->Boundaries.empty())
  {
    throw InvalidInput("the array Regions has no region but the outside, 0");
  }
}

int ConformingRegions::RegionAt(const Eigen::RowVector3d& position) const
{
  for (const auto& [label, boundary] : this->Boundaries)
  {
    if (ComputeWindingNumber(boundary.Points(), boundary.Triangles(), position) > 0.5)
    {
      return label;
    }
  }
  return Outside;
}

} // namespace shape
