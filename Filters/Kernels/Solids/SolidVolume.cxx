#include "Solids/SolidVolume.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace shape
{
namespace
{

Eigen::RowVector3d FindMedian(Eigen::MatrixXd points)
{
  Eigen::RowVector3d median;
  for (int k = 0; k < 3; ++k)
  {
    auto column = points.col(k);
    const Eigen::Index middle = column.size() / 2;
    std::nth_element(column.begin(), column.begin() + middle, column.end());
    median(k) = column(middle);
  }
  return median;
}

/// The enclosed volume, as tetrahedra over a position. From a point that is far away, the digits of
/// the others would cancel.
double ComputeVolumeAround(const Eigen::RowVector3d& position, const Mesh& mesh)
{
  double sixVolumes = 0.0;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = GetCorners(mesh, t).rowwise() - position;
    sixVolumes += corners.row(0).dot(corners.row(1).cross(corners.row(2)));
  }
  return sixVolumes / 6.0;
}

} // namespace

void RequireVolume(const Surface& surface, const std::string& name)
{
  double volume = 0.0;
  for (const Mesh& component : SplitComponents(surface))
  {
    volume += std::abs(ComputeVolumeAround(FindMedian(component.Points), component));
  }
  const double area = ComputeArea(surface), thickness = area > 0.0 ? 2.0 * volume / area : 0.0;
  // Far above the rounding of volumes.
  constexpr double minimumShare = 1e-12;
  if (!(thickness > minimumShare * ComputeLongestBoxEdge(surface)))
  {
    throw InvalidInput(name + " encloses no volume; give the surface of a solid");
  }
  constexpr double maximumCubes = 1e6;
  const double cubes = volume / std::pow(thickness, 3);
  if (cubes > maximumCubes)
  {
    std::ostringstream words;
    words << name << " is too thin for its size: " << cubes << " cubes of its mean thickness of "
          << thickness
          << " would fill it; remove points that are far away, or scale it along its long side";
    throw InvalidInput(words.str());
  }
}

} // namespace shape
