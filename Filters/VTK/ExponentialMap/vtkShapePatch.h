#pragma once

#include "ExponentialMap/PatchLayout.h"

#include <Eigen/Core>

class vtkPolyData;

/// Conversion of a flattened patch to VTK data.
namespace vtkShapePatch
{

/// Writes the patch of a surface to `output`, with the point and cell data of the surface, and with
/// the arrays and facts of vtkShapeExponentialMap. mesh: the triangles of the surface. cells:
/// for each triangle, the cell of the surface to which it belongs.
void Write(const shape::PatchLayout& layout, const shape::Mesh& mesh, vtkPolyData* surface,
  const Eigen::VectorXi& cells, vtkPolyData* output);

/// Writes the patch of a point cloud: a vertex for each point. estimatedNormals: those of all
/// points of the cloud, or an empty matrix if it has normals.
void WritePoints(const shape::PatchLayout& layout, vtkPolyData* cloud,
  const Eigen::MatrixXd& estimatedNormals, vtkPolyData* output);

} // namespace vtkShapePatch
