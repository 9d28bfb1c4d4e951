#include "vtkShapeTetrahedralize.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Search/ClosestPoint.h"

#include <utility>

vtkStandardNewMacro(vtkShapeTetrahedralize);

vtkShapeTetrahedralize::vtkShapeTetrahedralize()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput(
    "InnerSurfaces", PortData::WholeSurface, PortUse::OptionalRepeatable, { "vtkPolyData" });
  this->DeclareOutput("vtkUnstructuredGrid");
}

void vtkShapeTetrahedralize::AddInnerSurfaces(vtkAlgorithmOutput* surface)
{
  this->AddInputConnection(1, surface);
}

void vtkShapeTetrahedralize::RemoveAllInnerSurfaces()
{
  this->SetInputConnection(1, nullptr);
}

namespace
{

void WriteTetrahedra(const shape::TetrahedralizeResult& solid, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(solid.Points, "Points"));
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(solid.Tetrahedra.rows(), solid.Tetrahedra.size());
  for (Eigen::Index i = 0; i < solid.Tetrahedra.rows(); ++i)
  {
    cells->InsertNextCell({ solid.Tetrahedra(i, 0), solid.Tetrahedra(i, 1), solid.Tetrahedra(i, 2),
      solid.Tetrahedra(i, 3) });
  }
  output->SetPoints(points);
  output->SetCells(VTK_TETRA, cells);
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(solid.RegionId, "RegionId"));
}

/// Passes on the surface's point data, and adds the original point of each point.
void PassPointData(const shape::TetrahedralizeResult& solid, const shape::Surface& mesh,
  vtkPolyData* surface, vtkUnstructuredGrid* output, const shape::Progress& progress)
{
  std::vector<int> others;
  for (int i = 0; i < solid.OriginalPoint.size(); ++i)
  {
    if (solid.OriginalPoint(i) == -1)
    {
      others.push_back(i);
    }
  }
  // New points have no data, so they get the data at the closest position on the surface.
  const shape::ClosestPoints closest = shape::SurfaceLocator(mesh).Find(
    vtkShapeConvert::Rows(solid.Points, others), progress.Part(0.0, 0.9));
  vtkPointData* from = surface->GetPointData();
  vtkPointData* to = output->GetPointData();
  to->InterpolateAllocate(from, solid.Points.rows());
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("OriginalPointId");
  ids->SetNumberOfValues(solid.Points.rows());
  vtkNew<vtkIdList> corners;
  corners->SetNumberOfIds(3);
  Eigen::Index other = 0;
  for (int i = 0; i < solid.OriginalPoint.size(); ++i)
  {
    ids->SetValue(i, solid.OriginalPoint(i));
    if (solid.OriginalPoint(i) >= 0)
    {
      to->CopyData(from, solid.OriginalPoint(i), i);
      continue;
    }
    double weights[3];
    for (int k = 0; k < 3; ++k)
    {
      corners->SetId(k, mesh.Triangles()(closest.Triangles(other), k));
      weights[k] = closest.Barycentrics(other, k);
    }
    to->InterpolatePoint(from, i, corners, weights);
    ++other;
  }
  to->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  to->AddArray(ids);
  progress(1.0);
}

} // namespace

void vtkShapeTetrahedralize::Execute(const shape::Progress& progress)
{
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkPolyData* surface = this->GetGatheredInput(0).Data;
  const shape::Surface mesh = vtkShapeConvert::ToMesh(surface, "the Input");
  std::vector<shape::Surface> innerSurfaces;
  for (int i = 0; i < this->GetNumberOfInputConnections(1); ++i)
  {
    innerSurfaces.push_back(vtkShapeConvert::ToMesh(
      this->GetGatheredInput(1, i).Data, "inner surface " + std::to_string(i)));
  }
  const shape::TetrahedralizeResult solid =
    shape::Tetrahedralize(mesh, innerSurfaces, this->Options, progress.Part(0.0, 0.9));

  auto* output = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
  WriteTetrahedra(solid, output);
  PassPointData(solid, mesh, surface, output, progress.Part(0.9, 1.0));
  output->GetFieldData()->PassData(surface->GetFieldData());
  const std::pair<const char*, double> facts[] = { { "Points",
                                                     static_cast<double>(solid.Points.rows()) },
    { "Tetrahedra", static_cast<double>(solid.Tetrahedra.rows()) },
    { "SteinerPoints", solid.SteinerPoints }, { "Regions", solid.Regions },
    { "MinimumScaledJacobian", solid.MinimumScaledJacobian }, { "Volume", solid.Volume } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("Tetrahedralize.") + fact, value);
  }
}
