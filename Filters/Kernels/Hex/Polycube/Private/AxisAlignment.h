#pragma once

#include "Base/Progress.h"
#include "Hex/Polycube/Private/WorkingSolid.h"

#include <Eigen/Core>

namespace shape
{

/// Returns the unit vector of a label: +x, -x, +y, -y, +z, -z.
Eigen::RowVector3d GetLabelAxis(int label);

/// Returns a rotation that brings the normals of a surface closest to the axes: it minimises the
/// integral of |nx| + |ny| + |nz| over the area. The identity if no rotation is better by 1 %.
Eigen::Matrix3d FindAxisRotation(const Mesh& surface);

/**
 * Deforms a solid, with little distortion, until the normals of its surface are close to the axes.
 * It alternates between two steps: rotations that align the normals, smooth inside the solid, and
 * the shape whose tetrahedra are rotated by them (Gregson, Sheffer and Zhang, "All-hex mesh
 * generation via volumetric polycube deformation", 2011, section 4).
 *
 * Returns the positions of the points (n x 3); tetrahedra may be inverted. Throws Aborted.
 */
Eigen::MatrixXd AlignWithAxes(const WorkingSolid& solid, const Progress& progress = {});

/**
 * Does the same with a given axis for each triangle: the tetrahedra stay as rigid as possible while
 * the triangles become perpendicular to their axes, with a weight that grows.
 *
 * labels: of the triangles. start: the initial positions.
 */
Eigen::MatrixXd FlattenAlongAxes(const WorkingSolid& solid, const Eigen::VectorXi& labels,
  const Eigen::MatrixXd& start, const Progress& progress = {});

} // namespace shape
