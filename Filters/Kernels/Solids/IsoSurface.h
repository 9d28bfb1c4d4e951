#pragma once

#include "Mesh/Mesh.h"

namespace shape
{

/// Values at the points of a uniform grid.
struct SampledGrid
{
  Eigen::RowVector3d Origin; ///< the position of grid point (0, 0, 0)
  double Spacing = 0.0;      ///< > 0, along each axis
  Eigen::RowVector3i Counts; ///< number of points along x, y, z, each >= 2
  Eigen::VectorXd Values;    ///< Counts.prod() values, x fastest, then y, then z

  /// Returns the position of a grid point.
  Eigen::RowVector3d Point(int x, int y, int z) const
  {
    return this->Origin + this->Spacing * Eigen::RowVector3d(x, y, z);
  }
  /// Returns the index of a grid point in Values.
  int Index(int x, int y, int z) const { return x + this->Counts(0) * (y + this->Counts(1) * z); }
};

/// Returns the isosurface of the samples at `value` (vtkFlyingEdges3D). Triangles are
/// counter-clockwise seen from the side of greater values. The surface is closed if it does not
/// meet the grid's boundary. It is empty if all samples lie on the same side of `value`.
Mesh ExtractIsoSurface(const SampledGrid& grid, double value);

} // namespace shape
