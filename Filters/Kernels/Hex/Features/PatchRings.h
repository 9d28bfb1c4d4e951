#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/QuadSurface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// The patches around a point in counter-clockwise order. Consecutive repeats of a patch are
/// merged.
using PatchRing = std::vector<int>;

/// Returns the ring of a sequence of patches, rotated to a canonical start, so that equal rings are
/// equal vectors.
PatchRing BuildPatchRing(const std::vector<int>& patches);

/// Returns the ring of each corner of a surface.
std::vector<PatchRing> FindCornerRings(const Mesh& surface, const SurfaceFeatures& features);

/// Returns the distance of a quad to a patch.
using DistanceToPatch = std::function<double(int quad, int patch)>;

/**
 * Removes pinches: points at which a patch of quads touches itself. The patches that it separates
 * there do not meet on the surface, so the quads have a corner too many. The quads of one arc
 * around the point are moved to an adjacent patch: the arc with the smallest sum of distances to
 * it. Points with the ring of a corner are left unchanged, and so are points that no single arc
 * repairs.
 *
 * corners: from FindCornerRings. patchOf: the patch of each quad.
 */
void SplitPinches(const QuadSurface& quads, const std::vector<PatchRing>& corners,
  const DistanceToPatch& distance, Eigen::VectorXi& patchOf);

} // namespace shape
