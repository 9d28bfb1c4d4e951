#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Untangle/MinimizeEnergy.h"

#include <vector>

namespace shape
{

struct HexOptimizationOptions
{
  int Sweeps = 6;       ///< number of sweeps over all points at each sharpness; >= 0
  int WorstSweeps = 60; ///< number of sweeps over bad hexahedra at each higher sharpness; >= 0
  double Bad = 0.7;     ///< hexahedra with a scaled Jacobian below this value are bad
  /// Sweeps over bad hexahedra follow only if the minimum scaled Jacobian is greater than this
  /// value.
  double RaiseFrom = 0.0;
  /// While the minimum scaled Jacobian is below this value, further sweeps follow. They stop if
  /// they help too little, or if more than a tenth of the points are near hexahedra below this
  /// value.
  double RaiseTo = 0.0;
  /// Further sweeps (RaiseTo) follow only if the minimum scaled Jacobian is at least this value.
  double RaiseAgainFrom = 0.0;
  /// Whether sweeps over all points come before inverted hexahedra are untangled. They repair most
  /// of them in less time, but not as well.
  bool SweepFirst = false;
  /// Maximum number of Newton steps for each patch of inverted hexahedra; >= 0. What is not
  /// repaired in a few steps needs more points around it, not more steps.
  int UntanglingSteps = 40;
  /// For each point, whether it may move. If empty, all points may. Ignored while hexahedra are
  /// untangled.
  std::vector<char> Marked = {};
};

/// If hexahedra shall reach a scaled Jacobian, those less than this above it are swept over, too.
inline constexpr double BadAbove = 0.15;

struct HexOptimizationResult
{
  double MinimumBefore = 0.0, MinimumAfter = 0.0; ///< minimum scaled Jacobians
  int InvertedBefore = 0, InvertedAfter = 0;      ///< hexahedra with a scaled Jacobian <= 0
};

/**
 * Moves the points of hexahedra to maximise the minimum scaled Jacobian.
 *
 * For each point in turn, a Newton step with a line search lowers the sum of exp(k (1 - s)) over
 * the corners around it (StarEnergy). s is the scaled determinant of a corner, and k is the
 * sharpness. k grows from 2 to 20, and then from 25 to 90 for the points of bad hexahedra only. The
 * last sweeps raise the worst corners at little cost to the others. The method is the continuation
 * from l_p to l_infinity of Livesu, Sheffer, Vining and Tarini ("Practical hex-mesh optimization
 * via edge-cone rectification", 2015), applied to the determinants themselves.
 *
 * Because the energy is finite for inverted hexahedra, too, the first sweeps repair most of them.
 * The rest are untangled (UntangleHexahedra) before the sharpness rises. If some stay inverted, all
 * sweeps up to k = 20 are repeated once.
 *
 * mesh: the hexahedra whose points are moved. Every position satisfies the constraint, and the
 * result describes the returned points. Points are moved in sets that share no hexahedron, so any
 * number of threads gives the same bits. Throws InvalidInput if an index is out of range or an
 * option is negative; Aborted.
 */
HexOptimizationResult OptimizeHexahedra(HexMesh& mesh, const PointConstraint& constraint,
  const HexOptimizationOptions& options = {}, const Progress& progress = {});

/// Smooths the positions of the points in the given number of sweeps. A sweep moves each point half
/// way to the mean of those neighbours that have no more freedom than the point. Every point is
/// kept within the constraint. Throws InvalidInput if an index is out of range; Aborted.
void SmoothHexahedra(
  HexMesh& mesh, const PointConstraint& constraint, int sweeps, const Progress& progress = {});

/// Smooths the positions of points around inverted hexahedra, by one sweep in each of up to ten
/// rounds. The neighbourhood grows from round to round. Throws like SmoothHexahedra.
void SmoothInverted(
  HexMesh& mesh, const PointConstraint& constraint, const Progress& progress = {});

} // namespace shape
