#pragma once

namespace shape
{

struct HexFit;

/// Hexahedra of a polycube are accepted without comparison with a grid if their minimum scaled
/// Jacobian is at least this, and their distance from the surface at most this fraction of its
/// diagonal.
inline constexpr double AcceptedScaledJacobian = 0.3, AcceptedDistance = 0.01;

/// Whether hexahedra of a grid, if it is tried first, are accepted without a polycube. diagonal: of
/// the surface's box.
bool IsGoodGrid(const HexFit& fit, double diagonal);

/// Whether hexahedra of a polycube are accepted without a grid.
bool IsGoodPolycube(const HexFit& fit, double diagonal);

/// Valid hexahedra are better than others, then those with more creases, then those that are
/// closer.
bool IsBetter(const HexFit& one, const HexFit& other);

} // namespace shape
