#pragma once

#include "Hex/Features/CornerRings.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// Of a quad to a patch.
using DistanceToPatch = std::function<double(int, int)>;

/**
 * Where a patch of quads touches itself at a point, the patches that it parts there meet nowhere
 * on the surface: there is a corner too many. The quads of one arc around the point join a patch
 * next to them, those of the arc that is closest to it, in sum. Points with the ring of a corner
 * stay, and those where no arc alone helps.
 *
 * quads: q x 4, of a closed surface. corners: see FindCornerRings. patchOf: q.
 */
void SplitPinches(const Eigen::MatrixXi& quads, const std::vector<PatchRing>& corners,
  const DistanceToPatch& distance, Eigen::VectorXi& patchOf);

} // namespace shape
