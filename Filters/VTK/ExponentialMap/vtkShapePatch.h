#pragma once

#include "ExponentialMap/PatchLayout.h"

#include <Eigen/Core>

class vtkPolyData;

/// A flattened patch as data.
namespace vtkShapePatch
{

/// Makes `output` the patch of a surface with the data of its points and cells, the arrays and the
/// field data of vtkShapeExponentialMap. mesh: the surface's triangles; cells: of which of its
/// cells each is a part.
void Write(const shape::PatchLayout& layout, const shape::Mesh& mesh, vtkPolyData* surface,
  const Eigen::VectorXi& cells, vtkPolyData* output);

} // namespace vtkShapePatch
