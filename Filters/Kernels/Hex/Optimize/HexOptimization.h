#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

#include <vector>

namespace shape
{

struct HexOptimizationOptions
{
  int Sweeps = 6;       ///< sweeps over all points, at each sharpness; >= 0
  int WorstSweeps = 60; ///< sweeps over points of bad hexahedra, at each greater sharpness; >= 0
  double Bad = 0.7;     ///< hexahedra with a lower scaled Jacobian are bad
  /// The worst hexahedra are improved further only if the minimum scaled Jacobian is greater.
  double RaiseFrom = 0.0;
  /// Further sweeps are spent while the minimum is below this value, as long as they help and at
  /// most a tenth of the points are near hexahedra below it.
  double RaiseTo = 0.0;
  double RaiseAgainFrom = 0.0; ///< no further sweeps are spent if the minimum is lower than this
  /// n: which points may move; ignored while hexahedra are untangled. Empty: all points.
  std::vector<char> Marked = {};
};

struct HexOptimizationResult
{
  double MinimumBefore = 0.0, MinimumAfter = 0.0; ///< minimum scaled Jacobians
  int InvertedBefore = 0, InvertedAfter = 0;      ///< hexahedra with a scaled Jacobian <= 0
};

/**
 * Moves the points of hexahedra to maximise the minimum scaled Jacobian.
 *
 * For each point in turn, a Newton step with a line search lowers the sum of exp(k (1 - s)) over
 * the corners around it (StarEnergy), for k from 2 to 20. Then k = 25 to 90 for the points of bad
 * hexahedra only, which raises the worst corners at little cost to the others. This is the l_p to
 * l_infinity continuation of Livesu, Sheffer, Vining and Tarini, "Practical hex-mesh optimization
 * via edge-cone rectification", 2015, applied to the determinants themselves.
 *
 * The energy is finite for inverted hexahedra, too, and the first sweeps, of low sharpness, repair
 * most of them. The rest are untangled (UntangleHexahedra) before the sweeps of higher sharpness.
 * If some stay inverted, all of this is repeated once.
 *
 * mesh: its points are moved; the constraint holds throughout, so the reported values hold for the
 * returned points. Points are moved in sets that share no hexahedron, so any number of threads
 * gives the same bits. Throws InvalidInput if an index is out of range or an option is negative;
 * Aborted.
 */
HexOptimizationResult OptimizeHexahedra(HexMesh& mesh, const PointConstraint& constraint,
  const HexOptimizationOptions& options = {}, const Progress& progress = {});

/// Moves every point half way to the mean of its neighbours that have the same or less freedom, and
/// does this `sweeps` times; then projects the points to where the constraint allows them. Throws
/// InvalidInput if an index is out of range; Aborted.
void SmoothHexahedra(
  HexMesh& mesh, const PointConstraint& constraint, int sweeps, const Progress& progress = {});

/// Does the same around inverted hexahedra, in a neighbourhood that grows for up to ten rounds.
void SmoothInverted(
  HexMesh& mesh, const PointConstraint& constraint, const Progress& progress = {});

} // namespace shape
