#pragma once

#include "Mesh/Cells.h"

#include <Eigen/Core>

class vtkGenericCell;

namespace shape
{

/// The tolerance for deciding whether a position lies inside a cell. It applies to the
/// interpolation weights, and to distances relative to the cell's size.
constexpr double CellRounding = 1e-6;

/// Sets `cell` to the cell `number` of `cells`, with the point ids that it has in `cells`.
void LoadCell(const Cells& cells, int number, vtkGenericCell* cell);

/**
 * Returns the values of a solid cell's shape functions at `position`, one for each of its corners.
 * Returns nothing if the position lies outside, or if the shape functions cannot be inverted. cell:
 * a buffer.
 */
Eigen::VectorXd ComputeCellWeights(
  const Cells& cells, int number, const Eigen::RowVector3d& position, vtkGenericCell* cell);

/// A point on the faces of a cell, which are split into triangles.
struct PointOnEdges
{
  double Distance2;                ///< squared distance; infinite if the cell has no faces
  Eigen::RowVector3i Points;       ///< the corners of the triangle
  Eigen::RowVector3d Barycentrics; ///< barycentric coordinates in the triangle
};

/// Returns the point on the faces of a cell closest to `position`. cell: a buffer.
PointOnEdges FindClosestPointOnEdges(
  const Cells& cells, int number, const Eigen::RowVector3d& position, vtkGenericCell* cell);

} // namespace shape
