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

/// Returns the corners of a triangle, one per row.
inline Eigen::Matrix3d GetCorners(const Mesh& mesh, Eigen::Index triangle)
{
  Eigen::Matrix3d corners;
  for (int k = 0; k < 3; ++k)
  {
    corners.row(k) = mesh.Points.row(mesh.Triangles(triangle, k));
  }
  return corners;
}

/// Returns the longest edge of the points' axis-aligned bounding box. Relative errors are errors
/// divided by this length.
double ComputeLongestBoxEdge(const Eigen::MatrixXd& points);

/// Returns the length of the bounding box's diagonal.
double ComputeBoxDiagonal(const Eigen::MatrixXd& points);

/// Returns the cross product of two edges of each triangle (m x 3): it points outwards, and its
/// length is twice the area.
Eigen::MatrixXd ComputeAreaVectors(const Mesh& mesh);

/// Returns the area of the surface.
double ComputeArea(const Mesh& mesh);

/// Returns, for each point, a third of the total area of the triangles around it (n values).
Eigen::VectorXd ComputePointAreas(const Mesh& mesh);

/// Returns the volume enclosed by a closed surface; negative if its triangles face inwards.
double ComputeEnclosedVolume(const Mesh& mesh);

/**
 * Returns the winding number of closed surfaces around a position that lies on none of them: the
 * sum of the triangles' solid angles / 4 pi (Van Oosterom and Strackee, "The solid angle of a plane
 * triangle", 1983). It is 1 inside a surface that faces outwards, -1 inside a surface that faces
 * inwards, and 0 outside. points: n x 3. triangles: m x 3.
 */
double ComputeWindingNumber(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
  const Eigen::RowVector3d& position);

/// Returns a closed surface. If its triangles face inwards, all of them are reversed.
Mesh OrientOutwards(Mesh mesh);

/// Returns the centroids of the triangles (m x 3).
Eigen::MatrixXd ComputeCentroids(const Mesh& mesh);

/// Returns one position in each triangle (m x 3), as far from the edges as a random position is on
/// average. A map may have been fitted at the centroid or on the medians. The position lies off
/// both, so that errors are not underestimated. The order of the corners' coordinates decides which
/// corner it is closest to.
Eigen::MatrixXd ComputeOffCentres(const Mesh& mesh);

/// Interpolates values at the points (n x d) linearly at the positions of ComputeOffCentres.
/// Returns m x d.
Eigen::MatrixXd InterpolateAtOffCentres(const Mesh& mesh, const Eigen::MatrixXd& values);

/// Returns random positions on the triangles (count x 3), uniformly distributed over the area.
Eigen::MatrixXd SampleRandomly(const Mesh& mesh, int count, unsigned int seed);

/// Returns, for each triangle, the mean of the values at its corners (m x d). values: n x d, at the
/// points.
Eigen::MatrixXd AverageAtCorners(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values);

} // namespace shape
