#pragma once

#include "Hex/Fit/HexFit.h"

#include <Eigen/Core>

namespace shape
{

/// The regular grid whose cells became the hexahedra of a solid. It is the domain of a map onto the
/// solid, whose values are the solid's points.
struct HexGrid
{
  Eigen::MatrixXi Cells; ///< m x 8: points of the solid, in VTK's order
  /// n x 3: the position in the grid of each point of the solid, in the surface's units. Points of
  /// cells lie at integer multiples of the cell size, up to a translation.
  Eigen::MatrixXd SourcePositions;
  /// For each cell: its structured block, and its indices i, j, k from 0 in this block.
  Eigen::VectorXi BlockOf;
  Eigen::MatrixXi Indices; ///< m x 3
  int Blocks = 0;
};

/**
 * Finds the grid of fitted hexahedra.
 *
 * Points that layers added lie between those of the grid: on the boundary, and then inside, their
 * positions are the discrete harmonic functions of the edges of the hexahedra, whose values at the
 * points of the grid are given.
 *
 * The walls between blocks continue faces of the boundary straight into the solid, from edges where
 * the boundary is concave to the boundary. At the end of a slit, where faces of the boundary touch
 * each other, there is also a wall across. Blocks are therefore boxes, and each side of a block is
 * a side of one other block or lies on the boundary.
 *
 * positions: for each point of fit.Core, its position in the grid, of which each cell is a cube of
 * the edge length cellSize; without rows, the cells must be those of an image along its axes, and
 * the position of the first cell of each component is near that of its hexahedron. Throws Aborted.
 */
HexGrid FindHexGrid(const HexFit& fit, const Eigen::MatrixXd& positions, double cellSize,
  const Progress& progress = {});

} // namespace shape
