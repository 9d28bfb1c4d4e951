#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * A triangulated surface.
 *
 * Points: n x 3, in the model's units. Triangles: m x 3 indices into Points, counter-clockwise when
 * seen from outside.
 */
struct Mesh
{
  Eigen::MatrixXd Points;
  Eigen::MatrixXi Triangles;
};

/// The corners of a triangle, one a row.
inline Eigen::Matrix3d GetCorners(const Mesh& mesh, Eigen::Index triangle)
{
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k)
  {
    corners.row(k) = mesh.Points.row(mesh.Triangles(triangle, k));
  }
  return corners;
}

/// The longest side of the points' axis-aligned bounding box: the size that errors are divided by.
double ComputeLongestBoxEdge(const Eigen::MatrixXd& points);

/// The diagonal of that box.
double ComputeBoxDiagonal(const Eigen::MatrixXd& points);

/// Twice-area vectors of the triangles (m x 3): the cross product of two edges, pointing outwards.
Eigen::MatrixXd ComputeAreaVectors(const Mesh& mesh);

/// The area of the surface.
double ComputeArea(const Mesh& mesh);

/// A third of the area of the triangles around each point (n).
Eigen::VectorXd ComputePointAreas(const Mesh& mesh);

/// Volume enclosed by a closed surface; negative when its triangles face inwards.
double ComputeEnclosedVolume(const Mesh& mesh);

/**
 * How often closed surfaces of `triangles` (m x 3) over `points` wind around a place that lies on
 * none of them: the sum of the solid angles / 4 pi (Van Oosterom and Strackee, "The solid angle of
 * a plane triangle", 1983). 1 inside one that faces outwards, -1 inside one that faces inwards, 0
 * outside.
 */
double ComputeWindingNumber(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
  const Eigen::RowVector3d& position);

/// The same closed surface with all triangles turned where it faces inwards.
Mesh OrientOutwards(Mesh mesh);

/// Centroids of the triangles (m x 3).
Eigen::MatrixXd ComputeCentroids(const Mesh& mesh);

/// A place in each triangle (m x 3) as far from its edges as random ones are on average, and away
/// from its centroid and its middles: an error that is small only where a map was fitted shows. The
/// order of its corners' coordinates decides which corner it is near.
Eigen::MatrixXd ComputeOffCentres(const Mesh& mesh);

/// Values given at the points (n x d), interpolated linearly at the places of ComputeOffCentres (m
/// x d).
Eigen::MatrixXd InterpolateAtOffCentres(const Mesh& mesh, const Eigen::MatrixXd& values);

/// Random places on the triangles (count x 3), evenly over their area.
Eigen::MatrixXd SampleRandomly(const Mesh& mesh, int count, unsigned int seed);

/// Means over each triangle's corners (m x d) of values given at the points (n x d).
Eigen::MatrixXd AverageAtCorners(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values);

} // namespace shape
