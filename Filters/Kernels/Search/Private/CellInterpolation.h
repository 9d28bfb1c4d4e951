#pragma once

#include "Mesh/Cells.h"

#include <Eigen/Core>

class vtkGenericCell;

namespace shape
{

/// How far beyond a cell a place still lies in it: a share of its size, and of its weights.
constexpr double CellRounding = 1e-6;

/// Makes `cell` the cell of that number, with the point ids of `cells`.
void LoadCell(const Cells& cells, int number, vtkGenericCell* cell);

/**
 * The values of a solid cell's shape functions at `place`, one for each of its corners, which they
 * interpolate to the place itself. Empty where the place lies outside, or the shape functions
 * cannot be inverted. cell: a cell to work with.
 */
Eigen::VectorXd ComputeCellWeights(
  const Cells& cells, int number, const Eigen::RowVector3d& position, vtkGenericCell* cell);

/// A place on the sides of a cell, cut into triangles.
struct PointOnEdges
{
  double Distance2;                ///< squared; infinite where the cell has no sides
  Eigen::RowVector3i Points;       ///< the corners of a triangle
  Eigen::RowVector3d Barycentrics; ///< the place in it
};

/// The one closest to `place`. cell: a cell to work with.
PointOnEdges FindClosestPointOnEdges(
  const Cells& cells, int number, const Eigen::RowVector3d& position, vtkGenericCell* cell);

} // namespace shape
