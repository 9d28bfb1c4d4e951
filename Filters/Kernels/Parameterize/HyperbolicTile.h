#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

// The hyperbolic plane as one sheet of a hyperboloid: the points (x, y, t) with t^2 = 1 + x^2 + y^2
// and t > 0. An orientation-preserving isometry is a Lorentz matrix, with which points are
// multiplied. Its entries grow exponentially with the distance, and cancel in products with points:
// therefore it has more digits than the points. In the Klein model, the point is at (x, y) / t, and
// geodesics are straight. In the Poincare disk, it is at (x, y) / (1 + t), and angles are
// preserved.

/// An isometry, as a Lorentz matrix.
using HyperbolicMotion = Eigen::Matrix<long double, 3, 3>;

/// Returns the image of a point of the hyperboloid.
Eigen::Vector3d MoveHyperbolic(const HyperbolicMotion& motion, const Eigen::Vector3d& point);

/// Returns the distance of two points of the hyperboloid. Small distances keep their digits.
double ComputeHyperbolicDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& q);

/// Returns the point at a share of the way from p to q along the geodesic. p, q: different points.
Eigen::Vector3d InterpolateHyperbolic(
  const Eigen::Vector3d& p, const Eigen::Vector3d& q, double share);

/// Returns the point of the hyperboloid above a position of the Klein model, which lies inside the
/// unit circle.
Eigen::Vector3d LiftFromKlein(const Eigen::RowVector2d& position);

/// Returns the positions in the Klein model (n x 2) of points of the hyperboloid (n x 3).
Eigen::MatrixXd ProjectToKlein(const Eigen::MatrixXd& points);

/// Returns the positions in the Poincare disk (n x 2) of points of the hyperboloid (n x 3).
Eigen::MatrixXd ProjectToPoincare(const Eigen::MatrixXd& points);

/// Returns the inverse of an isometry, without rounding.
HyperbolicMotion InvertHyperbolic(const HyperbolicMotion& motion);

/**
 * The tile of a hyperbolic orbifold of sphere type with n >= 5 cones, each of the total angle pi
 * (Aigerman and Lipman 2016). The orbifold is two regular n-gons with right angles, sewn together
 * along their borders, so all cones are alike. Opened along all sides but the one from the last
 * cone to the first, it is the tile. This is a right-angled polygon of 2 n - 4 corners, convex in
 * the Klein model. The first and the last cone are in the middle of two of its sides.
 *
 * Traversed counter-clockwise, the boundary follows the path from the first cone to the last, with
 * the surface to its left, and then returns, like that of OrbifoldTile. For four cones, the same
 * construction would give the tile of OrbifoldType::Rectangle, which is flat.
 */
struct HyperbolicTile
{
  std::vector<Eigen::Vector3d> There; ///< positions of the cones on the forward path
  std::vector<Eigen::Vector3d> Back;  ///< positions of the cones on the return path
  /// For each leg of the path, from one cone to the next: the isometry that maps the leg's image on
  /// the forward path to its image on the return path. These isometries generate a group, and the
  /// images of the tile under this group cover the hyperbolic plane once.
  std::vector<HyperbolicMotion> Legs;
};

/// cones: n >= 5. Throws InvalidInput if there are fewer.
HyperbolicTile BuildHyperbolicTile(int cones);

} // namespace shape
