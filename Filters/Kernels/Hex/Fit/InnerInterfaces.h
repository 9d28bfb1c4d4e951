#pragma once

#include "Hex/Features/FeatureConstraint.h"
#include "Hex/Features/PatchedBoundary.h"
#include "Hex/Voxels/MultiMaterialVoxels.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Surface.h"
#include "Untangle/MinimizeEnergy.h"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace shape
{

/// Where hexahedra of a solid's regions meet, near surfaces inside it. Without Cells there are
/// none.
struct InnerInterfaces
{
  const RegionCells* Cells = nullptr;
  const std::vector<Surface>* Surfaces = nullptr; ///< one for each of the interfaces

  std::size_t Count() const { return this->Cells ? this->Cells->Interfaces.size() : 0; }
};

/**
 * The layers of hexahedra on both sides of the quads of interfaces, which stay and keep their
 * points: then each hexahedron has at most one face on an interface.
 */
class InterfaceLayers
{
public:
  /// Adds them to the cells of the interfaces, as many as `layers` on each side. Both arguments
  /// must outlive this.
  InterfaceLayers(HexMesh& mesh, const InnerInterfaces& interfaces, int layers);

  /// Of each hexahedron of a mesh of this many; those that were added later are of region 0.
  Eigen::VectorXi Regions(Eigen::Index hexahedra) const;

  /// Puts the points of layers evenly between the interface and what is beyond them.
  void Spread(Eigen::MatrixXd& points) const;

private:
  void PillowSide(
    HexMesh& mesh, const std::vector<char>& side, const Eigen::MatrixXi& quads, int layers);

  std::vector<int> RegionOf;
  std::vector<PatchedBoundary> Sides; ///< the copies of points on each side of each interface
};

/// Points of the outer boundary keep to its features, those of interfaces to inner surfaces.
class MultiSurfaceConstraint : public PointConstraint
{
public:
  /// points: how many the hexahedra have.
  MultiSurfaceConstraint(
    FeatureConstraint outer, const InnerInterfaces& interfaces, Eigen::Index points);

  int Freedom(int point) const override;
  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override;

private:
  const PointConstraint& Of(int point) const;

  FeatureConstraint Outer;
  std::vector<FeatureConstraint> Inner;
  std::vector<int> SurfaceOf; ///< of each point the inner surface, or -1
};

/// The larger one-sided Hausdorff distance between interfaces (quads of each) and their surfaces; 0
/// without any.
double ComputeInterfaceDistance(const Eigen::MatrixXd& points,
  const std::vector<Eigen::MatrixXi>& interfaces, const std::vector<Surface>& surfaces,
  const Progress& progress = {});

} // namespace shape
