#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Returns det[a, b, c], six times the volume of the tetrahedron of a, b, c and the origin. It is
/// computed from differences of the points, so it is accurate for tiny triangles. For small
/// triangles of the unit sphere it is about twice the area.
double ComputeSphericalDeterminant(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c);

/// Whether det[a, b, c] is certainly > 0: larger than the bound of its rounding error (the first
/// filter of Shewchuk 1997's orient3d), so exact arithmetic gives the same sign.
bool IsFacingOutwards(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c);

/// Returns the indices, in ascending order, of the triangles for which IsFacingOutwards is false.
/// triangles: m x 3. points: n x 3, on the unit sphere.
std::vector<int> FindFlippedTriangles(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

/// Returns the signed areas of the m spherical triangles, each in (-2 pi, 2 pi) (Van Oosterom &
/// Strackee 1983).
Eigen::VectorXd ComputeSolidAngles(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

/// Returns how many times the triangles of a closed surface cover the sphere: the sum of
/// ComputeSolidAngles / (4 pi). If no triangle is flipped, 1 means that the map is one-to-one; a
/// larger number means that it is branched.
int ComputeCoveringDegree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

} // namespace shape
