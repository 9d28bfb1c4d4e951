#pragma once

#include "ExponentialMap/PatchLayout.h"

#include <Eigen/Core>

class vtkPolyData;

/// Conversion of a flattened patch to data.
namespace vtkShapePatch
{

/// Writes the patch of a surface to `output`, with the data of its points and cells, and the arrays
/// and field data of vtkShapeExponentialMap. mesh: the surface's triangles; cells: the cell of the
/// surface that each triangle is a part of.
void Write(const shape::PatchLayout& layout, const shape::Mesh& mesh, vtkPolyData* surface,
  const Eigen::VectorXi& cells, vtkPolyData* output);

} // namespace vtkShapePatch
