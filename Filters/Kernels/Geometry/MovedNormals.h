#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Carries normals along with a surface whose points move.
 *
 * Each triangle moves by a linear map: in its plane, the one of its corners; along its normal, a
 * scaling by the square root of the ratio of the areas. The normal at a point is the area-weighted
 * mean of what the inverse transposed maps of the triangles around it make of the given normal. A
 * similarity therefore rotates the normals with the shape, whatever they are. Other motions keep a
 * normal that is perpendicular to the surface perpendicular to it.
 *
 * surface: with its old points (n x 3). moved: n x 3, the new points. normals: n x 3, unit normals
 * at the old points. rotations: n rotations, which are used at points around which no triangle has
 * an area, such as copies of a point of a cloud. Returns n x 3 unit normals.
 */
Eigen::MatrixXd MoveNormals(const Mesh& surface, const Eigen::MatrixXd& moved,
  const Eigen::MatrixXd& normals, const std::vector<Eigen::Matrix3d>& rotations);

} // namespace shape
