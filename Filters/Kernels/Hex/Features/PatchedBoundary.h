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

/// The boundary of hexahedra, divided into parts that belong to the features of a surface.
struct PatchedBoundary
{
  Eigen::MatrixXi Quads;     ///< q x 4, counter-clockwise seen from outside
  Eigen::VectorXi PatchOf;   ///< q: the patch that each quad lies on
  std::vector<int> CurveOf;  ///< the curve that each point of the hexahedra lies on, or -1
  std::vector<int> CornerOf; ///< the corner of each point (an index into Corners), or -1
  /// The layers: pairs of a boundary point and its copy below it, in the order of creation.
  std::vector<std::pair<int, int>> Copies;
  /// Initial positions of points on curves and corners, distributed along the curves.
  std::vector<std::pair<int, Eigen::RowVector3d>> Starts;
  std::map<int, Eigen::MatrixXd> Spans; ///< where points on curves may move (CurvePositions)
  std::vector<Surface> Patches;         ///< the patches of the surface (SplitIntoPatches)
};

/**
 * Divides the boundary of hexahedra near a surface among the surface's patches. The quads of each
 * patch form one connected piece of the same Euler number. Curves and corners become chains of
 * edges and points between the same patches. Returns nothing if this fails, which happens if the
 * hexahedra are coarse compared with the features.
 *
 * mesh: its boundary is a manifold near the surface.
 */
std::optional<PatchedBoundary> MatchFeatures(
  const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features);

/// Finds the curves and corners at which the patches of the boundary meet. Returns false if they do
/// not match those of the surface.
bool MatchCurves(const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features,
  PatchedBoundary& boundary);

} // namespace shape
