#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"
#include "Parameterize/OrbifoldTutte.h"
#include "Search/ClosestPoint.h"

#include <vector>

namespace shape
{

/// Finds the surface point at a position in the plane, for a surface that is laid out on the tile
/// of an orbifold. The images of the tile under the orbifold's motions cover the plane, so there is
/// one surface point at each position.
class OrbifoldLocator
{
public:
  /// reach: the maximum distance from the tile's first cone to a position given to Find.
  OrbifoldLocator(OrbifoldImage image, double reach);

  /// Returns the point of the surface at each position (n x 2). If a position coincides with the
  /// corner of a triangle up to rounding, that corner has weight 1. Throws InvalidInput if a
  /// position is farther from the first cone than the reach; Aborted.
  SurfacePoints Find(const Eigen::MatrixXd& positions, const Progress& progress = {}) const;

private:
  OrbifoldImage Image;
  double Reach;
  /// All motions that can take a position within the reach to the image of the surface.
  std::vector<PlaneIsometry> Motions;
  SurfaceLocator Flat;
};

/// A map between two surfaces, in both directions.
struct OrbifoldMap
{
  SurfacePoints AToB; ///< the image of each point of A, on triangles of B
  /// The image of each point of B, on triangles of A.
  SurfacePoints BToA;
};

/**
 * Computes the seamless map between two closed surfaces of genus 0 through their images on one
 * orbifold (Aigerman and Lipman 2015, section 5). The map is one to one, keeps orientation, and
 * takes each cone of A to the cone of B at the same place in the list. It does not depend on where
 * the images are cut. With three cones, the map is unique. With four, it depends on the shortest
 * paths that join the cones on each surface. As the mesh of a shape is refined, its image
 * converges. At a cone of order k, the error for the edge length h is of order h^(2 / k). Rhombus
 * and Rectangle therefore depend least on the mesh.
 *
 * Throws the exceptions of MapToOrbifold, with the surface's name (A or B) in the message; Aborted.
 */
OrbifoldMap MapThroughOrbifold(const Surface& a, const std::vector<int>& conesA, const Surface& b,
  const std::vector<int>& conesB, OrbifoldType type, const Progress& progress = {});

/// Returns the position of each point of the uncut surface in the image (n x 2). points: the number
/// n of these points.
Eigen::MatrixXd CollectUncutPositions(const OrbifoldImage& image, Eigen::Index points);

} // namespace shape
