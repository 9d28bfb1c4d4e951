#pragma once

#include "Fill/FillHoles.h"
#include "Transfer/PreciseArrays.h"

#include <vector>

class vtkPolyData;

/// Conversion of a surface with filled holes to VTK data: see vtkShapeFillHoles.
namespace vtkShapeFilledData
{

/// Writes `input` with the fills after its polygons, and the cell array `Filled`. numbered: the
/// triangles of `input`, which are also the first triangles of `filled`.
void Write(const shape::FilledSurface& filled, const shape::NumberedSurface& numbered,
  vtkPolyData* input, vtkPolyData* output);

/// Writes a point cloud with the points of its fills, as vertices, with normals at all points and
/// the cell array `Filled`. normals: unit normals at the points of `input`.
void WriteCloud(const shape::FilledSurface& filled, const Eigen::MatrixXd& normals,
  vtkPolyData* input, vtkPolyData* output);

/// Splits the points of the written output where sheets touch (shape::SplitTouchingSheets). Returns
/// the number of copies.
int Split(
  const shape::FilledSurface& filled, const shape::NumberedSurface& numbered, vtkPolyData* output);

/// Adds the facts that describe each fill. loops: for each fill, the index of its loop among
/// all loops.
void AddFacts(
  const shape::FilledSurface& filled, const std::vector<int>& loops, vtkPolyData* output);

} // namespace vtkShapeFilledData
