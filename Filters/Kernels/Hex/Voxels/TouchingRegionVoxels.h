#pragma once

#include "Base/Progress.h"
#include "Hex/Voxels/RegionMeetings.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"
#include "Mesh/Topology.h"
#include "Solids/ConformingRegions.h"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace shape
{

/// The interfaces between regions that touch, as ExtractLabelSurfaces makes them.
struct LabelledSurfaces
{
  Mesh Surfaces;          ///< each interface occurs once
  Eigen::MatrixXi Labels; ///< m x 2: see ConformingRegions
  /// An orthonormal frame, as columns: the axes of the grid that fills the regions.
  Eigen::Matrix3d Frame = Eigen::Matrix3d::Identity();
};

/// The cells of regions that touch.
struct LabelledCells
{
  double CellSize = 0.0;
  HexMesh Solid;
  Eigen::VectorXi RegionOf; ///< m: the label of the region of each cell
};

/**
 * Fills regions that touch with cells of a grid. Each cell gets the region at its centre; then
 * single cells change until each region, and the outside, is well-composed (RepairRegions), and
 * has as many parts as its surface encloses. The boundary of each region's cells is then a
 * manifold.
 */
class TouchingRegionVoxels
{
public:
  /// Throws InvalidInput under the conditions of ConformingRegions; Aborted.
  TouchingRegionVoxels(
    const Mesh& surfaces, const Eigen::MatrixXi& labels, const Progress& progress = {});

  const ConformingRegions& Regions() const { return this->Bounded; }

  /// Returns a size of cells such that these cells and one layer of hexahedra along both sides of
  /// all surfaces are about `hexahedra` in number; if regions meet at curves, also one sheet
  /// (InsertRegionSheets).
  double CellSizeFor(double hexahedra) const;

  /// Returns the cells of this size; nothing if a region has another Euler number or another number
  /// of components than its surface. Throws InvalidInput under the conditions of BuildGridAround;
  /// Aborted.
  std::optional<LabelledCells> Fill(double size, const Progress& progress = {});

  /// Says in which region the last cells differed from the surface; empty if in none.
  const std::string& Difference() const { return this->Wrong; }

private:
  bool HaveTopology(const LabelledCells& cells);

  Mesh Whole;
  ConformingRegions Bounded;
  std::vector<int> Labels;        ///< of the regions, in the order of their numbers; 0 first
  std::vector<int> Parts;         ///< for each number: the number of connected parts
  std::map<int, Topology> Wanted; ///< of each region's surface, by label
  RegionMeetings Meetings;        ///< of the surfaces
  std::string Wrong;
};

} // namespace shape
