#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"
#include "Mesh/Mesh.h"
#include "Quality/CellSimplices.h"

#include "vtkSmartPointer.h"

#include <string>
#include <vector>

class vtkDataObject;
class vtkDataSet;
class vtkDoubleArray;
class vtkIntArray;
class vtkPolyData;
class vtkUnstructuredGrid;

/**
 * The only conversion of VTK data sets to kernel types and back. `name` is what an error calls
 * the data: "the boundary".
 */
namespace vtkShapeConvert
{

/// The surface's polygons and strips as triangles over the same points. Throws shape::InvalidInput
/// if a polygon cannot be triangulated.
shape::Mesh ToMesh(vtkPolyData* surface, const std::string& name);

/// The points of each of its lines and polylines, by their ids.
std::vector<std::vector<int>> ToLines(vtkPolyData* data);

/// The grid's cells, of any kinds. Throws shape::InvalidInput if there are too many to number.
shape::Cells ToCells(vtkUnstructuredGrid* grid, const std::string& name);

/// Makes voxels hexahedra and pixels quadrilaterals.
void ReorderVoxels(shape::Cells& cells);

/// The points of any data set (n x 3). Throws shape::InvalidInput if there are too many.
Eigen::MatrixXd ToPoints(vtkDataSet* data);

/// The cells in order, over the same points: tetrahedra, pyramids, wedges, hexahedra, voxels and
/// triangles by their corners, every other surface or solid cell by the simplices that it is cut
/// into. Points and lines have none. Throws shape::InvalidInput if there are too many points,
/// shape::Aborted.
shape::CellSimplices ToSimplices(
  vtkDataSet* data, const std::string& name, const shape::Progress& progress = {});

/// A point array (n x components); an empty block, or an empty piece of what other processes have,
/// may lack its arrays. Throws shape::InvalidInput if it is missing or has another number of
/// components or tuples; the message lists the arrays that are there.
Eigen::MatrixXd ToPointArray(
  vtkDataSet* data, const std::string& array, int components, const std::string& name);

/// Rows of `values` as tuples.
vtkSmartPointer<vtkDoubleArray> ToArray(const Eigen::MatrixXd& values, const std::string& array);

/// Entries of `values` as tuples of one component.
vtkSmartPointer<vtkIntArray> ToIntegers(const Eigen::VectorXi& values, const std::string& array);

/// Rows `rows` of `values`, in order.
Eigen::MatrixXd Rows(const Eigen::MatrixXd& values, const std::vector<int>& rows);

/// A mesh as a surface.
void FromMesh(const shape::Mesh& mesh, vtkPolyData* output);

/// Field data: one number, or words.
void AddFact(vtkDataObject* output, const std::string& name, double value);
void AddFact(vtkDataObject* output, const std::string& name, const std::string& words);

} // namespace vtkShapeConvert
