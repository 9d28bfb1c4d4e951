#pragma once

#include "Base/Progress.h"
#include "Geometry/SampledSurface.h"
#include "Geometry/TangentFrame.h"
#include "Mesh/Surface.h"
#include "Search/ClosestPoint.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shape
{

struct ExponentialMapOptions
{
  /// Whether the image of a point is the mean of the predictions of all its upwind neighbours
  /// (equation 11). These are the neighbours that the front reached before the point. If false, the
  /// image is the prediction of the one neighbour from which the front came (equation 10).
  bool UpwindAverage = true;
  /// Number of rounds of SmoothNormals, from 0 to 1000.
  int NormalSmoothing = 2;
};

/// The part of a surface around a seed, mapped to the plane.
struct ExponentialPatch
{
  TangentFrame Seed; ///< origin and axes of the plane, on the surface
  /// k points of the surface, in the order in which the front reached them
  std::vector<int> Points;
  Eigen::MatrixXd Positions;  ///< k x 2, in the model's units
  Eigen::VectorXd Distances;  ///< k distances from the seed along the surface
  std::vector<int> Triangles; ///< t triangles of the surface whose corners are all in Points
  Eigen::MatrixXi Corners;    ///< t x 3: the corners of Triangles, as rows of Positions
  /// Rows of Corners whose image is not counter-clockwise, although the triangle has an area.
  std::vector<int> Flipped;
  /// Rows of Corners where the longest edge of the image is more than twice as long as that of the
  /// triangle. There the map is cut open, because the front meets itself behind a protrusion or a
  /// hole.
  std::vector<int> Torn;
  /// Whether a point is on an edge with one triangle, or on the rim of a sampled surface.
  bool ReachesBoundary = false;
  /// t values: SampledSurface::Shares of Triangles; empty if the surface is a mesh.
  Eigen::VectorXd Shares;
};

/**
 * The discrete exponential map: maps the surface around a seed to the plane and preserves
 * directions and distances from the seed (Schmidt, Grimm and Wyvill, "Interactive decal compositing
 * with discrete exponential maps", 2006). Upwind averaging and smoothed normals follow Schmidt and
 * Singh, "Drag-and-drop surface composition", section 3.
 *
 * A front spreads from the seed. Distances are measured along straight lines across unfolded
 * triangles, or along edges if there is no such line. A neighbour predicts the image of a point:
 * its own image plus the edge to the point. This edge is rotated into the neighbour's tangent plane
 * without shortening. The tangent axes are transported with the front by the smallest rotations
 * between normals, so cones are unrolled as well as cylinders. Equation 10 instead rotates each
 * normal directly to the normal at the seed.
 *
 * The weights of the mean are the inverse squared edge lengths, balanced on both sides of the line
 * from the seed. So the result converges to the exponential map under refinement, for any
 * arrangement of triangles. The front comes to a point from one neighbour. Predictions too far from
 * the prediction of this neighbour are ignored, because there the front has met itself. Finally the
 * mean is scaled so that its distance from the seed's image equals the point's distance from the
 * seed.
 *
 * Behind bumps and protrusions, where straight lines from both sides meet, the means may flip
 * triangles that are not torn. This affects a tenth of the triangles in patches that contain
 * fingers or a head (twice as many with equation 10). It affects almost no triangles if the
 * positive angle defects add up to less than pi.
 *
 * The time of Around depends on the size of the patch only. A larger radius appends points and
 * triangles, and changes no bit of the others. The surface may have any topology. Coincident points
 * are treated as one, and the patch lies in the component of the seed. Triangles oriented opposite
 * to their neighbours are flipped in the image. An object must not be used from several threads at
 * once.
 */
class ExponentialMap
{
public:
  /// Throws InvalidInput if the surface has no triangle, an index or option is out of range, or a
  /// coordinate is not finite; Aborted.
  explicit ExponentialMap(const shape::Surface& surface, const ExponentialMapOptions& options = {},
    const Progress& progress = {});
  /// The map of a surface given by points: the front spreads over their local triangles, with their
  /// normals. Schmidt and Singh use point samples only, connected to their nearest points; local
  /// triangles add straight distances across them.
  explicit ExponentialMap(const SampledSurface& samples, const ExponentialMapOptions& options = {},
    const Progress& progress = {});
  ~ExponentialMap();
  ExponentialMap(ExponentialMap&&) noexcept;
  ExponentialMap& operator=(ExponentialMap&&) noexcept;

  ///@{
  /**
   * Returns the patch within distance `radius` (> 0) of a seed. The seed is a position on the
   * surface, or the surface position closest to a given position. xDirection: see
   * BuildTangentFrame. guess: a triangle that is probably near the seed, or -1. Throws InvalidInput
   * if the radius is not positive or a value is not finite; Aborted.
   */
  ExponentialPatch Around(const ClosestPoint& seed, double radius,
    const Eigen::RowVector3d& xDirection = Eigen::RowVector3d::Zero(),
    const Progress& progress = {});
  ExponentialPatch Around(const Eigen::RowVector3d& seed, double radius,
    const Eigen::RowVector3d& xDirection = Eigen::RowVector3d::Zero(), int guess = -1,
    const Progress& progress = {});
  ///@}

  /// Returns the unit normal at a point of the surface, interpolated from the smoothed normals at
  /// the corners of its triangle.
  Eigen::RowVector3d Normal(const ClosestPoint& position) const;

  const shape::Surface& Surface() const;
  const SurfaceLocator& Locator() const; ///< the locator of the surface

private:
  struct Target;
  void Build(const shape::Surface& surface, const SampledSurface* samples,
    const ExponentialMapOptions& options, const Progress& progress);

  std::unique_ptr<Target> Impl;
};

} // namespace shape
