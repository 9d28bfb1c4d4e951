#pragma once

#include "Base/Progress.h"
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
  /// Whether each image is the mean of the predictions of all upwind neighbours, those that the
  /// front met before (equation 11), or only the prediction of the one it came from (equation 10).
  bool UpwindAverage = true;
  /// Rounds of SmoothNormals; >= 0.
  int NormalSmoothing = 2;
};

/// The part of a surface around a seed, laid out in the plane.
struct ExponentialPatch
{
  TangentFrame Seed;          ///< the plane's (0, 0) and axes, on the surface
  std::vector<int> Points;    ///< k points of the surface, in the order in which the front met them
  Eigen::MatrixXd Positions;  ///< k x 2, in the model's units
  Eigen::VectorXd Distances;  ///< k: along the surface from the seed
  std::vector<int> Triangles; ///< t triangles of the surface whose corners are all in Points
  Eigen::MatrixXi Corners;    ///< t x 3: these as rows of Positions
  /// Rows of Corners whose image is not counter-clockwise, though the triangle has an area.
  std::vector<int> Flipped;
  /// Rows of Corners whose image is more than twice as long as the triangle: the map is cut open
  /// where the front meets itself behind a protrusion or a hole.
  std::vector<int> Torn;
  bool ReachesBoundary = false; ///< whether an edge with one triangle has an end in Points
};

/**
 * The discrete exponential map: maps the surface around a seed to the plane so that directions and
 * distances from the seed are kept (Schmidt, Grimm and Wyvill, "Interactive decal compositing
 * with discrete exponential maps", 2006), with the upwind average and smoothed normals of Schmidt
 * and Singh, "Drag-and-drop surface composition", section 3.
 *
 * A front spreads from the seed. Distances are those of straight lines across unfolded triangles,
 * else along edges. A neighbour predicts the image of a point by its own image and the edge between
 * them, rotated into its tangent plane in full length. The axes there are transported with the
 * front by the least rotations between normals, not directly from each normal to the seed's as in
 * equation 10: so cones are unrolled as well as cylinders. The mean's weights are the inverse
 * squares of the edge lengths, balanced on both sides of the line from the seed: so it converges to
 * the exponential map as triangles become small, however they are arranged. Neighbours that
 * contradict the one that the front came from do not count: the front has met itself there. The
 * mean is then moved to the point's distance from the seed. Behind bumps and protrusions, where
 * straight lines from both sides meet, means may flip triangles that are not torn: a tenth of them
 * in patches that contain fingers or a head, twice as many as by equation 10; almost none if
 * positive angle defects sum up to less than pi.
 *
 * The time that Around takes depends on the patch only. A larger radius adds points and triangles
 * after the others, and changes no bit of these. The surface may have any topology; coincident
 * points count as one, and the patch is in the seed's component. Triangles of opposite orientation
 * to those around them come out flipped. Not for several threads at once.
 */
class ExponentialMap
{
public:
  /// Throws InvalidInput if the surface has no triangle, an index is out of range, a coordinate is
  /// not finite or an option is out of range; Aborted.
  explicit ExponentialMap(const shape::Surface& surface, const ExponentialMapOptions& options = {},
    const Progress& progress = {});
  ~ExponentialMap();
  ExponentialMap(ExponentialMap&&) noexcept;
  ExponentialMap& operator=(ExponentialMap&&) noexcept;

  ///@{
  /**
   * The patch that the front covers before it is `radius` (> 0) from a seed: a point of the
   * surface, or the one closest to a position. xDirection: see BuildTangentFrame. guess: a triangle
   * that is likely near the seed, or -1. Throws InvalidInput if the radius is not positive or a
   * value is not finite; Aborted.
   */
  ExponentialPatch Around(const ClosestPoint& seed, double radius,
    const Eigen::RowVector3d& xDirection = Eigen::RowVector3d::Zero(),
    const Progress& progress = {});
  ExponentialPatch Around(const Eigen::RowVector3d& seed, double radius,
    const Eigen::RowVector3d& xDirection = Eigen::RowVector3d::Zero(), int guess = -1,
    const Progress& progress = {});
  ///@}

  /// The unit normal at a point of the surface, interpolated between the smoothed ones at its
  /// triangle's corners.
  Eigen::RowVector3d Normal(const ClosestPoint& position) const;

  const shape::Surface& Surface() const;
  const SurfaceLocator& Locator() const; ///< of the surface

private:
  struct Target;
  std::unique_ptr<Target> Impl;
};

} // namespace shape
