#pragma once

#include "Hex/Features/RegionNetwork.h"

#include <Eigen/Core>

#include <map>
#include <vector>

namespace shape
{

/**
 * The junctions of a network: corners count as one if a curve with more than three labels connects
 * them, or a short one between corners with the same labels. Four regions seldom meet along a
 * curve, and two regions seldom meet twice near a point: such curves come from the resolution.
 */
struct RegionJunctions
{
  /// points: of the network's mesh. Curves below the length `shortest` are short. isLoose: if not
  /// empty, whether short curves join each corner to others, whatever their labels.
  RegionJunctions(const RegionNetwork& network, const Eigen::MatrixXd& points, double shortest,
    const std::vector<char>& isLoose = {});

  std::vector<char> IsInside;            ///< whether each curve is part of a junction
  std::vector<int> Of;                   ///< the junction of each corner, by index
  std::map<int, int> Number;             ///< the junction of each corner, by point
  std::vector<std::vector<int>> Corners; ///< the points of each junction
  std::vector<std::vector<int>> Labels;  ///< the labels around each junction, ascending
  Eigen::MatrixXd Middles;               ///< the means of their corners, one per row
};

/// The junctions of hexahedra and of surfaces.
struct JunctionMatch
{
  RegionJunctions Own, Wanted;
  std::map<int, int> WantedOf; ///< the junction of the surfaces at each matched one
};

/**
 * Assigns the junctions of hexahedra to those of surfaces with the same labels, the closest first.
 * Where five or more regions meet within a cell, the network of either may have several junctions
 * instead of one: those without a partner are joined along short curves, and assigned again.
 *
 * cellSize: of the grid that the hexahedra were made of.
 */
JunctionMatch MatchJunctions(const RegionNetwork& own, const Eigen::MatrixXd& ownPoints,
  const RegionNetwork& wanted, const Eigen::MatrixXd& wantedPoints, double cellSize);

} // namespace shape
