#pragma once

#include "Correspondence/CorrespondenceOptions.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

/**
 * Throws InvalidInput if the method of `options` cannot match the surfaces with the given
 * landmarks, which may be none. The message names a suitable method. Requirements:
 *
 * - each surface has a positive area; two closed surfaces both face outwards or both inwards;
 * - surfaces with several components: only FunctionalMap and HeatKernel, and only with landmarks;
 * - open surfaces: all methods except CommonSphere, CommonOrbifold and CommonBase;
 * - surfaces of genus 1 or more: all methods except CommonSphere, CommonOrbifold and
 *   BlendedIntrinsic; CommonBase only for one genus, at most MaximumBaseGenus;
 * - landmarks are indices of points; if any are given, CommonSphere needs at least two,
 *   BlendedIntrinsic, CommonOrbifold and WeightedAverages at least three, CommonBase three, or two
 * if the genus is 1 or more.
 *
 * a, b: consistently oriented 2-manifolds, open or closed; points that no triangle uses are
 * ignored.
 */
void RequireMethodInput(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const CorrespondenceOptions& options);

/// Returns the features of the coarse surfaces' points.
PairFeatures OnCoarse(const PairFeatures& given, const CoarsePair& pair);

} // namespace shape
