#pragma once

#include "Mesh/Cells.h"
#include "Mesh/FaceMesh.h"

#include <Eigen/Core>

namespace shape
{

/// The quality of solid cells as flow solvers measure it; m values each.
struct SolidQuality
{
  /// Minimum over the corners of the determinant of the three edges, divided by the product of
  /// their lengths and by its value in a regular cell; 1 is the best. Of a hexahedron, see
  /// ComputeScaledJacobian. Of a polyhedron: minimum over the faces of the cosine of the angle
  /// between the normal and the line from the cell's centre to that of the face.
  Eigen::VectorXd ScaledJacobian;
  /// 1 if the determinant at a corner, or the cosine of a polyhedron, is not positive; else 0
  Eigen::VectorXi Inverted;
  /// Maximum over the inner faces of the angle between the normal and the line between the centres
  /// of the cells, in degrees from 0 to 180
  Eigen::VectorXd NonOrthogonality;
  /// Maximum over the faces of the distance from the face's centre to the line between the centres
  /// of the cells, relative to the face's radius in this direction; >= 0
  Eigen::VectorXd Skewness;
};

/**
 * Computes the quality of solid cells.
 *
 * NonOrthogonality and Skewness are those of OpenFOAM's checkMesh, with its centres of faces and
 * cells (H. Jasak, "Error analysis and estimation for the finite volume method with applications to
 * fluid flows", PhD thesis, Imperial College London, 1996). On a boundary face, the line is the
 * normal through the cell's centre.
 *
 * cells: tetrahedra, pyramids, wedges, hexahedra and polyhedra. faces: of these cells
 * (BuildFaceMesh). The faces of a mesh that is moved are built once, before it is moved: they tell
 * which side of a polyhedron's face is outside, and which way round wedges are numbered.
 */
SolidQuality ComputeSolidQuality(const Cells& cells, const FaceMesh& faces);

} // namespace shape
