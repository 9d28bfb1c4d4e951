#pragma once

#include "Deform/Deform.h"

#include <string>

class vtkDataObject;
class vtkUnstructuredGrid;

/// What is deformed, and by what, as vtkShapeDeform reads them.
namespace vtkShapeHandle
{

/// The points and cells of a grid of any kinds: lines, triangles and tetrahedra, into which other
/// cells are cut. Throws shape::InvalidInput, shape::Aborted.
shape::ShapeElements ToElements(
  vtkUnstructuredGrid* grid, const std::string& name, const shape::Progress& progress = {});

/// Labels of the points by a point array of one component, or a cell array: then the most
/// frequent one of the cells around a point, the lowest of several. Throws shape::InvalidInput if
/// there is neither.
Eigen::VectorXi ToLabels(vtkUnstructuredGrid* grid, const std::string& array);

struct Boundary
{
  shape::BoundaryHandle Source;
  shape::HandleTarget Target;
};

/// Reads the point arrays `SourcePosition`, `SourceNormal` and `TargetNormal`, `FrameRotation` and
/// `FrameSet`. Throws shape::InvalidInput.
Boundary Read(vtkUnstructuredGrid* boundary);

/// Makes `output` like `input`, a part of the shape with the points `whole`, as they were deformed:
/// with the point array `SourcePosition`, and normals of points turned. Throws shape::InvalidInput.
void Write(vtkDataObject* input, const Eigen::MatrixXd& whole, const shape::DeformedShape& deformed,
  vtkDataObject* output);

} // namespace vtkShapeHandle
