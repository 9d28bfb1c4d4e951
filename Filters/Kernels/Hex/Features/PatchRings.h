#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/QuadSurface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// Patches in the order in which one passes them on the way around a point, counter-clockwise. One
/// that is passed several times in a row is there once.
using PatchRing = std::vector<int>;

/// The ring of the patches passed one by one, rotated such that equal rings are equal vectors.
PatchRing BuildPatchRing(const std::vector<int>& patches);

/// The ring of each corner of a surface.
std::vector<PatchRing> FindCornerRings(const Mesh& surface, const SurfaceFeatures& features);

/// The distance of a quad to a patch.
using DistanceToPatch = std::function<double(int quad, int patch)>;

/**
 * If a patch of quads touches itself at a point, the patches that it separates there meet nowhere
 * on the surface: there is a corner too many. The quads of one arc around the point join a patch
 * next to them: those of the arc that is closest to it, in sum. Points with the ring of a corner
 * stay, and those that no single arc helps.
 *
 * corners: see FindCornerRings. patchOf: of each quad.
 */
void SplitPinches(const QuadSurface& quads, const std::vector<PatchRing>& corners,
  const DistanceToPatch& distance, Eigen::VectorXi& patchOf);

} // namespace shape
