#include "vtkShapeCutParts.h"

#include "vtkShapeConvert.h"
#include "vtkShapeFeatureBase.h"
#include "vtkShapeFillValues.h"

#include "vtkAbstractArray.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

#include "Fill/FillHoles.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace
{

using shape::DividedPart;
using shape::FilledHole;

/// Interpolates an array at points of the surface or positions on it. Data that cannot be averaged
/// are copied from the nearest corner.
void InterpolateArray(
  const DividedPart& part, const shape::Mesh& mesh, vtkAbstractArray* from, vtkAbstractArray* to)
{
  vtkNew<vtkIdList> corners;
  corners->SetNumberOfIds(3);
  for (std::size_t i = 0; i < part.OriginalPoints.size(); ++i)
  {
    const auto point = static_cast<vtkIdType>(i);
    const int triangle = part.Positions.Triangles(point);
    if (part.OriginalPoints[i] >= 0)
    {
      to->SetTuple(point, part.OriginalPoints[i], from);
    }
    else if (triangle >= 0)
    {
      double weights[3];
      for (int k = 0; k < 3; ++k)
      {
        corners->SetId(k, mesh.Triangles(triangle, k));
        weights[k] = part.Positions.Barycentrics(point, k);
      }
      if (vtkShapeConvert::AreValues(from))
      {
        to->InterpolateTuple(point, corners, from, weights);
      }
      else
      {
        to->SetTuple(point, corners->GetId(std::max_element(weights, weights + 3) - weights), from);
      }
    }
  }
}

/// Interpolates all arrays and keeps their attribute types.
void InterpolatePoints(
  const DividedPart& part, const shape::Mesh& mesh, vtkPointData* from, vtkPointData* to)
{
  for (int i = 0; i < from->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* array = from->GetAbstractArray(i);
    if (array == from->GetGlobalIds())
    {
      continue; // new points have no ids
    }
    auto own = vtkSmartPointer<vtkAbstractArray>::Take(array->NewInstance());
    own->SetName(array->GetName());
    own->SetNumberOfComponents(array->GetNumberOfComponents());
    own->CopyComponentNames(array);
    own->SetNumberOfTuples(part.Surface.Points.rows());
    InterpolateArray(part, mesh, array, own);
    to->AddArray(own);
  }
  for (int role = 0; role < vtkDataSetAttributes::NUM_ATTRIBUTES; ++role)
  {
    vtkAbstractArray* array = from->GetAbstractAttribute(role);
    if (array && array->GetName() && to->HasArray(array->GetName()))
    {
      to->SetActiveAttribute(array->GetName(), role);
    }
  }
}

void AddOriginals(const DividedPart& part, vtkPointData* data)
{
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("OriginalPointId");
  for (const int point : part.OriginalPoints)
  {
    ids->InsertNextValue(point);
  }
  data->AddArray(ids);
}

/// Writes a part and its fills, if it has any. Points on the cut get interpolated values, and
/// points of a fill get harmonic values. Triangles get the data of the cell that contains them.
/// Triangles of a fill get the data of the nearest cell at the loop.
void WritePart(const DividedPart& part, const std::vector<FilledHole>& holes,
  const shape::NumberedSurface& numbered, vtkPolyData* surface, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh(part.Surface, output);
  vtkPointData* points = output->GetPointData();
  InterpolatePoints(part, numbered.Surface, surface->GetPointData(), points);
  vtkCellData* cellData = output->GetCellData();
  cellData->CopyAllocate(surface->GetCellData(), part.Surface.Triangles.rows());
  std::vector<int> sources = part.OriginalTriangles;
  const std::vector<shape::FillSources> fills = shape::FindFillSources(part.Surface, holes);
  for (std::size_t k = 0; k < holes.size(); ++k)
  {
    const FilledHole& hole = holes[k];
    const shape::FillSources& fill = fills[k];
    for (int a = 0; a < points->GetNumberOfArrays(); ++a)
    {
      vtkAbstractArray* array = points->GetAbstractArray(a);
      for (int i = 0; i < hole.Points; ++i)
      {
        // Data that cannot be averaged, such as labels and strings, are copied. Values are replaced
        // below.
        array->InsertTuple(hole.FirstPoint + i, fill.Points[i], array);
      }
    }
    for (int t = 0; t < hole.Triangles; ++t)
    {
      sources[hole.FirstTriangle + t] = part.OriginalTriangles[fill.Triangles[t]];
    }
  }
  // Numbers are continued harmonically into the fill.
  vtkShapeFillValues::Continue(part.Surface, holes, points);
  for (std::size_t t = 0; t < sources.size(); ++t)
  {
    cellData->CopyData(
      surface->GetCellData(), numbered.Cells(sources[t]), static_cast<vtkIdType>(t));
  }
  for (vtkDataSetAttributes* data :
    { static_cast<vtkDataSetAttributes*>(points), static_cast<vtkDataSetAttributes*>(cellData) })
  {
    data->RemoveArray(vtkDataSetAttributes::GhostArrayName());
    if (!holes.empty())
    {
      // The fill has no normals, and the normals at the loop have changed.
      data->RemoveArray("Normals");
    }
  }
  AddOriginals(part, points);
  output->GetFieldData()->PassData(surface->GetFieldData());
}

} // namespace

void vtkShapeCutParts::Write(const shape::CutFeatureResult& cut,
  const shape::NumberedSurface& numbered, vtkPolyData* surface, vtkPolyData* feature,
  vtkPolyData* rest)
{
  WritePart(cut.Feature, {}, numbered, surface, feature);
  vtkShapeFeatureBase::Write(cut, feature);
  WritePart(cut.Rest, cut.Holes, numbered, surface, rest);
  Eigen::VectorXi filled(cut.Rest.Surface.Triangles.rows());
  std::transform(cut.Rest.OriginalTriangles.begin(), cut.Rest.OriginalTriangles.end(),
    filled.begin(), [](int triangle) { return triangle < 0 ? 1 : 0; });
  rest->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(filled, "Filled"));
}

void vtkShapeCutParts::AddFacts(const shape::CutFeatureResult& cut, vtkPolyData* output)
{
  const double area = 0.5 * shape::ComputeAreaVectors(cut.Feature.Surface).rowwise().norm().sum();
  const std::pair<const char*, double> facts[] = { { "Loops", cut.Loops },
    { "LoopsLeftOut", cut.LoopsLeftOut }, { "CutLength", cut.CutLength }, { "FeatureArea", area },
    { "Holes", static_cast<double>(cut.Holes.size()) }, { "WeldedPoints", cut.WeldedPoints } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("CutFeature.") + fact, value);
  }
}
