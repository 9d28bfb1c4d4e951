#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>
#include <vector>

namespace shape
{

/**
 * The regions of a solid. The nesting of closed surfaces determines them.
 *
 * Each surface may have several components; no two components cross. The first surface is the
 * boundary. A component of the boundary bounds region 0 if it lies inside an even number of the
 * boundary's other components. It bounds a void if it lies inside an odd number of them. The other
 * surfaces, i = 0, 1, ..., are material borders in the solid. A component of border i bounds region
 * i + 1 if it lies inside an even number of the border's other components. If it lies inside an odd
 * number of them, it bounds a hole in region i + 1, where the region around that border continues.
 * The innermost component around a position determines its region.
 *
 * Winding numbers decide which component contains which (Mesh/Mesh.h; Jacobson et al., "Robust
 * inside-outside segmentation", 2013).
 */
class SolidRegions
{
public:
  static constexpr int Void = -1; ///< the region of positions outside the solid

  /// surfaces: the boundary, then the material borders. Each is closed and consistently oriented,
  /// facing either way. names: denote the surfaces in messages. Throws InvalidInput if a component
  /// encloses no volume, or if a border lies outside the solid; Aborted.
  SolidRegions(const std::vector<Surface>& surfaces, const std::vector<std::string>& names,
    const Progress& progress = {});

  /// Returns the region at a position that lies on no surface.
  int RegionAt(const Eigen::RowVector3d& position) const;

  /// The volumes of the regions, one more than there are borders.
  const Eigen::VectorXd& Volumes() const { return this->RegionVolumes; }

  /// A connected piece of a surface.
  struct Component
  {
    shape::Surface Surface;       ///< its triangles, facing outwards, and its points only
    int FirstPoint = -1;          ///< its first point, as an index of a point of its surface
    Eigen::RowVector3d Low, High; ///< its bounding box
    int Owner = 0;                ///< index of the surface that it belongs to
    int Parent = -1;              ///< index of the innermost component around it, or -1
    int Region = Void;            ///< the region directly inside it
    double Volume = 0.0;          ///< the volume that it encloses, > 0
  };
  /// All components by descending volume; a parent comes before its children.
  const std::vector<Component>& Pieces() const { return this->Components; }

  /// Returns one position in each void that the solid surrounds (n x 3), far from the void's walls.
  /// Throws SolveFailure if a void is too thin.
  Eigen::MatrixXd FindPositionsInVoids() const;

private:
  void FindParents(const Progress& progress);
  void FindRegions(const std::vector<std::string>& names);
  bool IsInside(const Eigen::RowVector3d& position, const Component& component) const;
  int InnermostAt(const Eigen::RowVector3d& position) const;

  std::vector<Component> Components; ///< by descending volume
  Eigen::VectorXd RegionVolumes;
};

} // namespace shape
