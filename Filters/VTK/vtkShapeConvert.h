#pragma once

#include "Core/Cells.h"
#include "Core/Mesh.h"
#include "Core/Progress.h"
#include "Quality/CellSimplices.h"

#include "vtkSmartPointer.h"

#include <functional>
#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkDoubleArray;
class vtkIntArray;
class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * The only place that turns VTK data sets into kernel types and back. `name` is what an error calls
 * the data: "the boundary".
 */
namespace vtkShapeConvert
{

/// The data set itself, or the blocks of a composite one that are there.
std::vector<vtkDataSet*> Leaves(vtkDataObject* data);

/// The surface's polygons and strips as triangles over the same points. Throws shape::InvalidInput
/// where a polygon cannot be triangulated.
shape::Mesh ToMesh(vtkPolyData* surface, const std::string& name);

/// The grid's cells, of any kinds. Throws shape::InvalidInput where there are too many to number.
shape::Cells ToCells(vtkUnstructuredGrid* grid, const std::string& name);

/// Makes voxels hexahedra and pixels quadrilaterals.
void TurnVoxels(shape::Cells& cells);

/// The points of any data set (n x 3). Throws shape::InvalidInput where there are too many.
Eigen::MatrixXd ToPoints(vtkDataSet* data);

/// The cells in order, over the same points: tetrahedra, pyramids, wedges, hexahedra, voxels and
/// triangles by their corners, every other surface or solid cell by the simplices that it is cut
/// into. Points and lines have none. Throws shape::InvalidInput where there are too many points,
/// shape::Aborted.
shape::CellSimplices ToSimplices(
  vtkDataSet* data, const std::string& name, const shape::Progress& progress = {});

/// A point array (n x components); an empty block, or an empty piece of what other processes have,
/// may lack its arrays. Throws shape::InvalidInput where it is missing or has another number of
/// components or tuples; the message lists the arrays that are there.
Eigen::MatrixXd ToPointArray(
  vtkDataSet* data, const std::string& array, int components, const std::string& name);

/// Rows of `values` as tuples.
vtkSmartPointer<vtkDoubleArray> ToArray(const Eigen::MatrixXd& values, const std::string& array);

/// Entries of `values` as tuples of one component.
vtkSmartPointer<vtkIntArray> ToIntegers(const Eigen::VectorXi& values, const std::string& array);

/// Rows `rows` of `values`, in order.
Eigen::MatrixXd Rows(const Eigen::MatrixXd& values, const std::vector<int>& rows);

/// Whether an output like an input keeps its points.
enum class Points
{
  Kept,
  Moved ///< anywhere: image data and rectilinear grids become structured grids
};

/// The class of a data object like `input`; composites that are no trees become multiblocks.
std::string TypeLike(vtkDataObject* input, Points points);

/**
 * Makes `output` the data set `input` with its points at `points` and its attributes passed on,
 * without Normals, which no longer fit. Image data and rectilinear grids become structured grids:
 * see vtkShapeAlgorithm.
 */
void Move(vtkDataSet* input, const Eigen::MatrixXd& points, vtkDataSet* output);

/**
 * Makes `output`, a TypeLike(input, points), like `input`, and calls `fill` with each data set in
 * `input` and the empty one that takes its place in `output`. Throws shape::InvalidInput where a
 * block is no data set.
 */
void ForEachLeaf(vtkDataObject* input, vtkDataObject* output, Points points,
  const std::function<void(vtkDataSet* input, vtkDataSet* output)>& fill);

/// Values of points (n x d), and the name of their array.
struct PointField
{
  std::string Name;
  Eigen::MatrixXd Values;
  bool AreIds = false; ///< whole numbers, for an array of vtkIdType; n x 1
};

/// Makes `output` like `input` with these fields of the points of its blocks, one after the other.
void AddPointFields(
  vtkDataObject* input, vtkDataObject* output, const std::vector<PointField>& fields);

/// A mesh as a surface.
void FromMesh(const shape::Mesh& mesh, vtkPolyData* output);

/// Field data: one number, or words.
void AddFact(vtkDataObject* output, const std::string& name, double value);
void AddFact(vtkDataObject* output, const std::string& name, const std::string& words);

} // namespace vtkShapeConvert
