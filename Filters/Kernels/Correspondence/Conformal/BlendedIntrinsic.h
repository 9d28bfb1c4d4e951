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
  /// Two maps agree by 1 / e at a point if its two images are at this distance (> 0) from each
  /// other. The distance is relative to the root of the target's area.
  double Agreement = 0.1;
};

/**
 * Computes corresponding points of two surfaces of genus 0 by blending conformal maps, each of
 * which is good in some region (Kim, Lipman and Funkhouser, "Blended intrinsic maps", 2011).
 *
 * Each surface is mapped to the sphere, with its holes closed by fans. MapToSphere uses the same
 * method for both surfaces. If either surface has a hole, PositiveFlow is tried first. Each triple
 * of landmarks defines a Moebius map between the spheres (Lipman and Funkhouser, "Moebius voting
 * for surface correspondence", 2009). At most 300 triples are used, evenly spread. The trust in a
 * map at a point is 1 / cosh(s), where s is the logarithm of the map's area scale at the point. The
 * agreement of two maps is an integral over the points of A. Its integrand is the product of both
 * trusts and of exp(-(d / Agreement)^2), where d is the distance between the point's two images.
 * The leading eigenvector of the matrix of agreements gives the weights of the maps, so maps that
 * agree with no others get no weight (section 4 of the paper). Each point is mapped to the position
 * nearest to the mean of its images. An image has the weight of its map, times the trust in this
 * map at the point. The mean is taken in the EmbedBySmacof positions of the other surface, where
 * straight distances approximate geodesic ones (section 5).
 *
 * Moebius maps keep orientation, so nothing is mirrored, whatever landmarks are given. On surfaces
 * with very long, thin extremities, MapToSphere falls back on its last method, which is not
 * conformal; the result is then worse. If no landmarks are given, FindLandmarks finds them.
 *
 * a, b: consistently oriented 2-manifolds of one component and genus 0, closed or with holes. Each
 * point has a triangle, and the triangles face outwards. landmarks: none, or at least three, of
 * which three are distinct points on both surfaces. Throws InvalidInput if the input is not as
 * required; SolveFailure; Aborted.
 */
SurfaceMaps ComputeBlendedIntrinsicMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const BlendedIntrinsicOptions& options = {},
  const Progress& progress = {});

} // namespace shape
