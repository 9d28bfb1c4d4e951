#pragma once

#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Why a loop cannot be set down on a patch.
enum class CoveredRegionFault
{
  None,
  BeyondPatch,   ///< it leaves the patch, but not the surface
  LeavesSurface, ///< a rim of the surface crosses it
  Flipped,       ///< it goes through triangles that are flipped in the patch's image
  Overlaps,      ///< two triangles of the patch lie over each other there
  NotADisk,      ///< what it covers has a hole or a handle
  Collapsed      ///< neighbouring points of it come to the same place of the surface
};

/// What a loop in the plane covers of a surface.
struct CoveredRegion
{
  CoveredRegionFault Fault = CoveredRegionFault::None;
  int FlippedAtLoop = 0;      ///< triangles that are flipped and that the loop goes through
  int Flipped = 0;            ///< those, and others flipped or flat that are covered
  std::vector<int> Triangles; ///< of the surface: those that must go to make room for the loop
  std::vector<int> Ring;      ///< points of the surface around them, counter-clockwise in the image
  Eigen::MatrixXd RingImage;  ///< where these are in the plane
  Eigen::MatrixXd Loop;       ///< the loop, its points snapped
  SurfacePoints Positions;    ///< where each of the loop's points is on the surface
};

/// Finds out what loops cover of one surface: a disk of triangles, so that the band between their
/// ring and the loop can be triangulated in the plane with no point in it.
class CoveredRegionFinder
{
public:
  /// target: an oriented 2-manifold, open or closed.
  explicit CoveredRegionFinder(const Surface& target);

  /**
   * patch: of that surface. loop: n x 2, a polygon that does not cross itself, in either sense.
   * Points of it less than `snap` from one of the patch's are moved there, the first to each.
   *
   * A triangle must go where a side of the loop meets its inside or it lies within the loop; and
   * all around points of the surface that lie within a side, and where the ring would touch itself.
   * Exact but for snapping. Flipped triangles within the loop do no harm: they go. Where the result
   * has a fault, its other members mean nothing, but for the counts.
   */
  CoveredRegion Find(const ExponentialPatch& patch, const Eigen::MatrixXd& loop, double snap);

private:
  Surface Target;
  std::vector<int> InPatch; ///< of each triangle of the surface: its number in the patch, or -1
};

} // namespace shape
