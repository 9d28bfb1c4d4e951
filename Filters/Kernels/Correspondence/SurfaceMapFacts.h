#pragma once

#include "Core/Mesh.h"
#include "Core/PreciseMap.h"
#include "Correspondence/SurfaceMaps.h"

namespace shape
{

/// What can be said of maps without knowing the true ones; areas are made 1.
struct SurfaceMapFacts
{
  /// Of A's map: half the integral of the squared gradient of the positions on B (Pinkall and
  /// Polthier 1993), with cotangents that are not negative raised from below: 1 for an isometry,
  /// and for any map onto all of B that keeps angles; onto a part of B, that part's share.
  double DirichletEnergy = 0.0;
  /// The mean over A's area of how far, straight, a point is from where it comes back to.
  double RoundTrip = 0.0;
  /// The share of A's area that the map turns over: more than half where it mirrors A.
  double ReversedArea = 0.0;
  /// The shares of A's and of B's area that come back within a 50th of the root of its area,
  /// straight: what has a partner. Where A is a part of B, the share of B that A is.
  double CoverageOfA = 0.0, CoverageOfB = 0.0;
};

/// a, b: face outwards. Triangles whose corners go to places of B that are far from each other
/// count by the sense of the triangle between these places, against B's at its first corner.
SurfaceMapFacts DescribeMaps(const Mesh& a, const Mesh& b, const SurfaceMaps& maps);

} // namespace shape
