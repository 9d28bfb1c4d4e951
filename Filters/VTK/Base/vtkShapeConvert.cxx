#include "vtkShapeConvert.h"

#include "vtkShapeTriangulation.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace
{

/// Finds the shape of a type of cell. A voxel has the corners of a hexahedron, in another order.
/// Returns false for other types, which have no such shape.
bool ShapeOf(int cellType, shape::CellShape& shape)
{
  switch (cellType)
  {
    case VTK_TRIANGLE:
      shape = shape::CellShape::Triangle;
      return true;
    case VTK_TETRA:
      shape = shape::CellShape::Tetrahedron;
      return true;
    case VTK_PYRAMID:
      shape = shape::CellShape::Pyramid;
      return true;
    case VTK_WEDGE:
      shape = shape::CellShape::Wedge;
      return true;
    case VTK_HEXAHEDRON:
    case VTK_VOXEL:
      shape = shape::CellShape::Hexahedron;
      return true;
    default:
      return false;
  }
}

/// Appends the triangles or tetrahedra into which a cell is divided.
void AddTriangulated(vtkCell* cell, shape::CellSimplices& cells)
{
  const int corners = cell->GetCellDimension() + 1;
  if (corners < 3)
  {
    return;
  }
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> positions;
  cell->Triangulate(0, ids, positions);
  for (vtkIdType first = 0; first + corners <= ids->GetNumberOfIds(); first += corners)
  {
    int points[4];
    for (int k = 0; k < corners; ++k)
    {
      points[k] = static_cast<int>(ids->GetId(first + k));
    }
    cells.Add(corners == 3 ? shape::CellShape::Triangle : shape::CellShape::Tetrahedron, points);
  }
}

} // namespace

shape::Mesh vtkShapeConvert::ToMesh(
  vtkPolyData* surface, const std::string& name, std::vector<int>* cellOf)
{
  vtkShapeTriangulation triangulation = vtkShapeTriangulation::Of(surface, name);
  const auto count = static_cast<Eigen::Index>(triangulation.Triangles.size());
  shape::Mesh mesh{ ToPoints(surface), Eigen::MatrixXi(count, 3) };
  for (Eigen::Index t = 0; t < count; ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      mesh.Triangles(t, corner) = static_cast<int>(triangulation.Triangles[t][corner]);
    }
  }
  if (cellOf)
  {
    *cellOf = std::move(triangulation.CellOf);
  }
  return mesh;
}

std::vector<std::vector<int>> vtkShapeConvert::ToLines(vtkPolyData* data)
{
  std::vector<std::vector<int>> lines;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfLines(); ++cell)
  {
    data->GetLines()->GetCellAtId(cell, ids);
    lines.emplace_back(ids->begin(), ids->end());
  }
  return lines;
}

shape::Cells vtkShapeConvert::ToCells(vtkUnstructuredGrid* grid, const std::string& name)
{
  vtkCellArray* all = grid->GetCells();
  const vtkIdType count = grid->GetNumberOfCells();
  const vtkIdType corners = all ? all->GetNumberOfConnectivityIds() : 0;
  if (std::max(grid->GetNumberOfPoints(), corners) > std::numeric_limits<int>::max())
  {
    throw shape::InvalidInput(name + " has more than 2^31 points or corners; use a coarser mesh");
  }
  shape::Cells cells{ ToPoints(grid), Eigen::VectorXi(count), Eigen::VectorXi(count + 1),
    Eigen::VectorXi(corners) };
  cells.Offsets(0) = 0;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < count; ++cell)
  {
    cells.Kinds(cell) = grid->GetCellType(cell);
    all->GetCellAtId(cell, ids);
    const int first = cells.Offsets(cell);
    std::copy(ids->begin(), ids->end(), cells.Corners.begin() + first);
    cells.Offsets(cell + 1) = first + static_cast<int>(ids->GetNumberOfIds());
  }
  return cells;
}

/// VTK numbers the corners of pixels and voxels row by row, but the corners of quads and hexahedra
/// around each face.
void vtkShapeConvert::ReorderVoxels(shape::Cells& cells)
{
  for (Eigen::Index cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    int* corners = cells.Corners.data() + cells.Offsets(cell);
    if (cells.Kinds(cell) == VTK_PIXEL || cells.Kinds(cell) == VTK_VOXEL)
    {
      std::swap(corners[2], corners[3]);
    }
    if (cells.Kinds(cell) == VTK_PIXEL)
    {
      cells.Kinds(cell) = VTK_QUAD;
    }
    else if (cells.Kinds(cell) == VTK_VOXEL)
    {
      std::swap(corners[6], corners[7]);
      cells.Kinds(cell) = VTK_HEXAHEDRON;
    }
  }
}

Eigen::MatrixXd vtkShapeConvert::ToPoints(vtkDataSet* data)
{
  if (data->GetNumberOfPoints() > std::numeric_limits<int>::max())
  {
    throw shape::InvalidInput(
      "a data set has more than 2^31 points; divide it into blocks, or use more processes");
  }
  Eigen::MatrixXd points(data->GetNumberOfPoints(), 3);
  Eigen::RowVector3d point;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    data->GetPoint(i, point.data());
    points.row(i) = point;
  }
  return points;
}

shape::CellSimplices vtkShapeConvert::ToSimplices(
  vtkDataSet* data, const std::string& name, const shape::Progress& progress)
{
  if (data->GetNumberOfPoints() > std::numeric_limits<int>::max() ||
    // A cell has up to eight corners, and their number must fit into an int.
    data->GetNumberOfCells() > std::numeric_limits<int>::max() / 8)
  {
    throw shape::InvalidInput(name +
      " has more than 2^31 points or more than 2^28 cells; divide it into blocks, "
      "or use more processes");
  }
  shape::CellSimplices cells;
  vtkNew<vtkGenericCell> generic;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    if (cell % 65536 == 0)
    {
      progress(static_cast<double>(cell) / static_cast<double>(data->GetNumberOfCells()));
    }
    const int type = data->GetCellType(cell);
    shape::CellShape shape;
    if (ShapeOf(type, shape))
    {
      data->GetCellPoints(cell, ids);
      // A hexahedron has the most corners of these shapes.
      int points[8];
      std::copy(ids->begin(), ids->end(), points);
      if (type == VTK_VOXEL)
      {
        std::swap(points[2], points[3]);
        std::swap(points[6], points[7]);
      }
      cells.Add(shape, points);
    }
    else
    {
      // Polygons, quadratic and other cells are divided by VTK itself.
      data->GetCell(cell, generic);
      AddTriangulated(generic, cells);
    }
    cells.EndCell();
  }
  return cells;
}

namespace
{

/// The remedy if a point array is missing.
std::string WhoMakes(const std::string& array)
{
  if (array == "TargetPosition")
  {
    return "make it with Shape Correspondence, Shape Parameterize or Shape Polycube";
  }
  if (array == "SourcePosition")
  {
    return "take the second output of Shape Parameterize or Shape Polycube";
  }
  return "choose another array, or add it with Calculator";
}

} // namespace

bool vtkShapeConvert::IsChosen(const std::string& array)
{
  return !array.empty() && array != "None";
}

Eigen::MatrixXd vtkShapeConvert::ToPointArray(vtkDataSet* data, const std::string& array,
  int components, const std::string& name, const std::string& remedy)
{
  // A process or block without points may have no arrays.
  if (data->GetNumberOfPoints() == 0)
  {
    return Eigen::MatrixXd(0, components);
  }
  vtkDataArray* values = data->GetPointData()->GetArray(array.c_str());
  if (!values && data->GetPointData()->HasArray(array.c_str()))
  {
    throw shape::InvalidInput("the point array '" + array + "' of " + name +
      " contains strings; choose an array of numbers");
  }
  if (!values)
  {
    std::string present;
    for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
    {
      const char* other = data->GetPointData()->GetArrayName(i);
      present += (present.empty() ? "" : ", ") + std::string(other ? other : "(unnamed)");
    }
    throw shape::InvalidInput(name + " has no point array '" + array + "'; " +
      (remedy.empty() ? WhoMakes(array) : remedy) +
      (present.empty() ? "" : " (present: " + present + ")"));
  }
  if (values->GetNumberOfComponents() != components)
  {
    throw shape::InvalidInput("the point array '" + array + "' of " + name + " has " +
      std::to_string(values->GetNumberOfComponents()) + " components, not " +
      std::to_string(components) + "; choose another array");
  }
  if (values->GetNumberOfTuples() != data->GetNumberOfPoints())
  {
    throw shape::InvalidInput("the point array '" + array + "' of " + name + " has " +
      std::to_string(values->GetNumberOfTuples()) + " tuples for " +
      std::to_string(data->GetNumberOfPoints()) +
      " points; use an array with one tuple for each point");
  }
  Eigen::MatrixXd matrix(values->GetNumberOfTuples(), components);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      matrix(i, c) = values->GetComponent(i, c);
    }
  }
  return matrix;
}

Eigen::VectorXi vtkShapeConvert::ToCellIntegers(
  vtkDataSet* data, const std::string& array, const std::string& name, const std::string& remedy)
{
  vtkDataArray* values = data->GetCellData()->GetArray(array.c_str());
  if (!values || values->GetNumberOfComponents() != 1 ||
    values->GetNumberOfTuples() != data->GetNumberOfCells())
  {
    throw shape::InvalidInput(
      name + " has no cell array '" + array + "' with one number for each cell; " + remedy);
  }
  Eigen::VectorXi integers(values->GetNumberOfTuples());
  for (Eigen::Index cell = 0; cell < integers.size(); ++cell)
  {
    const double value = values->GetComponent(cell, 0);
    // Not a number is unlike itself.
    if (value != std::floor(value) || std::abs(value) >= std::numeric_limits<int>::max())
    {
      throw shape::InvalidInput("the cell array '" + array + "' of " + name + " has the value " +
        shape::FormatNumber(value) + " at cell " + std::to_string(cell) +
        "; use integers from 0, or " + remedy);
    }
    integers(cell) = static_cast<int>(value);
  }
  return integers;
}

vtkSmartPointer<vtkDoubleArray> vtkShapeConvert::ToArray(
  const Eigen::Ref<const Eigen::MatrixXd>& values, const std::string& array)
{
  auto tuples = vtkSmartPointer<vtkDoubleArray>::New();
  tuples->SetName(array.c_str());
  tuples->SetNumberOfComponents(static_cast<int>(values.cols()));
  tuples->SetNumberOfTuples(values.rows());
  Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> rows(
    tuples->GetPointer(0), values.rows(), values.cols());
  // In blocks that fit in the cache, because the matrix is stored by columns.
  constexpr Eigen::Index block = 64;
  for (Eigen::Index begin = 0; begin < values.rows(); begin += block)
  {
    const Eigen::Index count = std::min(block, values.rows() - begin);
    rows.middleRows(begin, count) = values.middleRows(begin, count);
  }
  return tuples;
}

vtkSmartPointer<vtkIntArray> vtkShapeConvert::ToIntegers(
  const Eigen::VectorXi& values, const std::string& array)
{
  auto tuples = vtkSmartPointer<vtkIntArray>::New();
  tuples->SetName(array.c_str());
  tuples->SetNumberOfTuples(values.size());
  std::copy(values.begin(), values.end(), tuples->GetPointer(0));
  return tuples;
}

Eigen::MatrixXd vtkShapeConvert::Rows(const Eigen::MatrixXd& values, const std::vector<int>& rows)
{
  return values(rows, Eigen::all);
}

void vtkShapeConvert::FromMesh(const shape::Mesh& mesh, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(ToArray(mesh.Points, "Points"));
  vtkNew<vtkCellArray> polys;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    polys->InsertNextCell({ mesh.Triangles(t, 0), mesh.Triangles(t, 1), mesh.Triangles(t, 2) });
  }
  output->SetPoints(points);
  output->SetPolys(polys);
}

void vtkShapeConvert::AddFact(vtkDataObject* output, const std::string& name, double value)
{
  output->GetFieldData()->AddArray(ToArray(Eigen::MatrixXd::Constant(1, 1, value), name));
}

void vtkShapeConvert::AddFact(
  vtkDataObject* output, const std::string& name, const std::string& words)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(words);
  output->GetFieldData()->AddArray(array);
}
