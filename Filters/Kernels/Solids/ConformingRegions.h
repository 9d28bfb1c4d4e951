#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <map>

namespace shape
{

/**
 * The regions between the triangles of a conforming surface: each triangle separates two regions,
 * and regions that touch share triangles, as those of ExtractLabelSurfaces do.
 */
class ConformingRegions
{
public:
  /// surfaces: the triangles. labels: m x 2, the labels on both sides of each triangle; the normal
  /// leaves the first. Throws InvalidInput unless the two labels of each triangle differ, and
  /// unless the triangles of each region are a closed, consistently oriented 2-manifold that
  /// encloses a positive volume; Aborted.
  ConformingRegions(
    const Mesh& surfaces, const Eigen::MatrixXi& labels, const Progress& progress = {});

  /// Returns the label at a position that lies on no triangle, or RegionSurfaces::Outside.
  int RegionAt(const Eigen::RowVector3d& position) const;

  /// The boundary of each region, facing outwards, without other points, by label.
  const std::map<int, Surface>& Surfaces() const { return this->Boundaries; }

  /// The volume of each region, by label.
  const std::map<int, double>& Volumes() const { return this->RegionVolumes; }

private:
  std::map<int, Surface> Boundaries; ///< of the regions, facing outwards, by label
  std::map<int, double> RegionVolumes;
};

} // namespace shape
