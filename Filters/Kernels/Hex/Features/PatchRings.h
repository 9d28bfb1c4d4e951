#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/QuadSurface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// The patches around a point, in counter-clockwise order. Consecutive quads or triangles of the
/// same patch count once.
using PatchRing = std::vector<int>;

/// Returns the ring of a cyclic sequence of patches. The ring is rotated to a canonical start, so
/// that equal rings are equal vectors.
PatchRing BuildPatchRing(const std::vector<int>& patches);

/// Returns the ring of each of the surface's corners. The ring of a corner on a boundary loop is
/// empty.
std::vector<PatchRing> FindCornerRings(const Mesh& surface, const SurfaceFeatures& features);

/// Returns the distance of a quad's centroid to a patch.
using DistanceToPatch = std::function<double(int quad, int patch)>;

/**
 * Removes pinches: points at which a patch of quads touches itself, so that the quads have a corner
 * that the surface lacks. One arc of quads around the point is moved to the patch before or after
 * it. If several arcs would remove the pinch, the arc whose quads have the smallest sum of
 * distances to their new patch is moved. A point is left unchanged if its ring equals the ring of a
 * corner, or if no single arc removes the pinch.
 *
 * corners: from FindCornerRings. patchOf: the patch of each quad.
 */
void SplitPinches(const QuadSurface& quads, const std::vector<PatchRing>& corners,
  const DistanceToPatch& distance, Eigen::VectorXi& patchOf);

} // namespace shape
