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
  /// Each place is the mean of what the neighbours that the front met before say of it (equation
  /// 11); else what the one says that the front came from (equation 10).
  bool UpwindAverage = true;
  /// How often each normal is replaced by a mean of those around it; >= 0.
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
  /// where the front met itself behind a limb or a hole.
  std::vector<int> Torn;
  bool ReachesBoundary = false; ///< whether an edge with one triangle has an end in Points
};

/**
 * The discrete exponential map: lays the surface around a seed out in the plane so that directions
 * and distances from the seed are kept (Schmidt, Grimm and Wyvill, "Interactive decal compositing
 * with discrete exponential maps", 2006), with the upwind average and smoothed normals of Schmidt
 * and Singh, "Drag-and-drop surface composition", section 3.
 *
 * A front spreads from the seed. Distances are those of straight ways across unfolded triangles,
 * else along edges. A neighbour says where a point lies by its own place and the edge between them,
 * laid into its tangent plane in full length, in axes that are carried along with the front by the
 * shortest turns between normals: not straight from each normal to the seed's as in equation 10, so
 * that cones are unrolled as well as cylinders. The mean's weights are inverse squares of the
 * edges' lengths, balanced on both sides of the way from the seed: so it tends to the exponential
 * map as triangles become small, however these are arranged. Neighbours that contradict the one
 * that the front came from do not count: the front has met itself there. The mean is put at the
 * distance. Behind bumps and limbs, where straight ways from both sides meet, means may flip
 * triangles that are not torn: in patches that hold fingers or a head a tenth of them, twice as
 * many as by equation 10; where positive angle defects sum up to less than pi, next to none.
 *
 * Around takes time for the patch only, and a larger radius adds points and triangles after the
 * others and changes no bit of these. The surface may hang together in any way; points at one place
 * count as one, and the patch is in the seed's component. Triangles that face the other way than
 * those around them come out flipped. Not for several threads at once.
 */
class ExponentialMap
{
public:
  /// Throws InvalidInput where the surface has no triangle, an index is out of range, a coordinate
  /// is not finite or an option is out of range; Aborted.
  explicit ExponentialMap(const shape::Surface& surface, const ExponentialMapOptions& options = {},
    const Progress& progress = {});
  ~ExponentialMap();
  ExponentialMap(ExponentialMap&&) noexcept;
  ExponentialMap& operator=(ExponentialMap&&) noexcept;

  ///@{
  /**
   * The patch that the front covers before it is `radius` (> 0) from a seed: a place of the
   * surface, or the one closest to a position. xDirection: see BuildTangentFrame. guess: a triangle
   * that is likely near to the seed, or -1. Throws InvalidInput where the radius is not positive or
   * something is not finite; Aborted.
   */
  ExponentialPatch Around(const ClosestPoint& seed, double radius,
    const Eigen::RowVector3d& xDirection = Eigen::RowVector3d::Zero(),
    const Progress& progress = {});
  ExponentialPatch Around(const Eigen::RowVector3d& seed, double radius,
    const Eigen::RowVector3d& xDirection = Eigen::RowVector3d::Zero(), int guess = -1,
    const Progress& progress = {});
  ///@}

  /// The unit normal at a place: those of its triangle's corners, as smoothed, and between them.
  Eigen::RowVector3d Normal(const ClosestPoint& position) const;

  const shape::Surface& Surface() const;
  const SurfaceLocator& Locator() const; ///< of the surface

private:
  struct Target;
  std::unique_ptr<Target> Impl;
};

} // namespace shape
