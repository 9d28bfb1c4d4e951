#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct BlendedIntrinsicOptions
{
  int Candidates = 60; ///< maximum number of conformal maps to blend; >= 1
  int Samples = 200;   ///< points of A at which the maps are compared; >= 10
  /// The distance of two images of a point, relative to the root of the area, at which two maps
  /// agree by 1 / e; > 0.
  double Agreement = 0.1;
};

/**
 * Computes corresponding points of two surfaces of genus 0 by blending conformal maps, each of
 * which is good in some region (Kim, Lipman and Funkhouser, "Blended intrinsic maps", 2011).
 *
 * Each surface is mapped to the sphere once, its holes closed by fans. Both use the same method of
 * MapToSphere, the one with positive weights if either has a hole. Every triple of landmarks, or
 * 300 of the triples, defines a Moebius map between the spheres (Lipman and Funkhouser, "Moebius
 * voting for surface correspondence", 2009). The trust in a map at a point is 1 / cosh of the
 * logarithm of its area scale there. The agreement of two maps is the integral of the trust in
 * both, over the points whose two images are near each other. The leading eigenvector of these
 * agreements gives the weights of the maps, so maps that agree with no others get no weight
 * (section 4 of the paper). Each point is mapped to the position nearest to the mean of its images,
 * weighted by both. The mean is taken in the EmbedBySmacof positions of the other surface, where
 * straight distances approximate geodesic ones (section 5).
 *
 * Moebius maps keep orientation: nothing is mirrored, whatever the landmarks. On surfaces with very
 * long, thin extremities MapToSphere falls back on its last method, which is not conformal; the
 * result is then worse. Without landmarks, those of FindLandmarks are used.
 *
 * a, b: consistently oriented 2-manifolds of one component and genus 0 with a triangle at each
 * point, closed or with holes, whose triangles face outwards. landmarks: none, or at least three
 * distinct points. Throws InvalidInput if they are not, SolveFailure, Aborted.
 */
SurfaceMaps ComputeBlendedIntrinsicMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const BlendedIntrinsicOptions& options = {},
  const Progress& progress = {});

} // namespace shape
