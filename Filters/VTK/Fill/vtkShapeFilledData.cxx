#include "vtkShapeFilledData.h"

#include "vtkShapeConvert.h"
#include "vtkShapeFillValues.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
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

#include <Eigen/Geometry>

#include <functional>
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

void WriteNormals(
  const Eigen::MatrixXd& normals, Eigen::Index first, vtkIdType at, vtkDataArray* array)
{
  for (Eigen::Index i = first; i < normals.rows(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      array->SetComponent(at + i - first, k, normals(i, k));
    }
  }
}

vtkDataArray* NormalsOf(vtkDataSetAttributes* data)
{
  vtkDataArray* normals = data->GetNormals() ? data->GetNormals() : data->GetArray("Normals");
  const bool areDirections = normals && normals->GetNumberOfComponents() == 3 &&
    (normals->GetDataType() == VTK_FLOAT || normals->GetDataType() == VTK_DOUBLE);
  return areDirections ? normals : nullptr;
}

void WritePointData(const FilledSurface& filled, const std::vector<shape::FillSources>& sources,
  vtkPolyData* input, vtkPolyData* output)
{
  const vtkIdType old = input->GetNumberOfPoints();
  vtkPointData* data = output->GetPointData();
  data->CopyAllOn();
  data->CopyGlobalIdsOff(); // fills have no global ids
  data->CopyAllocate(input->GetPointData(), filled.Surface.Points.rows());
  data->CopyData(input->GetPointData(), 0, old, 0);
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    for (int p = 0; p < filled.Holes[i].Points; ++p)
    {
      data->CopyData(input->GetPointData(), sources[i].Points[p], filled.Holes[i].FirstPoint + p);
    }
  }
  data->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  vtkDataArray* normals = NormalsOf(data);
  vtkShapeFillValues::Continue(filled.Surface, filled.Holes, data, normals);
  if (normals)
  {
    WriteNormals(
      shape::ComputeVertexNormals(filled.Surface, shape::NormalWeight::Max), old, old, normals);
  }
}

void WriteCellData(const FilledSurface& filled, const std::vector<shape::FillSources>& sources,
  const shape::NumberedSurface& numbered, vtkIdType begin, vtkPolyData* input, vtkPolyData* output)
{
  const Eigen::Index first = numbered.Surface.Triangles.rows();
  const vtkIdType count = filled.Surface.Triangles.rows() - first;
  vtkCellData* data = output->GetCellData();
  data->CopyAllOn();
  data->CopyGlobalIdsOff();
  data->CopyAllocate(input->GetCellData(), output->GetNumberOfCells());
  data->CopyData(input->GetCellData(), 0, begin, 0);
  // Strips come after the polygons, so their indices increase by the number of new triangles.
  data->CopyData(input->GetCellData(), begin + count, input->GetNumberOfCells() - begin, begin);
  for (std::size_t i = 0; i < sources.size(); ++i)
  {
    for (int t = 0; t < filled.Holes[i].Triangles; ++t)
    {
      const int source = sources[i].Triangles[t];
      const vtkIdType cell = begin + filled.Holes[i].FirstTriangle - first + t;
      if (source >= 0 && source < first)
      {
        data->CopyData(input->GetCellData(), numbered.Cells(source), cell);
      }
      else
      {
        // A fill between curves has no cell at its loop from which data could be copied.
        data->NullData(cell);
      }
    }
  }
  data->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  if (vtkDataArray* normals = NormalsOf(data))
  {
    WriteNormals(
      shape::ComputeAreaVectors(filled.Surface).rowwise().normalized(), first, begin, normals);
  }
  Eigen::VectorXi isFilled = Eigen::VectorXi::Zero(output->GetNumberOfCells());
  isFilled.segment(begin, count).setOnes();
  data->AddArray(vtkShapeConvert::ToIntegers(isFilled, "Filled"));
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
  const vtkIdType begin = WriteCells(filled, numbered.Surface.Triangles.rows(), input, output);
  const std::vector<shape::FillSources> sources =
    shape::FindFillSources(filled.Surface, filled.Holes);
  WritePointData(filled, sources, input, output);
  WriteCellData(filled, sources, numbered, begin, input, output);
  output->GetFieldData()->PassData(input->GetFieldData());
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
