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

/// The interfaces between a solid's regions, and the inner surfaces that they approximate. If Cells
/// is null, there is no interface.
struct InnerInterfaces
{
  const RegionCells* Cells = nullptr;
  const std::vector<Surface>* Surfaces = nullptr; ///< for each interface: its inner surface

  std::size_t Count() const { return this->Cells ? this->Cells->Interfaces.size() : 0; }
};

/**
 * Layers of hexahedra on both sides of each interface. The quads and points of the interfaces stay
 * unchanged. With the layers, each hexahedron has at most one face on an interface or, if regions
 * touch, on the boundary.
 */
class InterfaceLayers
{
public:
  /// Adds `layers` layers of hexahedra to the mesh on each side of each interface.
  InterfaceLayers(HexMesh& mesh, const InnerInterfaces& interfaces, int layers);

  /// Adds `layers` layers of hexahedra inside the boundary of each region: along interfaces, on
  /// both sides, and along the boundary of the mesh. Interfaces may touch. regionOf: the region of
  /// each hexahedron; the boundary of each region is a manifold.
  InterfaceLayers(HexMesh& mesh, const Eigen::VectorXi& regionOf, int layers);

  /// Returns the region of each hexahedron. hexahedra: the number of hexahedra that the mesh has
  /// now. Hexahedra that were added after construction get region 0.
  Eigen::VectorXi Regions(Eigen::Index hexahedra) const;

  /// Distributes the points of the layers evenly between the interface and the deepest points of
  /// the layers.
  void Spread(Eigen::MatrixXd& points) const;

private:
  void PillowSide(
    HexMesh& mesh, const std::vector<int>& rows, const Eigen::MatrixXi& quads, int layers);

  std::vector<int> RegionOf;
  std::vector<PatchedBoundary> Sides; ///< the copied points on each side of each interface
};

/// Keeps points of the outer boundary on the features of the outer surface, and points of each
/// interface on its inner surface.
class MultiSurfaceConstraint : public PointConstraint
{
public:
  /// points: the number of points of the hexahedra.
  MultiSurfaceConstraint(
    FeatureConstraint outer, const InnerInterfaces& interfaces, Eigen::Index points);

  int Freedom(int point) const override;
  PointDirections Directions(int point, const Eigen::RowVector3d& position) const override;
  Eigen::RowVector3d Nearest(int point, const Eigen::RowVector3d& position) const override;

private:
  const PointConstraint& Of(int point) const;

  FeatureConstraint Outer;
  std::vector<FeatureConstraint> Inner;
  std::vector<int> SurfaceOf; ///< the index of each point's inner surface, or -1
};

/// Returns the largest Hausdorff distance between an interface and its inner surface, or 0 if there
/// is no interface. interfaces: the quads of each interface.
double ComputeInterfaceDistance(const Eigen::MatrixXd& points,
  const std::vector<Eigen::MatrixXi>& interfaces, const std::vector<Surface>& surfaces,
  const Progress& progress = {});

} // namespace shape
