#pragma once

#include "Base/Progress.h"
#include "Hex/Polycube/Private/WorkingSolid.h"

#include <Eigen/Core>

namespace shape
{

/// The unit vector of a label: +x, -x, +y, -y, +z, -z.
Eigen::RowVector3d GetLabelAxis(int label);

/// A rotation after which the normals of a surface are closest to the axes: it minimises the sum of
/// |nx| + |ny| + |nz| over the area. The identity where nothing is better by a hundredth.
Eigen::Matrix3d FindAxisRotation(const Mesh& surface);

/**
 * Bends a solid so that the normals of its surface come close to the axes, with little distortion:
 * rotations that take them there, made smooth inside, then the shape whose tetrahedra are turned
 * by them, and so on (Gregson, Sheffer and Zhang, "All-hex mesh generation via volumetric polycube
 * deformation", 2011, section 4).
 *
 * Returns the positions of the points (n x 3), which may fold. Throws Aborted.
 */
Eigen::MatrixXd AlignWithAxes(const WorkingSolid& solid, const Progress& progress = {});

/**
 * The same with the axis of each triangle given: the shape whose tetrahedra are as rigid as can be
 * while the triangles are flat across their axes, ever more so.
 *
 * labels: of the triangles; start: positions to begin with.
 */
Eigen::MatrixXd FlattenAlongAxes(const WorkingSolid& solid, const Eigen::VectorXi& labels,
  const Eigen::MatrixXd& start, const Progress& progress = {});

} // namespace shape
