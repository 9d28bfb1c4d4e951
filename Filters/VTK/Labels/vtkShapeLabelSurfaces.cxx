#include "vtkShapeLabelSurfaces.h"

#include "vtkShapeConvert.h"
#include "vtkShapeLabelImage.h"
#include "vtkShapeList.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <map>
#include <utility>

vtkStandardNewMacro(vtkShapeLabelSurfaces);

vtkShapeLabelSurfaces::vtkShapeLabelSurfaces()
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkImageData" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareShown(0, { "Patch" });
}

void vtkShapeLabelSurfaces::SetNumberOfLabels(int count)
{
  vtkShapeList::Resize(this, this->Options.Labels, count);
}

void vtkShapeLabelSurfaces::SetLabels(int index, int label)
{
  vtkShapeList::Set(this, "Labels", this->Options.Labels, index, { label });
}

void vtkShapeLabelSurfaces::SetNumberOfThresholds(int count)
{
  vtkShapeList::Resize(this, this->Thresholds, count);
}

void vtkShapeLabelSurfaces::SetThresholds(int index, double threshold)
{
  vtkShapeList::Set(this, "Thresholds", this->Thresholds, index, { threshold });
}

namespace
{

void WriteSurface(const shape::LabelSurfacesResult& result, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh({ result.Points, result.Triangles }, output);
  vtkNew<vtkIntArray> regions, patches;
  regions->SetName("Regions");
  regions->SetNumberOfComponents(2);
  regions->SetNumberOfTuples(result.Regions.rows());
  patches->SetName("Patch");
  patches->SetNumberOfTuples(result.Regions.rows());
  std::map<std::pair<int, int>, int> numbers;
  for (Eigen::Index t = 0; t < result.Regions.rows(); ++t)
  {
    numbers[{ result.Regions(t, 0), result.Regions(t, 1) }];
  }
  int next = 0;
  for (auto& [pair, number] : numbers)
  {
    number = next++;
  }
  for (Eigen::Index t = 0; t < result.Regions.rows(); ++t)
  {
    const int first = result.Regions(t, 0), second = result.Regions(t, 1);
    regions->SetTypedComponent(t, 0, first);
    regions->SetTypedComponent(t, 1, second);
    patches->SetValue(t, numbers.at({ first, second }));
  }
  output->GetCellData()->AddArray(regions);
  output->GetCellData()->AddArray(patches);
}

void WriteCurves(const shape::LabelSurfacesResult& result, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkIdTypeArray> originals;
  originals->SetName("SurfacePointId");
  std::map<int, vtkIdType> known;
  const auto add = [&](int point)
  {
    const auto [found, isNew] = known.emplace(point, points->GetNumberOfPoints());
    if (isNew)
    {
      points->InsertNextPoint(
        result.Points(point, 0), result.Points(point, 1), result.Points(point, 2));
      originals->InsertNextValue(point);
    }
    return found->second;
  };
  vtkNew<vtkCellArray> lines, vertices;
  for (const int corner : result.Corners)
  {
    vertices->InsertNextCell({ add(corner) });
  }
  for (const std::vector<int>& curve : result.Curves)
  {
    lines->InsertNextCell(static_cast<int>(curve.size()));
    for (const int point : curve)
    {
      lines->InsertCellPoint(add(point));
    }
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->SetLines(lines);
  output->GetPointData()->AddArray(originals);
}

void AddNumbers(vtkPolyData* output, const std::string& name,
  const std::vector<shape::LabelRegion>& regions, double (*number)(const shape::LabelRegion&))
{
  vtkNew<vtkDoubleArray> numbers;
  numbers->SetName(("LabelSurfaces." + name).c_str());
  for (const shape::LabelRegion& region : regions)
  {
    numbers->InsertNextValue(number(region));
  }
  output->GetFieldData()->AddArray(numbers);
}

} // namespace

void vtkShapeLabelSurfaces::Execute(const shape::Progress& progress)
{
  const shape::LabelImage image = vtkShapeLabelImage::Read(
    this->GetInputDataObject(0, 0), this->LabelArray, this->Thresholds, this->GetController());
  // Every process has the complete image, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  const shape::LabelSurfacesResult result =
    shape::ExtractLabelSurfaces(image, this->Options, progress);
  auto* surface = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  WriteSurface(result, surface);
  WriteCurves(result, vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
  if (result.Intersections > 0)
  {
    this->Warn(std::to_string(result.Intersections) +
      " pairs of triangles intersect; raise Smallest Island, or lower Smoothing");
  }
  const std::pair<const char*, double> facts[] = { { "Points",
                                                     static_cast<double>(result.Points.rows()) },
    { "Triangles", static_cast<double>(result.Triangles.rows()) },
    { "Regions", static_cast<double>(result.RegionsByLabel.size()) },
    { "Curves", static_cast<double>(result.Curves.size()) },
    { "Corners", static_cast<double>(result.Corners.size()) }, { "Islands", result.Islands },
    { "IslandVoxels", result.IslandVoxels }, { "SplitPoints", result.SplitPoints },
    { "Intersections", result.Intersections } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(surface, std::string("LabelSurfaces.") + fact, value);
  }
  const auto& regions = result.RegionsByLabel;
  AddNumbers(surface, "Labels", regions, [](const auto& region) { return 1.0 * region.Label; });
  AddNumbers(
    surface, "Components", regions, [](const auto& region) { return 1.0 * region.Components; });
  AddNumbers(
    surface, "EulerNumbers", regions, [](const auto& region) { return 1.0 * region.EulerNumber; });
  AddNumbers(surface, "Volumes", regions, [](const auto& region) { return region.SurfaceVolume; });
  AddNumbers(
    surface, "VoxelVolumes", regions, [](const auto& region) { return region.ImageVolume; });
}
