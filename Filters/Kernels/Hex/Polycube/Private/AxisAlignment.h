#pragma once

#include "Base/Progress.h"
#include "Hex/Polycube/Private/WorkingSolid.h"

#include <Eigen/Core>

namespace shape
{

/// Returns the unit vector of a label: 0..5 = +x, -x, +y, -y, +z, -z.
Eigen::RowVector3d GetLabelAxis(int label);

/// Returns the rotation that brings the normals of a surface closest to the axes. The rotation
/// minimises the integral of |nx| + |ny| + |nz| over the surface's area. Returns the identity if no
/// rotation lowers the integral by more than 1 %.
Eigen::Matrix3d FindAxisRotation(const Mesh& surface);

/**
 * Deforms a solid with little distortion until the normals of its surface are close to the axes.
 * Two steps alternate (Gregson, Sheffer and Zhang, "All-hex mesh generation via volumetric polycube
 * deformation", 2011, section 4). The first finds rotations that align the normals and vary
 * smoothly inside the solid. The second finds the shape whose tetrahedra are rotated accordingly.
 *
 * Returns the new positions of the points (n x 3). Tetrahedra may be inverted. Throws Aborted.
 */
Eigen::MatrixXd AlignWithAxes(const WorkingSolid& solid, const Progress& progress = {});

/**
 * Deforms a solid until each triangle of its surface is nearly perpendicular to a given axis. The
 * tetrahedra stay as rigid as possible. The weight that turns the triangles' normals towards the
 * axes grows from round to round. Returns the new positions of the points (n x 3). Throws Aborted.
 *
 * labels: for each triangle, the label of its axis (GetLabelAxis). start: the initial positions of
 * the points (n x 3).
 */
Eigen::MatrixXd FlattenAlongAxes(const WorkingSolid& solid, const Eigen::VectorXi& labels,
  const Eigen::MatrixXd& start, const Progress& progress = {});

} // namespace shape
