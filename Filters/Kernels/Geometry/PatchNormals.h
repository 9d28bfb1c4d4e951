#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// Unit normals of the points of a surface by the weights of Max, "Weights for computing vertex
/// normals from facet normals", 1999: exact inside where the points lie on a sphere, whatever the
/// triangles. Zero where no triangle has an area.
Eigen::MatrixXd ComputeMaxNormals(const Mesh& surface);

/// A place of a triangle curved to normals at its corners (one a row): the cubic patch of Vlachos
/// and others, "Curved PN triangles", 2001.
Eigen::RowVector3d EvaluateCurvedTriangle(const Eigen::Matrix3d& corners,
  const Eigen::Matrix3d& normals, const Eigen::RowVector3d& barycentric);

} // namespace shape
