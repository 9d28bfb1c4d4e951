#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <string>

class vtkUnstructuredGrid;

/// The polygons and strips of a grid as triangles.
struct vtkShapeSoup
{
  /// Every polygon of n points gives n - 2 triangles, also if it is degenerate. Vertices and lines
  /// are ignored. Throws shape::InvalidInput if the grid has no polygon, or has a cell of another
  /// type. name: denotes the grid in errors.
  vtkShapeSoup(vtkUnstructuredGrid* grid, const std::string& name);

  shape::Mesh Surface;
  Eigen::VectorXi Cells;  ///< the cell of each triangle
  bool IsPolygons = true; ///< whether every cell of the grid is a polygon
};
