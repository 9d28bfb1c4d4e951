#include "vtkShapeFilledData.h"

#include "vtkShapeCarry.h"
#include "vtkShapeCloud.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFillValues.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"

#include "Fill/FillHoles.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/TouchingSheets.h"

#include <functional>
#include <numeric>
#include <string>
#include <utility>

namespace
{

using shape::FilledHole;
using shape::FilledSurface;

/// Writes the input's points, bit for bit, and those of the fills.
void WritePoints(const FilledSurface& filled, vtkPolyData* input, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  // The input's type, so that its coordinates keep their bits.
  points->SetDataType(input->GetPoints()->GetDataType());
  points->DeepCopy(input->GetPoints());
  const vtkIdType old = input->GetNumberOfPoints();
  points->Resize(filled.Surface.Points.rows());
  for (vtkIdType i = old; i < filled.Surface.Points.rows(); ++i)
  {
    points->InsertPoint(i, filled.Surface.Points.row(i).eval().data());
  }
  output->SetPoints(points);
}

/// Writes the input's cells, with the fills' triangles after its polygons. Returns the index of the
/// first of these.
vtkIdType WriteCells(
  const FilledSurface& filled, Eigen::Index first, vtkPolyData* input, vtkPolyData* output)
{
  output->SetVerts(input->GetVerts());
  output->SetLines(input->GetLines());
  output->SetStrips(input->GetStrips());
  vtkNew<vtkCellArray> polygons;
  polygons->DeepCopy(input->GetPolys());
  for (Eigen::Index t = first; t < filled.Surface.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corners = filled.Surface.Triangles.row(t);
    polygons->InsertNextCell({ corners(0), corners(1), corners(2) });
  }
  output->SetPolys(polygons);
  return input->GetNumberOfVerts() + input->GetNumberOfLines() + input->GetNumberOfPolys();
}

/// Returns the provenance from the cells of the input. begin: the first cell of the fills. Strips
/// come after the polygons, so the new triangles push them back.
shape::Provenance FindProvenance(const FilledSurface& filled,
  const shape::NumberedSurface& numbered, vtkIdType begin, vtkIdType cells)
{
  const Eigen::Index first = numbered.Surface.Triangles.rows();
  const Eigen::Index count = filled.Surface.Triangles.rows() - first;
  shape::Provenance provenance = filled.Provenance;
  provenance.Cells.resize(cells);
  std::iota(provenance.Cells.begin(), provenance.Cells.begin() + begin, 0);
  provenance.Cells.segment(begin, count) =
    shape::ComposeIndices(numbered.Cells, filled.Provenance.Cells.tail(count));
  std::iota(
    provenance.Cells.begin() + begin + count, provenance.Cells.end(), static_cast<int>(begin));
  return provenance;
}

const char* NameOf(shape::FillMethod method)
{
  switch (method)
  {
    case shape::FillMethod::Deformation:
      return "Deformation";
    case shape::FillMethod::Membrane:
      return "Membrane";
    default:
      return "Fair";
  }
}

} // namespace

void vtkShapeFilledData::Write(const FilledSurface& filled, const shape::NumberedSurface& numbered,
  vtkPolyData* input, vtkPolyData* output)
{
  WritePoints(filled, input, output);
  const Eigen::Index first = numbered.Surface.Triangles.rows();
  const vtkIdType begin = WriteCells(filled, first, input, output);
  const shape::Provenance provenance =
    FindProvenance(filled, numbered, begin, output->GetNumberOfCells());
  vtkShapeCarry::Carry({ { input, provenance } }, output);
  vtkShapeFillValues::Continue(filled.Surface, filled.Holes, begin, output);
  Eigen::VectorXi isFilled = Eigen::VectorXi::Zero(output->GetNumberOfCells());
  isFilled.segment(begin, filled.Surface.Triangles.rows() - first).setOnes();
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(isFilled, "Filled"));
}

void vtkShapeFilledData::WriteCloud(const FilledSurface& filled, const Eigen::MatrixXd& normals,
  vtkPolyData* input, vtkPolyData* output)
{
  WritePoints(filled, input, output);
  vtkShapeCloud::WriteCells({}, output);
  const Eigen::Index all = filled.Surface.Points.rows(), added = all - normals.rows();
  shape::Provenance provenance = filled.Provenance;
  provenance.Cells = Eigen::VectorXi::Constant(all, -1);
  provenance.Cells.head(normals.rows()) = vtkShapeCloud::FindVertices(input);
  vtkShapeCarry::Carry({ { input, provenance } }, output);
  // Cells are points now, and points get all normals below.
  while (vtkDataArray* old = vtkShapeCarry::GetNormals(output->GetCellData()))
  {
    output->GetCellData()->RemoveArray(old->GetName());
  }
  vtkShapeFillValues::Continue(filled.Surface, filled.Holes, 0, output);
  Eigen::MatrixXd ofAll(all, 3);
  ofAll << normals,
    shape::ComputeVertexNormals(filled.Surface, shape::NormalWeight::Max).bottomRows(added);
  vtkDataArray* given = vtkShapeCarry::GetNormals(input->GetPointData());
  output->GetPointData()->SetNormals(
    vtkShapeConvert::ToArray(ofAll, given && given->GetName() ? given->GetName() : "Normals"));
  Eigen::VectorXi isFilled = Eigen::VectorXi::Zero(all);
  isFilled.tail(added).setOnes();
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(isFilled, "Filled"));
}

int vtkShapeFilledData::Split(
  const FilledSurface& filled, const shape::NumberedSurface& numbered, vtkPolyData* output)
{
  const shape::SplitSheets split = shape::SplitTouchingSheets(filled.Surface);
  const auto copies = static_cast<int>(split.Copied.size() - filled.Surface.Points.rows());
  if (copies == 0)
  {
    return 0;
  }
  vtkNew<vtkPolyData> touching;
  touching->ShallowCopy(output);
  vtkNew<vtkPoints> points;
  points->SetDataType(touching->GetPoints()->GetDataType());
  points->Allocate(static_cast<vtkIdType>(split.Copied.size()));
  for (const int point : split.Copied)
  {
    points->InsertNextPoint(touching->GetPoint(point));
  }
  output->SetPoints(points);
  if (output->GetNumberOfStrips() > 0)
  {
    vtkNew<vtkCellArray> strips; // these are still the input's
    strips->DeepCopy(output->GetStrips());
    output->SetStrips(strips);
  }
  output->BuildCells();
  const Eigen::Index given = numbered.Surface.Triangles.rows();
  const vtkIdType fills = filled.Surface.Triangles.rows() - given;
  // Strips come after the polygons, so the fills pushed them back.
  const vtkIdType begin = output->GetNumberOfCells() - output->GetNumberOfStrips() - fills;
  for (Eigen::Index t = 0; t < filled.Surface.Triangles.rows(); ++t)
  {
    const vtkIdType source = t < given ? numbered.Cells(t) : -1;
    const vtkIdType cell = t >= given ? begin + t - given
      : source < begin                ? source
                                      : source + fills;
    for (int k = 0; k < 3; ++k)
    {
      if (split.Surface.Triangles(t, k) != filled.Surface.Triangles(t, k))
      {
        output->ReplaceCellPoint(
          cell, filled.Surface.Triangles(t, k), split.Surface.Triangles(t, k));
      }
    }
  }
  output->DeleteCells(); // only needed to replace points
  const auto cells = static_cast<int>(output->GetNumberOfCells());
  vtkShapeCarry::Carry({ { touching,
                         shape::TraceCopies(split.Copied, filled.Surface.Points.rows(),
                           Eigen::VectorXi::LinSpaced(cells, 0, cells - 1)) } },
    output);
  // Each sheet has a normal of its own at a split point.
  if (vtkDataArray* normals = vtkShapeCarry::GetNormals(output->GetPointData()))
  {
    const Eigen::MatrixXd own =
      shape::ComputeVertexNormals(split.Surface, shape::NormalWeight::Angle);
    for (auto i = filled.Surface.Points.rows(); i < own.rows(); ++i)
    {
      for (const Eigen::Index point : { i, static_cast<Eigen::Index>(split.Copied[i]) })
      {
        if (!own.row(point).isZero()) // a sheet without area keeps the carried normal
        {
          normals->SetTuple(point, Eigen::RowVector3d(own.row(point)).data());
        }
      }
    }
  }
  return copies;
}

void vtkShapeFilledData::AddFacts(
  const FilledSurface& filled, const std::vector<int>& loops, vtkPolyData* output)
{
  vtkFieldData* data = output->GetFieldData();
  const std::pair<const char*, std::function<double(const FilledHole&)>> numbers[] = {
    { "Loop", [&](const FilledHole& hole) { return loops[hole.Number]; } },
    { "LoopPoints", [](const FilledHole& hole) { return static_cast<double>(hole.Loop.size()); } },
    { "Nonplanarity", [](const FilledHole& hole) { return hole.Nonplanarity; } },
    { "NormalDeviationBefore", [](const FilledHole& hole) { return hole.DeviationBefore; } },
    { "NormalDeviationAfter", [](const FilledHole& hole) { return hole.DeviationAfter; } },
    { "SelfIntersections", [](const FilledHole& hole) { return hole.SelfIntersections; } },
    { "Points", [](const FilledHole& hole) { return hole.Points; } },
    { "Triangles", [](const FilledHole& hole) { return hole.Triangles; } }
  };
  for (const auto& [name, value] : numbers)
  {
    Eigen::VectorXd values(filled.Holes.size());
    for (std::size_t i = 0; i < filled.Holes.size(); ++i)
    {
      values(static_cast<Eigen::Index>(i)) = value(filled.Holes[i]);
    }
    data->AddArray(vtkShapeConvert::ToArray(values, std::string("FillHoles.") + name));
  }
  vtkNew<vtkStringArray> methods, reasons;
  methods->SetName("FillHoles.Method");
  reasons->SetName("FillHoles.Reason");
  for (const FilledHole& hole : filled.Holes)
  {
    methods->InsertNextValue(NameOf(hole.Method));
    reasons->InsertNextValue(hole.Reason);
  }
  data->AddArray(methods);
  data->AddArray(reasons);
}
