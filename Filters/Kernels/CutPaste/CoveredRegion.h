#pragma once

#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Why a loop cannot be placed on a patch.
enum class CoveredRegionFault
{
  None,
  BeyondPatch,   ///< it leaves the patch, but not the surface
  LeavesSurface, ///< the boundary of the surface crosses it
  Flipped,       ///< it crosses triangles that are flipped in the patch's image
  Overlaps,      ///< two triangles of the patch overlap there
  NotADisk,      ///< what it covers has a hole or a handle
  Collapsed      ///< consecutive points of it come to the same point of the surface
};

/// What a loop in the plane covers of a surface.
struct CoveredRegion
{
  CoveredRegionFault Fault = CoveredRegionFault::None;
  int FlippedAtLoop = 0;      ///< flipped triangles that the loop crosses
  int Flipped = 0;            ///< these, and other covered triangles that are flipped or degenerate
  std::vector<int> Triangles; ///< of the surface: to be removed to make room for the loop
  std::vector<int> Ring;      ///< points of the surface around them, counter-clockwise in the image
  Eigen::MatrixXd RingImage;  ///< their images in the plane
  Eigen::MatrixXd Loop;       ///< the loop, its points snapped
  SurfacePoints Positions;    ///< of the loop's points on the surface
};

/// Finds what loops cover of one surface: a disk of triangles, so that the band between its ring
/// and the loop can be triangulated in the plane without points inside.
class CoveredRegionFinder
{
public:
  /// target: an oriented 2-manifold, open or closed.
  explicit CoveredRegionFinder(const Surface& target);

  /**
   * patch: of that surface. loop: n x 2, a simple polygon of either orientation. Of its points less
   * than `snap` from a point of the patch, the nearest one is moved there.
   *
   * Removed are the triangles that lie within the loop or whose inside an edge of the loop meets;
   * all triangles around points of the surface that lie inside an edge; and those where the ring
   * would touch itself. Exact except for snapping. Flipped triangles within the loop do no harm:
   * they are removed. If the result has a fault, its other members except for the counts are
   * undefined.
   */
  CoveredRegion Find(const ExponentialPatch& patch, const Eigen::MatrixXd& loop, double snap);

private:
  Surface Target;
  std::vector<int> InPatch; ///< of each triangle of the surface: its index in the patch, or -1
};

} // namespace shape
