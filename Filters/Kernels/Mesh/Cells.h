#pragma once

#include <Eigen/Core>

namespace shape
{

/// Names of the kinds of cells, numbered as in VTK.
namespace cell_kind
{
inline constexpr int Vertex = 1, Line = 3, Triangle = 5, Quadrilateral = 9, Tetrahedron = 10,
                     Hexahedron = 12, Wedge = 13, Pyramid = 14;
}

/**
 * Cells of any kinds over common points: a solid, or a surface of polygons.
 *
 * Points: n x 3. Cell c has the points Corners(Offsets(c)), ..., Corners(Offsets(c + 1) - 1), in
 * VTK's order for the cell's kind.
 */
struct Cells
{
  Eigen::MatrixXd Points;
  Eigen::VectorXi Kinds;   ///< m: one of cell_kind, or another VTK cell type
  Eigen::VectorXi Offsets; ///< m + 1 offsets into Corners; the first is 0
  Eigen::VectorXi Corners; ///< indices of points
};

} // namespace shape
