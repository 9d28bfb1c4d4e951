#pragma once

#include "Hex/Features/RegionNetwork.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <map>
#include <utility>
#include <vector>

namespace shape
{

/// What hexahedra of regions are matched with: the surfaces between the regions, and what is
/// derived from them once for all grids.
struct RegionTargets
{
  /// surfaces, labels: as for ConformingRegions.
  RegionTargets(const Mesh& surfaces, const Eigen::MatrixXi& labels);

  Surface Surfaces;                           ///< all of them
  Eigen::MatrixXi Labels;                     ///< m x 2: those of each triangle
  std::vector<Surface> Patches;               ///< a surface for each pair of labels
  std::map<std::pair<int, int>, int> PatchOf; ///< the patch of each pair, ascending
  RegionNetwork Network;                      ///< the curves where three or more regions meet
  std::vector<Eigen::MatrixXd> CurvePoints;   ///< for each curve: its points in order
};

} // namespace shape
