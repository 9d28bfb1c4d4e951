#pragma once

#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

namespace shape
{

/// What can be said of maps without knowing the true ones; areas are made 1.
struct SurfaceMapFacts
{
  /// Of A's map: half the integral of the squared gradient of the positions on B (Pinkall and
  /// Polthier 1993), with cotangents that are not negative raised from below: 1 for an isometry,
  /// and for any map onto all of B that keeps angles; onto a part of B, that part's share.
  double DirichletEnergy = 0.0;
  /// The mean over A's area of the straight distance of a point from where it comes back to.
  double RoundTrip = 0.0;
  /// The share of A that the map inverts, each triangle counting by the smaller of its area and
  /// its image's, times the cosine between the image's normal and B's, which leaves out noise.
  double ReversedArea = 0.0;
  /// Whether that is more than 0.3: left and right are exchanged, of all of A or of parts. (Of 18
  /// pairs of real shapes, functional and heat kernel maps near the true one have at most 0.2, and
  /// functional maps from landmarks with left and right exchanged at least 0.37.)
  bool Mirrored = false;
  /// The shares of A's and of B's area that come back within a 50th of the root of its area,
  /// straight: what has a partner. If A is a part of B, the share of B that A is.
  double CoverageOfA = 0.0, CoverageOfB = 0.0;
};

/// a, b: face outwards. Triangles whose corners go to positions on B that are far from each other
/// count by the orientation of the triangle between these, against B's at its first corner.
SurfaceMapFacts EvaluateMaps(const Surface& a, const Surface& b, const SurfaceMaps& maps);

} // namespace shape
