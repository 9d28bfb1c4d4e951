#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// det[a, b, c]: six times the volume of the tetrahedron over the origin; from differences, so that
/// it keeps its digits for tiny triangles. Near 2 x area for small triangles of the unit sphere.
double ComputeSphericalDeterminant(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c);

/// Whether det[a, b, c] > 0 for certain: larger than the bound of its rounding error (the first
/// filter of Shewchuk 1997's orient3d), so that exact arithmetic cannot find the opposite.
bool IsFacingOutwards(
  const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c);

/// The triangles (m x 3) that do not face outwards for certain, ascending. points: on the sphere.
std::vector<int> FindFlippedTriangles(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

/// Signed areas of the spherical triangles (m), each in (-2 pi, 2 pi): Van Oosterom & Strackee
/// 1983.
Eigen::VectorXd ComputeSolidAngles(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

/// How many times the triangles of a closed surface cover the sphere: the sum of ComputeSolidAngles
/// over 4 pi. Without flipped triangles, 1 means that the map is one to one; more, that it is
/// branched.
int ComputeCoveringDegree(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points);

} // namespace shape
