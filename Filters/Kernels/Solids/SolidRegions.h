#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>
#include <vector>

namespace shape
{

/**
 * The regions of a solid inside closed surfaces, determined by how the surfaces are nested.
 *
 * Each surface may have several components; no two components cross. A component of the first
 * surface (the boundary) inside an even number of its other components bounds solid, RegionId 0;
 * inside an odd number, a void. Components of the other surfaces (material borders) i = 0, 1, ...
 * lie in the solid and bound region i + 1. If one lies inside an odd number of others of the same
 * border, the region around that border continues inside it. A position belongs to the innermost
 * component around it.
 *
 * Winding numbers decide which component contains which (Mesh/Mesh.h; Jacobson et al., "Robust
 * inside-outside segmentation", 2013).
 */
class SolidRegions
{
public:
  static constexpr int Void = -1; ///< the region of positions outside the solid

  /// surfaces: the boundary, then the material borders; each closed and consistently oriented,
  /// facing either way. names: used for them in messages. Throws InvalidInput if a component
  /// encloses no volume or a border lies outside the solid; Aborted.
  SolidRegions(const std::vector<Surface>& surfaces, const std::vector<std::string>& names,
    const Progress& progress = {});

  /// Returns the region at a position that lies on no surface.
  int RegionAt(const Eigen::RowVector3d& position) const;

  /// The volume of each region (1 + number of borders).
  const Eigen::VectorXd& Volumes() const { return this->RegionVolumes; }

  /// A connected piece of a surface.
  struct Component
  {
    shape::Surface Surface;       ///< facing outwards, with its own points
    int FirstPoint = -1;          ///< the index in its surface of its first point
    Eigen::RowVector3d Low, High; ///< its bounding box
    int Owner = 0;                ///< the index of its surface
    int Parent = -1;              ///< the innermost component around it, or -1
    int Region = Void;            ///< the region that it bounds from outside
    double Volume = 0.0;          ///< the volume that it encloses, > 0
  };
  /// All components by descending volume; a parent comes before its children.
  const std::vector<Component>& Pieces() const { return this->Components; }

  /// Returns a position inside each void that the solid surrounds (n x 3), far from its walls.
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
