#pragma once

namespace shape
{

struct HexFit;

/// Hexahedra of a polycube are accepted without comparison with a grid if their minimum scaled
/// Jacobian is at least this, and their distances from the surface and from its creases are at most
/// these fractions of its diagonal. A grid's WantedCreaseDistance is the same.
inline constexpr double AcceptedScaledJacobian = 0.3, AcceptedDistance = 0.01,
                        AcceptedCreaseDistance = 0.001;

/// Whether hexahedra of a grid, if it is tried first, are accepted without a polycube. diagonal: of
/// the surface's box.
bool IsGoodGrid(const HexFit& fit, double diagonal);

/// Whether hexahedra of a polycube are accepted without a grid. nearCreases: creases up to this
/// distance are near; infinite if the distance does not count.
bool IsGoodPolycube(const HexFit& fit, double diagonal, double nearCreases);

/// Valid hexahedra are better than others, then those with more creases, then those whose creases
/// alone are near, if their scaled Jacobians are accepted, then those that are closer.
bool IsBetter(const HexFit& one, const HexFit& other, double nearCreases);

} // namespace shape
