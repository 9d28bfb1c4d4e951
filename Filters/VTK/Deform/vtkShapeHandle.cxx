#include "vtkShapeHandle.h"

#include "vtkShapeCarry.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeWholeRows.h"

#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkGenericCell.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Deform/HandleMotion.h"
#include "Mesh/Provenance.h"

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

vtkShapeHandle::Boundary vtkShapeHandle::Read(
  vtkUnstructuredGrid* grid, const shape::ShapeElements& shape)
{
  Boundary boundary;
  shape::ShapeElements elements = ToElements(grid, "the Boundary");
  const bool isAtRest = !grid->GetPointData()->HasArray("SourcePosition");
  boundary.Target.Positions = elements.Points;
  boundary.Source.Positions = isAtRest
    ? elements.Points
    : vtkShapeConvert::ToPointArray(grid, "SourcePosition", 3, "the Boundary");
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
  if (isAtRest)
  {
    try
    {
      shape::RequireOnShape(boundary.Source, shape);
    }
    catch (const shape::InvalidInput& error)
    {
      throw shape::InvalidInput("the Boundary has no point array 'SourcePosition', and " +
        std::string(error.what()) +
        "; add the old positions, or give a handle that lies on the Input");
    }
  }
  return boundary;
}

void vtkShapeHandle::WriteCells(
  const shape::BoundaryHandle& handle, const Eigen::MatrixXd& positions, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh({ positions, handle.Triangles }, output);
  vtkNew<vtkCellArray> lines;
  for (const auto& segment : handle.Segments.rowwise())
  {
    lines->InsertNextCell({ segment(0), segment(1) });
  }
  output->SetLines(lines);
  if (handle.Segments.rows() + handle.Triangles.rows() == 0)
  {
    vtkNew<vtkCellArray> vertices;
    for (vtkIdType i = 0; i < positions.rows(); ++i)
    {
      vertices->InsertNextCell(1, &i);
    }
    output->SetVerts(vertices);
  }
}

void vtkShapeHandle::WriteHandle(const shape::BoundaryHandle& handle,
  const shape::Deformer& deformer, const shape::HandleParts& parts,
  const std::vector<shape::FrameRotation>& frames, vtkUnstructuredGrid* grid,
  const std::vector<int>& points, vtkPolyData* output)
{
  const shape::HandlePose& pose = deformer.Pose();
  const Eigen::MatrixXd& normals = deformer.Normals();
  Eigen::MatrixXd turned(normals.rows(), 3);
  for (Eigen::Index i = 0; i < normals.rows(); ++i)
  {
    turned.row(i) = (pose.Rotations[i] * normals.row(i).transpose()).transpose();
  }
  const Eigen::MatrixXd turns =
    shape::InterpolateRotations(handle, shape::PrescribeRotations(handle, frames));
  WriteCells(handle, pose.Positions, output);
  vtkShapeCarry::Carry({ { grid,
                         shape::TraceCopies(points, grid->GetNumberOfPoints(),
                           Eigen::VectorXi::Constant(output->GetNumberOfCells(), -1)) } },
    output);
  vtkPointData* data = output->GetPointData();
  // What described the handle before it moved, and rotations that its frames already have.
  if (vtkDataArray* old = vtkShapeCarry::GetNormals(data))
  {
    data->RemoveArray(old->GetName());
  }
  for (const char* name : { "ArrivalTime", "FrameRotation", "FrameSet" })
  {
    data->RemoveArray(name);
  }
  constexpr double degrees = 180.0 / 3.14159265358979323846;
  data->AddArray(vtkShapeConvert::ToArray(handle.Positions, "SourcePosition"));
  data->AddArray(vtkShapeConvert::ToArray(normals, "SourceNormal"));
  data->AddArray(vtkShapeConvert::ToArray(turned, "TargetNormal"));
  data->AddArray(vtkShapeConvert::ToArray(degrees * turns, "FrameTurn"));
  data->AddArray(vtkShapeConvert::ToIntegers(Eigen::Map<const Eigen::VectorXi>(parts.PartOf.data(),
                                               static_cast<Eigen::Index>(parts.PartOf.size())),
    "Part"));
}

void vtkShapeHandle::Write(vtkDataObject* input, const Eigen::MatrixXd& whole,
  const shape::DeformedShape& deformed, std::vector<Unmoved>& unmoved, vtkDataObject* output)
{
  vtkShapeWholeRows positions(whole);
  std::size_t block = 0;
  vtkShapeComposite::ForEach(input, output, vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      unmoved.resize(std::max(unmoved.size(), ++block));
      Unmoved& own = unmoved[block - 1];
      if (own.Block != from || own.Time != from->GetMTime())
      {
        const Eigen::MatrixXd points = vtkShapeConvert::ToPoints(from);
        const std::vector<int> rows = positions.Find(points);
        own = { from, from->GetMTime(), rows,
          { vtkShapeConvert::ToArray(points, "SourcePosition"),
            vtkShapeConvert::ToArray(
              vtkShapeConvert::Rows(deformed.Arrivals, rows), "ArrivalTime") },
          nullptr };
        auto* surface = vtkPolyData::SafeDownCast(from);
        if (surface && surface->GetNumberOfPolys() > 0 &&
          !surface->GetPolys()->IsStorageShareable())
        {
          own.Polygons = vtkSmartPointer<vtkCellArray>::New();
          own.Polygons->DeepCopy(surface->GetPolys());
          own.Polygons->ConvertToDefaultStorage();
        }
        if (deformed.Protrusions.size() > 0)
        {
          own.Arrays.emplace_back(
            vtkShapeConvert::ToIntegers(deformed.Protrusions(rows), "Protrusion"));
        }
      }
      vtkShapeComposite::Move(from, vtkShapeConvert::Rows(deformed.Points, own.Rows), to);
      if (own.Polygons)
      {
        vtkPolyData::SafeDownCast(to)->SetPolys(own.Polygons);
      }
      for (vtkDataArray* array : own.Arrays)
      {
        to->GetPointData()->AddArray(array);
      }
      AddTurnedNormals(from, own.Rows, deformed.Rotations, to);
    });
}
