#pragma once

#include "Core/HexMesh.h"
#include "Geometry/ClosestPoint.h"
#include "Hex/SurfaceFeatures.h"

#include <Eigen/Core>

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
  const HexMesh& mesh, const SurfaceLocator& surface, const SurfaceFeatures& features);

/**
 * Which patches get a layer of hexahedra together (of each patch the first of its group): those on
 * either side of a crease that is not convex, which has two hexahedra then; and at a corner where
 * the angle of one patch is so wide that it needs two quads, the other patches. At the other
 * creases each has a layer of its own, and the crease one hexahedron.
 */
std::vector<int> LayerGroups(const Mesh& surface, const SurfaceFeatures& features);

/// The patches beyond those edges of quads that come in a row on a curve inside a group, ascending.
/// The quad's corner between such two cannot be good: it is a straight angle on the surface.
std::vector<int> PatchesBesideStraightCorners(
  const PatchedBoundary& boundary, const std::vector<int>& groups);

/**
 * A layer of hexahedra under some patches. It ends at their border, with a row of quads in the
 * patches beyond: then no quad there has two edges in a row on a curve (each surface and each curve
 * has sheets of its own, as in Ledoux and Shepherd, "Topological and geometrical properties of
 * hexahedral meshes", 2010). New points lie where those they are copies of do.
 *
 * PatchOf and Quads change; curves and corners have to be found anew.
 */
void PadPatches(HexMesh& mesh, const std::vector<int>& patches, PatchedBoundary& boundary);

/// Finds the curves and corners where the patches of the boundary meet. False where they are not
/// those of the surface.
bool MatchCurves(const HexMesh& mesh, const Mesh& surface, const SurfaceFeatures& features,
  PatchedBoundary& boundary);

/// A layer of hexahedra under the whole boundary, whose quads and points stay.
void PadBoundary(HexMesh& mesh, PatchedBoundary& boundary);

/// Puts the copies under each point of the boundary evenly between the lowest of them and the
/// point.
void SpreadLayers(const PatchedBoundary& boundary, Eigen::MatrixXd& points);

} // namespace shape
