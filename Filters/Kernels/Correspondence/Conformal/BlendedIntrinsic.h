#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct BlendedIntrinsicOptions
{
  int Candidates = 60;    ///< conformal maps that are blended, at most; >= 1
  int Samples = 200;      ///< points of A at which they are compared; >= 10
  double Agreement = 0.1; ///< distance of two images, of the root of the area, at which the maps
                          ///< agree by 1 / e; > 0
};

/**
 * Corresponding points of two surfaces of genus 0, from conformal maps that are each good
 * somewhere, blended (Kim, Lipman and Funkhouser, "Blended intrinsic maps", 2011).
 *
 * Each surface is mapped to the sphere once, its holes closed by fans, both by the same method of
 * MapToSphere: by positive weights if one has a hole. Every three landmarks, or 300 triples of
 * them, give a Moebius map between the spheres each (Lipman and Funkhouser, "Moebius voting for
 * surface correspondence", 2009). A map is trusted at a point as 1 / cosh of the logarithm of how
 * much it enlarges areas there; the agreement of two maps is the integral of the trust in both
 * where their images are near each other, and the leading eigenvector of these agreements weights
 * the maps, so that those that fit no others count for nothing (section 4 there). Each point goes
 * to the position nearest to the mean of its images, weighted by both, in the positions of
 * EmbedBySmacof on the other surface, whose straight distances stand for geodesic ones (section 5).
 *
 * Moebius maps keep orientation: nothing is mirrored, whatever the landmarks. Limbs so long and
 * thin that MapToSphere falls back on its last method, which keeps no angles, are mapped worse.
 * Without landmarks: those of FindLandmarks.
 *
 * a, b: consistently oriented 2-manifolds of one component and genus 0 with a triangle at each
 * point, closed or with holes, whose triangles face outwards. landmarks: none or three and more
 * points apart. Throws InvalidInput if not, SolveFailure, Aborted.
 */
SurfaceMaps ComputeBlendedIntrinsicMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const BlendedIntrinsicOptions& options = {},
  const Progress& progress = {});

} // namespace shape
