#pragma once

#include "Mesh/Mesh.h"

namespace shape
{

/// Values at the points of a uniform grid.
struct SampledGrid
{
  Eigen::RowVector3d Origin; ///< the point (0, 0, 0)
  double Spacing = 0.0;      ///< > 0, along each axis
  Eigen::RowVector3i Counts; ///< points along x, y, z, each >= 2
  Eigen::VectorXd Values;    ///< Counts.prod() values, x fastest, then y, then z

  /// The place of a grid point.
  Eigen::RowVector3d Point(int x, int y, int z) const
  {
    return this->Origin + this->Spacing * Eigen::RowVector3d(x, y, z);
  }
  /// The index of a grid point in Values.
  int Index(int x, int y, int z) const { return x + this->Counts(0) * (y + this->Counts(1) * z); }
};

/// The surface where the trilinear samples cross `value` (vtkFlyingEdges3D), counter-clockwise seen
/// from where they are greater. Closed where it stays away from the grid's sides; empty where no
/// sample lies beyond.
Mesh ExtractIsoSurface(const SampledGrid& grid, double value);

} // namespace shape
