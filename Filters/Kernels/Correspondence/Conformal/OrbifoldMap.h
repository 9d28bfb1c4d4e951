#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Parameterize/OrbifoldTutte.h"
#include "Search/ClosestPoint.h"

#include <vector>

namespace shape
{

/// Finds positions of the plane on a surface that was laid out on the tile of an orbifold: the
/// images of the tile under the orbifold's motions cover the plane, so each is on the surface once.
class OrbifoldLocator
{
public:
  /// reach: how far from the tile's first cone the positions may be.
  OrbifoldLocator(OrbifoldImage image, double reach);

  /// positions: n x 2. A corner that a position coincides with up to rounding gets all the weight;
  /// so does a cone. Throws InvalidInput if a position is out of reach, Aborted.
  SurfacePoints Find(const Eigen::MatrixXd& positions, const Progress& progress = {}) const;

private:
  OrbifoldImage Image;
  double Reach;
  std::vector<PlaneIsometry> Motions; ///< all that bring a position within reach to the image
  SurfaceLocator Flat;
};

struct OrbifoldMap
{
  SurfacePoints AToB; ///< of the points of A, on triangles of B
  SurfacePoints BToA;
};

/**
 * The seamless map between two closed surfaces of genus 0 through their images on one orbifold
 * (Aigerman and Lipman 2015, section 5): one to one, orientation kept, cones of A to those of B in
 * their order. Where an image's cut runs does not matter. With three cones the map is the only one
 * of its kind; with four it goes along the shortest paths through the cones of both. The images of
 * two meshes of one shape agree in the limit: at a cone of order k they differ by h^(2 / k), so
 * that Rhombus and Rectangle depend least on the mesh.
 *
 * Throws as MapToOrbifold, with the surface's letter; Aborted.
 */
OrbifoldMap MapThroughOrbifold(const Surface& a, const std::vector<int>& conesA, const Surface& b,
  const std::vector<int>& conesB, OrbifoldType type, const Progress& progress = {});

/// The positions of the uncut surface's points in the image (n x 2), one for each point.
Eigen::MatrixXd CollectUncutPositions(const OrbifoldImage& image, Eigen::Index points);

} // namespace shape
