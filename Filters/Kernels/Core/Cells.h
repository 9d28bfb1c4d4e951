#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * Cells of any kinds over common points: a solid, or a surface of polygons.
 *
 * Points: n x 3. Cell c has the points Corners(Offsets(c)), ..., Corners(Offsets(c + 1) - 1), in
 * the order of its kind, which is numbered as in VTK: 5 triangle, 10 tetrahedron, 12 hexahedron,
 * ...
 */
struct Cells
{
  Eigen::MatrixXd Points;
  Eigen::VectorXi Kinds;   ///< m
  Eigen::VectorXi Offsets; ///< m + 1, from 0
  Eigen::VectorXi Corners;
};

} // namespace shape
