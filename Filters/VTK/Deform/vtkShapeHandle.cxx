#include "vtkShapeHandle.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkCell.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <vector>

namespace
{

/// Returns the lines of a grid as consecutive pairs of points.
Eigen::MatrixXi LinesOf(vtkUnstructuredGrid* grid)
{
  std::vector<int> ends;
  vtkNew<vtkGenericCell> cell;
  vtkNew<vtkIdList> ids;
  vtkNew<vtkPoints> positions;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    const int type = grid->GetCellType(i);
    if (type == VTK_TRIANGLE || type == VTK_TETRA || type == VTK_HEXAHEDRON)
    {
      continue; // the most frequent cells, skipped without a look at each
    }
    grid->GetCell(i, cell);
    if (cell->GetCellDimension() == 1)
    {
      // Also divides polylines and quadratic lines into segments.
      cell->Triangulate(0, ids, positions);
      std::transform(ids->begin(), ids->end() - ids->GetNumberOfIds() % 2, std::back_inserter(ends),
        [](vtkIdType id) { return static_cast<int>(id); });
    }
  }
  return Eigen::Map<Eigen::Matrix<int, Eigen::Dynamic, 2, Eigen::RowMajor>>(
    ends.data(), static_cast<Eigen::Index>(ends.size() / 2), 2);
}

Eigen::MatrixXi AsRows(const std::vector<std::array<int, 4>>& corners, int count)
{
  Eigen::MatrixXi rows(corners.size(), count);
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    for (int k = 0; k < count; ++k)
    {
      rows(static_cast<Eigen::Index>(i), k) = corners[i][k];
    }
  }
  return rows;
}

Eigen::MatrixXd ArrayOrNothing(vtkUnstructuredGrid* grid, const char* name, int components)
{
  return grid->GetPointData()->HasArray(name)
    ? vtkShapeConvert::ToPointArray(grid, name, components, "the Boundary")
    : Eigen::MatrixXd(0, components);
}

int ToLabel(vtkDataArray* values, vtkIdType i)
{
  const double label = values->GetComponent(i, 0);
  if (!(std::abs(label) < std::numeric_limits<int>::max()))
  {
    throw shape::InvalidInput("the segment array '" + std::string(values->GetName()) +
      "' has the value " + std::to_string(label) + " at index " + std::to_string(i) +
      "; use values that fit into 32 bits");
  }
  return static_cast<int>(label);
}

/// Finds the points of the complete shape by position. Pieces and blocks find their points in this
/// way, since coincident points move as one.
class PointsByPosition
{
public:
  explicit PointsByPosition(const Eigen::MatrixXd& points)
    : Points(points)
  {
  }

  std::vector<int> Find(const Eigen::MatrixXd& own)
  {
    std::vector<int> found(own.rows());
    if (own.rows() == this->Points.rows() && own == this->Points) // a single block on one process
    {
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        found[i] = static_cast<int>(i);
      }
      return found;
    }
    if (this->Positions.empty())
    {
      for (Eigen::Index i = 0; i < this->Points.rows(); ++i)
      {
        this->Positions.emplace(At(this->Points, i), static_cast<int>(i));
      }
    }
    for (Eigen::Index i = 0; i < own.rows(); ++i)
    {
      const auto position = this->Positions.find(At(own, i));
      if (position == this->Positions.end())
      {
        throw shape::InvalidInput("point " + std::to_string(i) +
          " of a piece of the Input belongs only to hidden cells, or to ghost cells that no "
          "process owns; extract the visible cells with Threshold, or remove the point with Clean "
          "to Grid");
      }
      found[i] = position->second;
    }
    return found;
  }

private:
  static std::array<double, 3> At(const Eigen::MatrixXd& points, Eigen::Index i)
  {
    return { points(i, 0), points(i, 1), points(i, 2) };
  }

  const Eigen::MatrixXd& Points;
  // Exact positions are sufficient, because the complete shape was gathered from these points
  // without arithmetic.
  std::map<std::array<double, 3>, int> Positions;
};

/// Adds the point normals of a data set, rotated with the points.
void AddTurnedNormals(vtkDataSet* from, const std::vector<int>& rows,
  const std::vector<Eigen::Matrix3d>& rotations, vtkDataSet* to)
{
  vtkDataArray* active = from->GetPointData()->GetNormals();
  vtkDataArray* normals = active ? active : from->GetPointData()->GetArray("Normals");
  if (!normals || normals->GetNumberOfComponents() != 3)
  {
    return;
  }
  Eigen::MatrixXd turned(rows.size(), 3);
  for (Eigen::Index i = 0; i < turned.rows(); ++i)
  {
    Eigen::Vector3d normal;
    normals->GetTuple(i, normal.data());
    // The rotation of the frame, not the inverse transpose of a derivative: shapes without
    // triangles have rotations, too.
    turned.row(i) = (rotations[rows[i]] * normal).transpose();
  }
  const auto array =
    vtkShapeConvert::ToArray(turned, normals->GetName() ? normals->GetName() : "Normals");
  to->GetPointData()->AddArray(array);
  if (active)
  {
    to->GetPointData()->SetNormals(array);
  }
}

} // namespace

shape::ShapeElements vtkShapeHandle::ToElements(
  vtkUnstructuredGrid* grid, const std::string& name, const shape::Progress& progress)
{
  const shape::CellSimplices cells = vtkShapeConvert::ToSimplices(grid, name, progress);
  std::vector<std::array<int, 4>> triangles, tetrahedra;
  for (const auto& corners : cells.Corners)
  {
    (corners[3] < 0 ? triangles : tetrahedra).push_back(corners);
  }
  return { vtkShapeConvert::ToPoints(grid), LinesOf(grid), AsRows(triangles, 3),
    AsRows(tetrahedra, 4) };
}

Eigen::VectorXi vtkShapeHandle::ToLabels(
  vtkDataSet* shape, const std::string& array, const std::string& name)
{
  const vtkIdType points = shape->GetNumberOfPoints();
  vtkDataArray* cells = shape->GetCellData()->GetArray(array.c_str());
  if (shape->GetPointData()->HasArray(array.c_str()) || !cells)
  {
    return vtkShapeConvert::ToPointArray(shape, array, 1, name).col(0).cast<int>();
  }
  // A point gets the most frequent label of its cells. If several labels are equally frequent, it
  // gets the lowest.
  std::vector<std::map<int, int>> around(points);
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < shape->GetNumberOfCells(); ++cell)
  {
    shape->GetCellPoints(cell, ids);
    for (const vtkIdType point : *ids)
    {
      ++around[point][ToLabel(cells, cell)];
    }
  }
  Eigen::VectorXi labels = Eigen::VectorXi::Zero(points);
  for (vtkIdType point = 0; point < points; ++point)
  {
    int maximum = 0;
    for (const auto& [label, count] : around[point])
    {
      labels(point) = count > maximum ? label : labels(point);
      maximum = std::max(maximum, count);
    }
  }
  return labels;
}

vtkShapeHandle::Boundary vtkShapeHandle::Read(vtkUnstructuredGrid* grid)
{
  Boundary boundary;
  shape::ShapeElements elements = ToElements(grid, "the Boundary");
  boundary.Target.Positions = elements.Points;
  boundary.Source.Positions =
    vtkShapeConvert::ToPointArray(grid, "SourcePosition", 3, "the Boundary");
  boundary.Source.Segments = elements.Lines;
  boundary.Source.Triangles = elements.Triangles;
  boundary.Source.Normals = ArrayOrNothing(grid, "SourceNormal", 3);
  boundary.Target.Normals = ArrayOrNothing(grid, "TargetNormal", 3);
  boundary.Target.Turns.Turns = ArrayOrNothing(grid, "FrameRotation", 3);
  boundary.Target.Turns.IsSet = ArrayOrNothing(grid, "FrameSet", 1).cast<int>();
  if (boundary.Target.Turns.Turns.rows() != boundary.Target.Turns.IsSet.rows())
  {
    throw shape::InvalidInput("the Boundary has only one of the point arrays 'FrameRotation' "
                              "and 'FrameSet'; add both, or neither");
  }
  return boundary;
}

void vtkShapeHandle::Write(vtkDataObject* input, const Eigen::MatrixXd& whole,
  const shape::DeformedShape& deformed, vtkDataObject* output)
{
  PointsByPosition positions(whole);
  vtkShapeComposite::ForEach(input, output, vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const Eigen::MatrixXd own = vtkShapeConvert::ToPoints(from);
      const std::vector<int> rows = positions.Find(own);
      vtkShapeComposite::Move(from, vtkShapeConvert::Rows(deformed.Points, rows), to);
      to->GetPointData()->AddArray(vtkShapeConvert::ToArray(own, "SourcePosition"));
      to->GetPointData()->AddArray(
        vtkShapeConvert::ToArray(vtkShapeConvert::Rows(deformed.Arrivals, rows), "ArrivalTime"));
      if (deformed.Protrusions.size() > 0)
      {
        to->GetPointData()->AddArray(
          vtkShapeConvert::ToIntegers(deformed.Protrusions(rows), "Protrusion"));
      }
      AddTurnedNormals(from, rows, deformed.Rotations, to);
    });
}
