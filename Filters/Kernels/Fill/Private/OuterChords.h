#pragma once

#include "Fill/FairSurface.h"
#include "Fill/Private/HoleDisk.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

/**
 * Whether a fill should have no edge between two points of its rim, by number: seen along the rim's
 * normals the few points between them are on the other side, so that the edge would cut off a piece
 * that lies over the surface around the hole; or they are on one line with it. False where more
 * than eight sides are between them, and where neither is sure.
 */
std::function<bool(int, int)> FindOuterChords(const BoundaryLoop& loop);

/**
 * Where a triangle of a disk joins two corners of its outline that are two apart, and they should
 * not be joined, the edge from the corner between them is taken instead.
 *
 * corners: of the outline, the disk's first points. isTaken: which edges must not be made, or none.
 */
void FlipTips(FlatDisk& disk, int corners, const std::function<bool(int, int)>& isOutside,
  const std::function<bool(int, int)>& isTaken);

} // namespace shape
