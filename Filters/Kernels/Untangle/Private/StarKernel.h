#pragma once

#include "Untangle/Private/SolidCells.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// Points p, q, r of a tetrahedron around a point v, such that (q - p) x (r - p) . (v - p) is its
/// determinant. The position of v sees the face if that is positive.
using StarFace = std::array<int, 3>;

/// Where a point or a cluster may be, relative to the faces that it has to see.
struct StarPlacement
{
  bool IsValid = false; ///< whether the position sees all faces, by exact tests
  Eigen::RowVector3d Position = Eigen::RowVector3d::Zero();
  double Clearance = 0.0; ///< distance from the planes, relative to the size of the star
  double Rank = 0.0;      ///< points with a greater rank leave a cluster first

  /// Whether a point can leave a cluster before others are moved to make space.
  bool IsComfortable() const { return this->Clearance > 0.02; }
};

/// Returns the face of a tetrahedron (four points) that is opposite to one of its points.
StarFace FindFaceOpposite(const std::vector<int>& tetrahedron, int point);

/// Returns the faces opposite to a point in the cells around it, which are tetrahedra.
std::vector<StarFace> FindFacesAround(const SolidCells& solid, int point);

/// Whether a position sees a face, by exact predicates. points: n x 3.
bool SeesFace(
  const Eigen::MatrixXd& points, const StarFace& face, const Eigen::RowVector3d& position);

/**
 * Returns the Chebyshev centre of the kernel of a star: of the positions that see all its faces
 * (FindInscribedBall). The search is limited to the cube around `origin` whose sides are at the
 * distance of the farthest corner.
 *
 * points: n x 3. If the kernel is empty, the result is not valid, and its position violates the
 * planes of the faces as little as possible. If a face has no area, it is the origin.
 */
StarPlacement FindKernelCentre(const Eigen::MatrixXd& points, const std::vector<StarFace>& faces,
  const Eigen::RowVector3d& origin);

} // namespace shape
