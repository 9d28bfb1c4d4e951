#include "vtkShapeTetrahedralize.h"

#include "vtkShapeCarry.h"
#include "vtkShapeConvert.h"
#include "vtkShapeLargeSize.h"
#include "vtkShapeRegions.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"

#include <utility>

vtkStandardNewMacro(vtkShapeTetrahedralize);

vtkShapeTetrahedralize::vtkShapeTetrahedralize()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput(
    "InnerSurfaces", PortData::WholeSurface, PortUse::OptionalRepeatable, { "vtkPolyData" });
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareFacts();
  this->DeclareShown(0, { "RegionId" });
  this->DeclareMemoryRemedy("raise Maximum Volume");
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
  const Eigen::MatrixXi labels =
    vtkShapeRegions::Read(surface, mesh.Triangles().rows(), "the Input");
  if (labels.size() > 0 && !innerSurfaces.empty())
  {
    throw shape::InvalidInput("the array Regions divides the Input already; remove the inner "
                              "surfaces, or the array");
  }
  const shape::TetrahedralizeResult solid = labels.size() > 0
    ? shape::TetrahedralizeRegions(mesh, labels, this->Options, progress.Part(0.0, 0.9))
    : shape::Tetrahedralize(mesh, innerSurfaces, this->Options, progress.Part(0.0, 0.9));

  const std::string warning =
    vtkShapeLargeSize::CheckCellVolume("Maximum Volume", this->Options.MaximumVolume, solid.Volume);
  if (!warning.empty())
  {
    this->Warn(warning);
  }
  if (solid.Flat > 0)
  {
    this->Warn(std::to_string(solid.Flat) +
      " tetrahedra are flat: their scaled Jacobian is below 1e-10; try another Maximum Volume, or "
      "switch Preserve Boundary on or off");
  }
  auto* output = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
  WriteTetrahedra(solid, output);
  const shape::Provenance provenance =
    shape::TraceClosestPositions(mesh, solid, progress.Part(0.9, 1.0, "transferring the arrays"));
  vtkShapeCarry::Carry({ { surface, provenance } }, output);
  vtkShapeCarry::AddOriginals(solid.Provenance.Points, "OriginalPointId", output->GetPointData());
  vtkShapeCarry::RenumberOriginals(this->GetGatheredInput(0).GivenPoints, output->GetPointData());
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
