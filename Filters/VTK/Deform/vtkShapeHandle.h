#pragma once

#include "vtkCellArray.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include "Deform/Deform.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataObject;
class vtkDataSet;
class vtkPolyData;
class vtkUnstructuredGrid;

/// Conversion of the shape and the handle of vtkShapeDeform to kernel types, and of the deformed
/// shape to VTK data.
namespace vtkShapeHandle
{

/// Returns the points of a grid, and its cells as lines, triangles and tetrahedra. Cells of other
/// types are divided into these. name: denotes the grid in errors. Throws the exceptions of
/// vtkShapeConvert::ToSimplices.
shape::ShapeElements ToElements(
  vtkUnstructuredGrid* grid, const std::string& name, const shape::Progress& progress = {});

/// Returns a label for each point from a point array or a cell array with one component. With a
/// cell array, a point gets the most frequent label of the cells around it. If several labels are
/// equally frequent, it gets the lowest. name: denotes the shape in errors. Throws
/// shape::InvalidInput if there is neither array, or a label does not fit into an int.
Eigen::VectorXi ToLabels(vtkDataSet* shape, const std::string& array, const std::string& name);

struct Boundary
{
  shape::BoundaryHandle Source;
  shape::HandleTarget Target;
};

/// Reads the handle before (Source) and after (Target) its motion. The old positions are the point
/// array `SourcePosition`. Without this array, the handle is at rest, and each of its points must
/// lie on the shape, at most an edge away from a point of it. The optional point arrays are
/// `SourceNormal` and `TargetNormal`, and `FrameRotation` with `FrameSet`. Throws
/// shape::InvalidInput if an array is missing or has another number of components, or if a handle
/// without SourcePosition is off the shape.
Boundary Read(vtkUnstructuredGrid* boundary, const shape::ShapeElements& shape);

/// Writes the points and cells of a handle whose samples are at `positions` (s x 3): its triangles
/// and segments or, without any, a vertex for each sample.
void WriteCells(
  const shape::BoundaryHandle& handle, const Eigen::MatrixXd& positions, vtkPolyData* output);

/// What does not move of a block of the shape. Successive outputs share these arrays, so that their
/// ranges, which a window shows, are computed once.
struct Unmoved
{
  vtkDataSet* Block = nullptr; ///< only compared, with its modification time
  vtkMTimeType Time = 0;
  std::vector<int> Rows; ///< for each point of the block, its row of the complete shape
  std::vector<vtkSmartPointer<vtkDataArray>> Arrays;
  /// The polygons of a surface whose ids are stored as vtkIdType, so that they are read without
  /// being copied, as for the bounds that a window asks for.
  vtkSmartPointer<vtkCellArray> Polygons;
};

/// Writes the handle at its target, with the point arrays `SourcePosition`, `SourceNormal` and
/// `TargetNormal` (double, 3), `Part` (int) and `FrameTurn` (double, 3; degrees), and the point
/// data of the grid that it comes from. points: for each sample, its point of the grid. deformer:
/// after the deformation. parts: FindHandleParts. frames: the rotations that FrameTurn
/// interpolates.
void WriteHandle(const shape::BoundaryHandle& handle, const shape::Deformer& deformer,
  const shape::HandleParts& parts, const std::vector<shape::FrameRotation>& frames,
  vtkUnstructuredGrid* grid, const std::vector<int>& points, vtkPolyData* output);

/// Writes the deformed `input`, which is a part of the shape, to `output`. Adds the point arrays
/// `SourcePosition`, `ArrivalTime` and, if there are any, `Protrusion`, and rotates point normals.
/// whole: n x 3, the points of the complete shape before the deformation. deformed: the complete
/// shape after it. unmoved: what the last call wrote for each block, if `whole`, the arrival times
/// and the protrusions are the same, otherwise empty; blocks that have changed are written anew.
/// Throws shape::InvalidInput if a point of `input` is not in `whole`.
void Write(vtkDataObject* input, const Eigen::MatrixXd& whole, const shape::DeformedShape& deformed,
  std::vector<Unmoved>& unmoved, vtkDataObject* output);

} // namespace vtkShapeHandle
