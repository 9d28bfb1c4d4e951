#include "Solids/ConformingRegions.h"

#include "Base/Errors.h"
#include "Mesh/RegionSurfaces.h"
#include "Mesh/Topology.h"
#include "Solids/SurfaceComplex.h"

#include <cmath>
#include <string>

namespace shape
{

ConformingRegions::ConformingRegions(
  const Mesh& surfaces, const Eigen::MatrixXi& labels, const Progress& progress)
{
  const RegionSurfaces regions(surfaces, labels);
  double done = 0.0;
  for (const auto& [label, triangles] : regions.Triangles())
  {
    progress(done++ / static_cast<double>(regions.Triangles().size()));
    const std::string name = "the surface of region " + std::to_string(label);
    Surface surface(regions.Extract(label));
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
  return RegionSurfaces::Outside;
}

} // namespace shape
