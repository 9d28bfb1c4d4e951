#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

#include <vector>

namespace shape
{

struct HexOptimizationOptions
{
  int Sweeps = 6;       ///< over all points, at each sharpness; >= 0
  int WorstSweeps = 60; ///< over the points of bad hexahedra, at each greater sharpness; >= 0
  double Bad = 0.7;     ///< hexahedra of a lower scaled Jacobian are bad
  /// The worst are raised only where no scaled Jacobian is this low before.
  double RaiseFrom = 0.0;
  /// While the worst are below this they are raised again by more sweeps, as long as that helps and
  /// at most a tenth of the points are near such.
  double RaiseTo = 0.0;
  double RaiseAgainFrom = 0.0; ///< where the worst is lower, that is not done
  /// n: points that move, but for what is inverted; empty: all.
  std::vector<char> Marked = {};
};

struct HexOptimizationResult
{
  double MinimumBefore = 0.0, MinimumAfter = 0.0; ///< scaled Jacobians
  int InvertedBefore = 0, InvertedAfter = 0;      ///< hexahedra with a scaled Jacobian of 0 or less
};

/**
 * Moves the points of hexahedra so that the worst scaled Jacobian becomes as good as it can.
 *
 * Point by point, the sum of exp(k (1 - s)) over the corners around it is lowered by a Newton step
 * with a line search (StarEnergy), for k that grows from 2 to 20; then k = 25 to 90 for the points
 * of bad hexahedra only, which raises the worst corners at little cost of the others (the l_p to
 * l_infinity continuation of Livesu, Sheffer, Vining and Tarini, "Practical hex-mesh optimization
 * via edge-cone rectification", 2015, with the determinants themselves). Inverted hexahedra have a
 * finite energy, too, and most are turned by the first gentle sweeps; the others are untangled
 * (UntangleHexahedra) before sharper ones are spent on them. Where some stay, all is done again.
 *
 * mesh: its points, each where it may be, are moved, and none is ever elsewhere: what is reported
 * holds for the result as it is. Points are moved in sets
 * without a common hexahedron, so any number of threads gives the same bits. Throws InvalidInput
 * where an index is out of range or options are negative, Aborted.
 */
HexOptimizationResult OptimizeHexahedra(HexMesh& mesh, const PointConstraint& constraint,
  const HexOptimizationOptions& options = {}, const Progress& progress = {});

/// Moves every point half way to the middle of those neighbours that are as little free as it is,
/// `sweeps` times, and puts it where it may be. Throws InvalidInput where an index is out of range.
/// Throws Aborted.
void SmoothHexahedra(
  HexMesh& mesh, const PointConstraint& constraint, int sweeps, const Progress& progress = {});

/// The same around inverted hexahedra, farther and farther from them, up to ten times.
void SmoothInverted(
  HexMesh& mesh, const PointConstraint& constraint, const Progress& progress = {});

} // namespace shape
