#pragma once

#include "Hex/Grid/GridHexesResult.h"

namespace shape
{

/// If the result has at least this scaled Jacobian, cells are not made smaller everywhere.
inline constexpr double AcceptedScaledJacobian = 0.55;

/// The factor by which cells shrink if they do not have the topology of the surface.
inline constexpr double Shrinkage = 0.85;

/// The quality that hexahedra should reach; distances in the surface's units.
struct GridGoals
{
  /// diagonal: of the surface's bounding box.
  GridGoals(const GridHexesOptions& options, double diagonal);

  double ScaledJacobian, Distance, CreaseDistance;
  double AcceptedDistance; ///< like AcceptedScaledJacobian
  /// What is farther than this is not snapped to, but needs another grid.
  double NearDistance;
  double SnapFrom; ///< the boundary is snapped if it is farther than this
};

/// Whether the hexahedra have at least this scaled Jacobian and at most this distance.
bool Reaches(const GridHexesResult& result, double scaledJacobian, double distance);

bool IsAsWanted(const GridHexesResult& result, const GridGoals& goals);

/// Whether the result is good enough not to make cells smaller everywhere: all of it, or everything
/// except hexahedra at preserved corners, which other grids have as well.
bool IsAccepted(const GridHexesResult& result, const GridGoals& goals);

/// Whether snapping is likely to reach the accepted distance.
bool IsNear(const GridHexesResult& result, const GridGoals& goals);

/// Greater is better. Without inverted hexahedra, preserved creases and acceptance add 1 each.
double Score(const GridHexesResult& result, const GridGoals& goals);

} // namespace shape
