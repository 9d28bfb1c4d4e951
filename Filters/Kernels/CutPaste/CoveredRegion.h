#pragma once

#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The reason why a loop cannot be placed on a patch.
enum class CoveredRegionFault
{
  None,
  BeyondPatch,   ///< the loop leaves the patch, but not the surface
  LeavesSurface, ///< the loop crosses the boundary of the surface
  Flipped,       ///< the loop crosses triangles that are flipped in the patch's image
  Overlaps,      ///< the loop crosses two overlapping triangles of the patch
  NotADisk,      ///< the covered region has a hole or a handle
  Collapsed,     ///< consecutive points of the loop coincide on the surface
  Shared         ///< the region of another loop is there, or next to it
};

/// The region of a surface that a loop in the plane covers.
struct CoveredRegion
{
  CoveredRegionFault Fault = CoveredRegionFault::None;
  int FlippedAtLoop = 0; ///< number of flipped triangles that the loop crosses
  /// FlippedAtLoop, plus the number of other covered triangles that are flipped or degenerate.
  int Flipped = 0;
  std::vector<int> Triangles; ///< triangles of the surface to remove under the loop
  /// Points of the surface on the boundary of these triangles, counter-clockwise in the image.
  std::vector<int> Ring;
  Eigen::MatrixXd RingImage; ///< n x 2: the images of the ring's points in the plane
  Eigen::MatrixXd Loop;      ///< the loop with snapped points
  SurfacePoints Positions;   ///< positions of the loop's points on the surface
};

/// Finds the regions that loops cover on one surface. Each region is a disk of triangles, chosen so
/// that the band between its ring and the loop can be triangulated in the plane without further
/// points.
class CoveredRegionFinder
{
public:
  /// target: an oriented 2-manifold, open or closed.
  explicit CoveredRegionFinder(const Surface& target);

  /**
   * Finds the region that a loop covers. patch: an exponential patch of the target. loop: n x 2, a
   * simple polygon of either orientation. If some points of the loop are less than `snap` away from
   * a point of the patch, the nearest loop point is moved to it.
   *
   * The removed triangles are those inside the loop and those whose interior an edge of the loop
   * crosses. If a point of the surface lies inside an edge of the loop, all triangles around it are
   * removed. Triangles at which the ring would touch itself are removed too. The result is exact
   * except for snapping. Flipped triangles inside the loop are simply removed. If the result has a
   * fault, only Fault and the counts of flipped triangles are defined.
   */
  CoveredRegion Find(const ExponentialPatch& patch, const Eigen::MatrixXd& loop, double snap);

private:
  Surface Target;
  std::vector<int> InPatch; ///< for each triangle of the surface, its index in the patch, or -1
};

} // namespace shape
