#pragma once

#include "Mesh/HexMesh.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace shape
{

/// The boundary of hexahedra. Its quads, edges and points are assigned to the patches, curves and
/// corners of a surface.
struct PatchedBoundary
{
  Eigen::MatrixXi Quads;     ///< q x 4, counter-clockwise seen from outside
  Eigen::VectorXi PatchOf;   ///< q: the patch that each quad lies on
  std::vector<int> CurveOf;  ///< for each point of the hexahedra: its curve, or -1
  std::vector<int> CornerOf; ///< for each point: the index of its corner in the features, or -1
  /// Pairs of a boundary point and its copy in a layer below, in the order of creation.
  std::vector<std::pair<int, int>> Copies;
  /// Initial positions of the points on curves and corners: pairs of a point and its position.
  std::vector<std::pair<int, Eigen::RowVector3d>> Starts;
  std::map<int, Eigen::MatrixXd> Spans; ///< where each point on a curve may move (CurvePositions)
  std::vector<Surface> Patches;         ///< the patches of the surface (SplitIntoPatches)
};

/**
 * Assigns the boundary of hexahedra near a surface to the surface's features. Each quad is assigned
 * to a patch, and the quads of a patch form one connected piece with the patch's Euler number. Each
 * curve becomes a chain of edges between quads of the curve's two patches. Each corner becomes a
 * point around which the corner's patches meet. Returns nothing if this fails, for example because
 * the hexahedra are too coarse for the features.
 *
 * mesh: hexahedra whose boundary is a manifold close to the surface. unmatched: gets, if this
 * fails, the indices of curves without which it may succeed: for each patch without quads, each
 * corner without a point, each point without a corner and each chain without a curve, the shortest
 * curve there. Empty if there is none.
 */
std::optional<PatchedBoundary> MatchFeatures(const HexMesh& mesh, const Surface& surface,
  const SurfaceFeatures& features, std::set<int>& unmatched);

/// Assigns points of the boundary to curves and corners, given the patch of each quad. Returns
/// false if the curves and corners between these patches do not match the curves and corners of the
/// surface; `unmatched` then gets curves as above.
bool MatchCurves(const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features,
  PatchedBoundary& boundary, std::set<int>& unmatched);

} // namespace shape
