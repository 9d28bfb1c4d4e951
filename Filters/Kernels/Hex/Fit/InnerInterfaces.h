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

/// The interfaces between a solid's regions, and the inner surfaces that they approximate. There
/// are none if Cells is null.
struct InnerInterfaces
{
  const RegionCells* Cells = nullptr;
  const std::vector<Surface>* Surfaces = nullptr; ///< the inner surface of each interface

  std::size_t Count() const { return this->Cells ? this->Cells->Interfaces.size() : 0; }
};

/**
 * Layers of hexahedra on both sides of the interfaces, whose quads and points stay unchanged. Each
 * hexahedron then has at most one face on an interface.
 */
class InterfaceLayers
{
public:
  /// Adds `layers` layers on each side of the interfaces to the mesh. Both arguments must outlive
  /// this object.
  InterfaceLayers(HexMesh& mesh, const InnerInterfaces& interfaces, int layers);

  /// Returns the region of each of `hexahedra` hexahedra; those added later belong to region 0.
  Eigen::VectorXi Regions(Eigen::Index hexahedra) const;

  /// Distributes the points of the layers evenly between the interface and the next points beyond.
  void Spread(Eigen::MatrixXd& points) const;

private:
  void PillowSide(
    HexMesh& mesh, const std::vector<char>& side, const Eigen::MatrixXi& quads, int layers);

  std::vector<int> RegionOf;
  std::vector<PatchedBoundary> Sides; ///< the copied points on each side of each interface
};

/// Keeps points of the outer boundary on its features, and points of interfaces on inner surfaces.
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

/// Returns the largest Hausdorff distance between an interface (the quads of each) and its inner
/// surface; 0 if there are none.
double ComputeInterfaceDistance(const Eigen::MatrixXd& points,
  const std::vector<Eigen::MatrixXi>& interfaces, const std::vector<Surface>& surfaces,
  const Progress& progress = {});

} // namespace shape
