#pragma once

#include "Correspondence/CorrespondenceOptions.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Throws InvalidInput, with a method that can, unless the method of `options` can match the
 * surfaces from the landmarks, or from none:
 *
 * - surfaces have an area; of two closed ones both face outwards, or both inwards;
 * - of several components: FunctionalMap and HeatKernel, from landmarks;
 * - open: all but CommonSphere and CommonOrbifold;
 * - of genus 1 or more: all but these two and BlendedIntrinsic;
 * - landmarks are points of the surfaces; CommonOrbifold takes three or four, BlendedIntrinsic
 * three or more.
 *
 * a, b: consistently oriented 2-manifolds, open or closed; points that no triangle uses do not
 * count.
 */
void RequireMethodInput(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const CorrespondenceOptions& options);

} // namespace shape
