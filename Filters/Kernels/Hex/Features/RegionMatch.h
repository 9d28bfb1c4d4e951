#pragma once

#include "Hex/Features/PatchedBoundary.h"
#include "Hex/Features/RegionNetwork.h"
#include "Hex/Features/RegionTargets.h"
#include "Mesh/HexMesh.h"

#include <Eigen/Core>

namespace shape
{

/// Where the points of faces between regions may move.
struct RegionMatch
{
  /// A patch for each pair of labels; its Quads are those whose pair the surfaces have. Points on
  /// curves and corners have spans, and start there.
  PatchedBoundary Boundary;
  RegionNetwork Chains; ///< of the hexahedra
  /// Curves of the surfaces, without those inside a junction, and those that a chain of edges
  /// follows.
  int Curves = 0, CurvesKept = 0;
  /// Junctions of the surfaces, and those that the hexahedra have.
  int Junctions = 0, JunctionsKept = 0;
};

/**
 * Assigns the faces between regions of hexahedra near surfaces to these surfaces. Each junction of
 * the faces' network gets the closest junction of the surfaces with the same labels
 * (MatchJunctions), and its corners are put there. Each chain of edges gets the curve with the same
 * labels between the same junctions, and its points are distributed along it. Points of other
 * chains start at the closest curve without further labels, along which they may move near there;
 * if there is none, they move on a patch.
 *
 * cellSize: of the grid that the hexahedra were made of.
 */
RegionMatch MatchRegions(
  const HexMesh& mesh, const RegionFaces& faces, const RegionTargets& targets, double cellSize);

/// Returns the larger one-sided Hausdorff distance between the chains of edges and the curves of
/// the surfaces. Each chain is compared with the curves that have at least its labels, and vice
/// versa; if there are none, with all. points: of the hexahedra. Returns 0 without curves.
double ComputeCurveDistance(
  const Eigen::MatrixXd& points, const RegionTargets& targets, const RegionMatch& match);

} // namespace shape
