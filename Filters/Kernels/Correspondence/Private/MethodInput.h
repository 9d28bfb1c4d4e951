#pragma once

#include "Correspondence/CorrespondenceOptions.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Throws InvalidInput if the method of `options` cannot match the surfaces from the landmarks, or
 * without any. The message names a method that can. Requirements:
 *
 * - surfaces have a positive area; two closed ones both face outwards, or both inwards;
 * - several components: only FunctionalMap and HeatKernel, with landmarks;
 * - open surfaces: all methods except CommonSphere and CommonOrbifold;
 * - genus 1 or more: all methods except these two and BlendedIntrinsic;
 * - landmarks are points of the surfaces; CommonSphere takes at least two, BlendedIntrinsic at
 *   least three, CommonOrbifold three or four.
 *
 * a, b: consistently oriented 2-manifolds, open or closed; points that no triangle uses are
 * ignored.
 */
void RequireMethodInput(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const CorrespondenceOptions& options);

} // namespace shape
