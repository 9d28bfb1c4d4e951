#pragma once

#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <vector>

namespace shape
{

/// Patches in the order in which one passes them on the way around a point, counter-clockwise. One
/// that is passed several times in a row is there once.
using PatchRing = std::vector<int>;

/// The ring of the patches passed one by one, in such a turn that equal rings are equal vectors.
PatchRing BuildPatchRing(const std::vector<int>& patches);

/// The ring of each corner of a surface.
std::vector<PatchRing> FindCornerRings(const Mesh& surface, const SurfaceFeatures& features);

} // namespace shape
