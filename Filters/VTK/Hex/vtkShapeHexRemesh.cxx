#include "vtkShapeHexRemesh.h"

#include "vtkShapeConvert.h"
#include "vtkShapeHexResult.h"
#include "vtkShapeLabelImage.h"
#include "vtkShapeLargeSize.h"
#include "vtkShapeMeasures.h"
#include "vtkShapeRegions.h"
#include "vtkShapeSurfaces.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Hex/RegionRemesh.h"
#include "Mesh/Extent.h"
#include "Mesh/Mesh.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

vtkStandardNewMacro(vtkShapeHexRemesh);

vtkShapeHexRemesh::vtkShapeHexRemesh()
{
  this->DeclareInput("Surface", PortData::WholeSurface, PortUse::Optional, { "vtkPolyData" });
  this->DeclareInput("Polycube", PortData::WholeSurface, PortUse::Optional,
    { "vtkPolyData", "vtkUnstructuredGrid" });
  this->DeclareInput(
    "InnerSurfaces", PortData::WholeSurface, PortUse::OptionalRepeatable, { "vtkPolyData" });
  this->DeclareInput("Labels", PortData::Pieces, PortUse::Optional, { "vtkImageData" });
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareFacts();
  this->DeclareShown(0, { "ScaledJacobian" });
  this->DeclareShown(1, { "Patch" });
  this->DeclareShown(2, { "Block" });
  this->DeclareMemoryRemedy("raise Cell Size");
  // These are new: they belong to the hexahedra, not to the input.
  std::set<std::string> measures = { "Distance" };
  measures.insert(
    vtkShapeMeasures::NamesOfHexahedra().begin(), vtkShapeMeasures::NamesOfHexahedra().end());
  this->DeclareMeasures(measures);
}

void vtkShapeHexRemesh::AddInnerSurfaces(vtkAlgorithmOutput* surface)
{
  this->AddInputConnection(2, surface);
}

void vtkShapeHexRemesh::RemoveAllInnerSurfaces()
{
  this->SetInputConnection(2, nullptr);
}

namespace
{

/// Returns how many values are in `all` only.
int CountMissing(const Eigen::VectorXi& all, const Eigen::VectorXi& some)
{
  std::set<int> missing(all.begin(), all.end());
  for (const int value : some)
  {
    missing.erase(value);
  }
  return static_cast<int>(missing.size());
}

///@{
/// Points that no triangle uses must not change the size of the solid.
std::vector<int> FindUsed(const shape::Mesh& surface)
{
  return shape::FindUsedPoints(surface.Triangles, surface.Points.rows());
}

shape::Mesh WithPoints(const shape::Mesh& surface, const std::vector<int>& used)
{
  return { surface.Points(used, Eigen::all),
    shape::RenumberPoints(surface.Triangles, used, surface.Points.rows()) };
}
///@}

/// Returns whether each polygon lies in a plane perpendicular to an axis.
bool HasFlatPolygons(vtkPolyData* data)
{
  const double tolerance = 1e-6 * data->GetLength(); // as for the faces of a GivenPolycube
  double bounds[6];
  for (vtkIdType cell = 0; cell < data->GetNumberOfCells(); ++cell)
  {
    data->GetCellBounds(cell, bounds);
    if (std::min({ bounds[1] - bounds[0], bounds[3] - bounds[2], bounds[5] - bounds[4] }) >
      tolerance)
    {
      return false;
    }
  }
  return true;
}

/// Polygons that are bent around edges of the polycube are triangulated by their positions on the
/// surface, as by Shape Polycube.
shape::GivenPolycube ToPolycube(vtkPolyData* data)
{
  const char* array = "SourcePosition";
  if (!data->GetPointData()->HasArray(array) && data->GetPointData()->HasArray("TargetPosition"))
  {
    array = "TargetPosition"; // of Shape Correspondence
  }
  const Eigen::MatrixXd sources = vtkShapeConvert::ToPointArray(data, array, 3, "the Polycube");
  shape::RequireFinite(sources, std::string("the Polycube's ") + array);
  vtkNew<vtkPolyData> unfolded;
  unfolded->ShallowCopy(data);
  if (!HasFlatPolygons(data))
  {
    vtkNew<vtkPoints> positions;
    positions->SetData(vtkShapeConvert::ToArray(sources, "Points"));
    unfolded->SetPoints(positions);
  }
  shape::Mesh surface = vtkShapeConvert::ToMesh(unfolded, "the Polycube");
  surface.Points = vtkShapeConvert::ToPoints(data);
  const std::vector<int> used = FindUsed(surface);
  return { WithPoints(surface, used), sources(used, Eigen::all) };
}

} // namespace

double* vtkShapeHexRemesh::GetSurfaceSize()
{
  std::fill_n(this->SurfaceSize, 3, 0.0);
  auto* data = this->GetNumberOfInputConnections(0) > 0
    ? vtkDataSet::SafeDownCast(this->GetInputDataObject(0, 0))
    : nullptr;
  if (data && data->GetNumberOfCells() > 0)
  {
    try
    {
      const auto surface = vtkShapeSurfaces::ToSurface(data, this->GetInputName(0));
      if (!surface || surface->GetNumberOfPolys() == 0)
      {
        return this->SurfaceSize;
      }
      const shape::Mesh mesh = vtkShapeConvert::ToMesh(surface, "the Surface");
      this->SurfaceSize[0] = std::abs(shape::ComputeEnclosedVolume(mesh));
      this->SurfaceSize[1] = shape::ComputeArea(mesh);
      this->SurfaceSize[2] = shape::ComputeLongestBoxEdge(mesh);
    }
    catch (const shape::InvalidInput&)
    {
      // Apply says what is wrong.
    }
  }
  return this->SurfaceSize;
}

shape::HexRemeshGuides vtkShapeHexRemesh::ReadGuides(const std::vector<int>& used)
{
  shape::HexRemeshGuides guides;
  if (vtkShapeConvert::IsChosen(this->SizeArray))
  {
    guides.Sizes = vtkShapeConvert::ToPointArray(
      this->GetGatheredInput(0).Data, this->SizeArray, 1, "the Surface")(used, 0);
  }
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    guides.Polycube = ToPolycube(this->GetGatheredInput(1).Data);
  }
  for (int i = 0; i < this->GetNumberOfInputConnections(2); ++i)
  {
    const shape::Mesh inner = vtkShapeConvert::ToMesh(
      this->GetGatheredInput(2, i).Data, "inner surface " + std::to_string(i));
    guides.InnerSurfaces.emplace_back(WithPoints(inner, FindUsed(inner)));
  }
  return guides;
}

/// Returns the patch of each triangle; nothing if no array is chosen.
Eigen::VectorXi vtkShapeHexRemesh::ReadPatches(
  vtkPolyData* surface, const std::vector<int>& cellOf) const
{
  if (!vtkShapeConvert::IsChosen(this->PatchArray))
  {
    return {};
  }
  const Eigen::VectorXi patches = vtkShapeConvert::ToCellIntegers(
    surface, this->PatchArray, "the Surface", "choose another Patch Array, or None");
  // The order of vtkPolyData's cell ids: vertices, lines, polygons, strips.
  const auto before = static_cast<int>(surface->GetNumberOfVerts() + surface->GetNumberOfLines());
  const Eigen::Map<const Eigen::ArrayXi> polygons(
    cellOf.data(), static_cast<Eigen::Index>(cellOf.size()));
  return patches(polygons + before);
}

/// Throws if other inputs or a Size Array divide or shape what regions that touch give already.
void vtkShapeHexRemesh::RequireRegionsAlone(const std::string& regions)
{
  if (this->GetNumberOfInputConnections(1) > 0 || this->GetNumberOfInputConnections(2) > 0 ||
    vtkShapeConvert::IsChosen(this->SizeArray) || vtkShapeConvert::IsChosen(this->PatchArray))
  {
    throw shape::InvalidInput(regions +
      " divides the solid already, and its hexahedra are cells of a regular grid; disconnect "
      "Polycube and Inner Surfaces, and set Size Array and Patch Array to None");
  }
}

void vtkShapeHexRemesh::CheckCellSize(vtkPolyData* surface)
{
  const std::string warning =
    vtkShapeLargeSize::CheckCellSize("Cell Size", this->Options.CellSize, surface);
  if (!warning.empty())
  {
    this->Warn(warning);
  }
}

void vtkShapeHexRemesh::WriteResult(const shape::HexRemeshResult& result,
  const shape::Surface& surface, const std::vector<shape::Surface>& innerSurfaces,
  vtkDataObject* input)
{
  auto* hexahedra = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
  vtkShapeHexResult::WriteHexahedra(result.Fit, result.Grid, hexahedra);
  vtkShapeHexResult::WriteBoundary(
    result, surface, innerSurfaces, vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
  vtkShapeHexResult::WriteGrid(
    result.Fit, result.Grid, vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(2)));
  for (const int port : { 0, 1, 2 })
  {
    this->GetOutputDataObject(port)->GetFieldData()->PassData(input->GetFieldData());
    vtkShapeHexResult::AddFacts(result, hexahedra, this->GetOutputDataObject(port));
  }
}

void vtkShapeHexRemesh::FillRegions(
  const shape::LabelledSurfaces& regions, vtkDataObject* input, const shape::Progress& progress)
{
  const shape::HexRemeshResult result = shape::RemeshRegions(regions, this->Options, progress);
  this->WriteResult(result, regions.Surfaces, {}, input);
}

void vtkShapeHexRemesh::FillLabels(const shape::Progress& progress)
{
  if (this->GetNumberOfInputConnections(0) > 0)
  {
    throw shape::InvalidInput("Surface and Labels are both connected; disconnect one of them");
  }
  this->RequireRegionsAlone("Labels");
  vtkDataObject* input = this->GetInputDataObject(3, 0);
  const shape::LabelImage image =
    vtkShapeLabelImage::Read(input, this->LabelArray, {}, this->GetController(), "Labels");
  // Every process has the complete image, and one of them computes the result.
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    this->FillRegions(
      shape::SeparateLabels(image, progress.Part(0.0, 0.2)), input, progress.Part(0.2, 1.0));
  }
}

void vtkShapeHexRemesh::Execute(const shape::Progress& progress)
{
  if (this->GetNumberOfInputConnections(3) > 0)
  {
    this->FillLabels(progress);
    return;
  }
  if (this->GetNumberOfInputConnections(0) == 0)
  {
    throw shape::InvalidInput("Surface is not connected; choose it, or Labels, under Inputs");
  }
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkPolyData* input = this->GetGatheredInput(0).Data;
  std::vector<int> cellOf;
  const shape::Mesh given = vtkShapeConvert::ToMesh(input, "the Surface", &cellOf);
  const Eigen::MatrixXi labels =
    vtkShapeRegions::Read(input, given.Triangles.rows(), "the Surface");
  const std::vector<int> used = FindUsed(given);
  const shape::Mesh surface = WithPoints(given, used);
  this->CheckCellSize(input);
  if (labels.size() > 0)
  {
    this->RequireRegionsAlone("the array Regions of the Surface");
    this->FillRegions({ surface, labels }, input, progress);
    return;
  }
  const shape::HexRemeshGuides guides = this->ReadGuides(used);
  shape::HexRemeshOptions options = this->Options;
  options.Patches = this->ReadPatches(input, cellOf);
  const shape::HexRemeshResult result =
    shape::RemeshHexahedra(surface, options, progress.Part(0.0, 0.98), guides);
  this->WriteResult(result, surface, guides.InnerSurfaces, input);
  if (options.Patches.size() > 0)
  {
    for (const int port : { 0, 1, 2 })
    {
      vtkShapeConvert::AddFact(this->GetOutputDataObject(port), "HexRemesh.PatchesLost",
        CountMissing(options.Patches, result.Fit.PatchOf));
    }
  }
  progress(1.0);
}
