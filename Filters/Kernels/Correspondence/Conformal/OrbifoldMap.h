#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Parameterize/OrbifoldTutte.h"
#include "Search/ClosestPoint.h"

#include <vector>

namespace shape
{

/// Finds positions of the plane on a surface that was laid out on the tile of an orbifold. The
/// images of the tile under the orbifold's motions cover the plane, so each position has one image
/// on the surface.
class OrbifoldLocator
{
public:
  /// reach: the maximum distance of the positions from the tile's first cone.
  OrbifoldLocator(OrbifoldImage image, double reach);

  /// Returns the point of the surface at each position (n x 2). If a position coincides with a
  /// corner or a cone up to rounding, that corner has weight 1. Throws InvalidInput if a
  /// position is out of reach, Aborted.
  SurfacePoints Find(const Eigen::MatrixXd& positions, const Progress& progress = {}) const;

private:
  OrbifoldImage Image;
  double Reach;
  /// All motions that bring a position within reach to the image.
  std::vector<PlaneIsometry> Motions;
  SurfaceLocator Flat;
};

/// A map between two surfaces, in both directions.
struct OrbifoldMap
{
  SurfacePoints AToB; ///< one for each point of A, on triangles of B
  /// one for each point of B, on triangles of A
  SurfacePoints BToA;
};

/**
 * Computes the seamless map between two closed surfaces of genus 0 through their images on one
 * orbifold (Aigerman and Lipman 2015, section 5). The map is one to one, keeps orientation, and
 * takes the cones of A to those of B in the given order. It does not depend on where the images are
 * cut. With three cones the map is unique; with four it depends on the shortest paths through the
 * cones of both surfaces. The images of two meshes of one shape agree in the limit. At a cone of
 * order k they differ by h^(2 / k), so Rhombus and Rectangle depend least on the mesh.
 *
 * Throws the exceptions of MapToOrbifold, with the surface's letter in the message; Aborted.
 */
OrbifoldMap MapThroughOrbifold(const Surface& a, const std::vector<int>& conesA, const Surface& b,
  const std::vector<int>& conesB, OrbifoldType type, const Progress& progress = {});

/// Returns the position in the image (n x 2) of each point of the uncut surface.
Eigen::MatrixXd CollectUncutPositions(const OrbifoldImage& image, Eigen::Index points);

} // namespace shape
