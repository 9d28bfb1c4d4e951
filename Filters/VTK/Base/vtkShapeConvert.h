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
 * The only conversion of VTK data sets to kernel types and back. `name` denotes the data in errors,
 * for example "the boundary".
 */
namespace vtkShapeConvert
{

/// Converts the surface's polygons and strips to triangles over the same points. cellOf: if given,
/// becomes the polygon, or the strip after the polygons, of each triangle. A polygon may have sides
/// of length 0: its repeated corners are left out, and become corners of triangles without area, so
/// that neighbours stay connected. Throws shape::InvalidInput if a polygon cannot be triangulated.
shape::Mesh ToMesh(
  vtkPolyData* surface, const std::string& name, std::vector<int>* cellOf = nullptr);

/// Returns the point indices of each line and polyline.
std::vector<std::vector<int>> ToLines(vtkPolyData* data);

/// Converts the cells of a grid, of any type. Throws shape::InvalidInput if it has more points or
/// corners than an int can number.
shape::Cells ToCells(vtkUnstructuredGrid* grid, const std::string& name);

/// Converts voxels to hexahedra and pixels to quadrilaterals.
void ReorderVoxels(shape::Cells& cells);

/// Returns the points of any data set (n x 3). Throws shape::InvalidInput if it has more points
/// than an int can number.
Eigen::MatrixXd ToPoints(vtkDataSet* data);

/// Converts the cells in order, over the same points. Tetrahedra, pyramids, wedges, hexahedra,
/// voxels and triangles are given by their corners. Other surface or solid cells are divided into
/// simplices. Points and lines have no simplices. Throws shape::InvalidInput if there are more
/// points or cells than an int can number, and shape::Aborted.
shape::CellSimplices ToSimplices(
  vtkDataSet* data, const std::string& name, const shape::Progress& progress = {});

/// Returns whether the property of an optional array names one: "None" and "" do not.
bool IsChosen(const std::string& array);

/// Returns a point array (n x components). The array may be missing in data without points, such as
/// an empty piece of distributed data. Throws shape::InvalidInput if the array is missing or has
/// another number of components or tuples; the message lists the existing arrays. remedy: said if
/// the array is missing, by default which filter makes such an array.
Eigen::MatrixXd ToPointArray(vtkDataSet* data, const std::string& array, int components,
  const std::string& name, const std::string& remedy = "");

/// Returns the values of an array of cells, which must be whole numbers. Throws shape::InvalidInput
/// if they are not, or if the array does not have one component and one tuple for each cell.
/// remedy: said in the message, such as which other array to use.
Eigen::VectorXi ToCellIntegers(
  vtkDataSet* data, const std::string& array, const std::string& name, const std::string& remedy);

/// Returns an array whose tuples are the rows of `values`.
vtkSmartPointer<vtkDoubleArray> ToArray(
  const Eigen::Ref<const Eigen::MatrixXd>& values, const std::string& array);

/// Returns an array of one component with the entries of `values`.
vtkSmartPointer<vtkIntArray> ToIntegers(const Eigen::VectorXi& values, const std::string& array);

/// Returns the given rows of `values`, in order.
Eigen::MatrixXd Rows(const Eigen::MatrixXd& values, const std::vector<int>& rows);

/// Converts a mesh to a surface.
void FromMesh(const shape::Mesh& mesh, vtkPolyData* output);

/// Adds an array with one number or one string to the field data.
void AddFact(vtkDataObject* output, const std::string& name, double value);
void AddFact(vtkDataObject* output, const std::string& name, const std::string& words);

} // namespace vtkShapeConvert
