#pragma once

#include "Correspondence/Correspondence.h"
#include "Mesh/Mesh.h"

namespace shape
{

/**
 * Throws InvalidInput unless the method of `options` can match the surfaces from the landmarks, or
 * from none, and names one that can:
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
void RequireMethodInput(
  const Mesh& a, const Mesh& b, const Landmarks& landmarks, const CorrespondenceOptions& options);

} // namespace shape
