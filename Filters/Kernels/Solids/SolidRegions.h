#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>
#include <vector>

namespace shape
{

/**
 * Which part of space inside closed surfaces is which region of a solid, by how they are nested.
 *
 * Each surface may have several components, none of which crosses another. A component of the first
 * surface (the boundary) inside an even number of others of it bounds solid, RegionId 0; inside an
 * odd number, a void. Components of the other surfaces (material borders) i = 0, 1, ... lie in the
 * solid and bound region i + 1; inside an odd number of others of the same border the region around
 * that border begins again. A position belongs to the innermost component around it.
 *
 * Winding numbers decide which component is around which (Mesh/Mesh.h; Jacobson et al., "Robust
 * inside-outside segmentation", 2013).
 */
class SolidRegions
{
public:
  static constexpr int Void = -1; ///< the region of what is not solid

  /// surfaces: the boundary, then the material borders; each closed and consistently oriented,
  /// facing either way. names: what errors call them. Throws InvalidInput if a component
  /// encloses no volume or a border lies outside the solid, Aborted.
  SolidRegions(const std::vector<Surface>& surfaces, const std::vector<std::string>& names,
    const Progress& progress = {});

  /// The region at a position that lies on no surface.
  int RegionAt(const Eigen::RowVector3d& position) const;

  /// The volume of each region (1 + number of borders).
  const Eigen::VectorXd& Volumes() const { return this->RegionVolumes; }

  /// A connected piece of a surface.
  struct Component
  {
    shape::Surface Surface;       ///< facing outwards, with its own points
    int FirstPoint = -1;          ///< the first of them, by its number in the surface it is of
    Eigen::RowVector3d Low, High; ///< its box
    int Owner = 0;                ///< the index of its surface
    int Parent = -1;              ///< the innermost component around it
    int Region = Void;
    double Volume = 0.0; ///< > 0: all that it encloses
  };
  /// All of them by falling volume: a parent comes before its children.
  const std::vector<Component>& Pieces() const { return this->Components; }

  /// A position inside each void that the solid surrounds (n x 3), far from its walls. Throws
  /// SolveFailure if a void is too thin to find one.
  Eigen::MatrixXd FindPositionsInVoids() const;

private:
  void FindParents(const Progress& progress);
  void FindRegions(const std::vector<std::string>& names);
  bool IsInside(const Eigen::RowVector3d& position, const Component& component) const;
  int InnermostAt(const Eigen::RowVector3d& position) const;

  std::vector<Component> Components; ///< by falling volume
  Eigen::VectorXd RegionVolumes;
};

} // namespace shape
