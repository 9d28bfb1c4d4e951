#pragma once

#include "Mesh/HexMesh.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace shape
{

/// The boundary of hexahedra, each part of it on its part of a surface.
struct PatchedBoundary
{
  Eigen::MatrixXi Quads;     ///< q x 4, counter-clockwise seen from outside
  Eigen::VectorXi PatchOf;   ///< q: the patch that a quad lies on
  std::vector<int> CurveOf;  ///< of each point of the hexahedra the curve it lies on, or -1
  std::vector<int> CornerOf; ///< and the corner (an index into Corners), or -1
  /// The layers: points of the boundary, each with a copy under it, those made first first.
  std::vector<std::pair<int, int>> Copies;
  /// Points on curves and corners, spread along the curves.
  std::vector<std::pair<int, Eigen::RowVector3d>> Starts;
  std::map<int, Eigen::MatrixXd> Spans; ///< where points on curves may go (CurvePositions)
  std::vector<Surface> Patches;         ///< of the surface (SplitIntoPatches)
};

/**
 * Shares out the boundary of hexahedra near a surface among the surface's patches, so that quads
 * and patches have the same borders: each patch becomes one piece of the same Euler number, and
 * curves and corners become chains of edges and points between the same patches. Nothing where that
 * is not found: where hexahedra are coarse against the features.
 *
 * mesh: its boundary is a manifold near the surface.
 */
std::optional<PatchedBoundary> MatchFeatures(
  const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features);

/// Finds the curves and corners where the patches of the boundary meet. False where they are not
/// those of the surface.
bool MatchCurves(const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features,
  PatchedBoundary& boundary);

} // namespace shape
