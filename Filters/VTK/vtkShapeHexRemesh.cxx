#include "vtkShapeHexRemesh.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Core/Topology.h"
#include "Geometry/ClosestPoint.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>

vtkStandardNewMacro(vtkShapeHexRemesh);

vtkShapeHexRemesh::vtkShapeHexRemesh()
{
  this->DeclareInput("Surface", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareOutput("vtkPolyData");
}

namespace
{

vtkSmartPointer<vtkCellArray> ToCellArray(const Eigen::MatrixXi& cells)
{
  auto array = vtkSmartPointer<vtkCellArray>::New();
  array->AllocateExact(cells.rows(), cells.size());
  for (Eigen::Index i = 0; i < cells.rows(); ++i)
  {
    array->InsertNextCell(static_cast<int>(cells.cols()));
    for (const int point : cells.row(i))
    {
      array->InsertCellPoint(point);
    }
  }
  return array;
}

vtkSmartPointer<vtkPoints> ToVtkPoints(const Eigen::MatrixXd& points)
{
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetData(vtkShapeConvert::ToArray(points, "Points"));
  return result;
}

void WriteHexahedra(const shape::HexFit& fit, vtkUnstructuredGrid* output)
{
  output->SetPoints(ToVtkPoints(fit.Solid.Points));
  output->SetCells(VTK_HEXAHEDRON, ToCellArray(fit.Solid.Hexahedra));
  output->GetCellData()->AddArray(
    vtkShapeConvert::ToArray(shape::ScaledJacobians(fit.Solid), "ScaledJacobian"));
  output->GetCellData()->AddArray(
    vtkShapeConvert::ToIntegers(Eigen::VectorXi::Zero(fit.Solid.Hexahedra.rows()), "RegionId"));
}

void WriteBoundary(const shape::HexFit& fit, const shape::Mesh& surface, vtkPolyData* output)
{
  std::vector<int> used(fit.Quads.data(), fit.Quads.data() + fit.Quads.size());
  std::sort(used.begin(), used.end());
  used.erase(std::unique(used.begin(), used.end()), used.end());
  Eigen::MatrixXi quads = fit.Quads;
  for (int& point : quads.reshaped())
  {
    point = static_cast<int>(std::lower_bound(used.begin(), used.end(), point) - used.begin());
  }
  Eigen::MatrixXd middles(quads.rows(), 3);
  for (Eigen::Index q = 0; q < quads.rows(); ++q)
  {
    middles.row(q) = fit.Solid.Points(fit.Quads.row(q), Eigen::all).colwise().mean();
  }
  vtkNew<vtkIdTypeArray> ids;
  ids->SetName("OriginalPointId");
  for (const int point : used)
  {
    ids->InsertNextValue(point);
  }
  output->SetPoints(ToVtkPoints(fit.Solid.Points(used, Eigen::all)));
  output->SetPolys(ToCellArray(quads));
  output->GetPointData()->AddArray(ids);
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(fit.PatchOf, "Patch"));
  output->GetCellData()->AddArray(
    vtkShapeConvert::ToArray(shape::SurfaceLocator(surface).Find(middles).Distances, "Distance"));
}

/// How many scaled Jacobians lie in each twentieth of [0, 1].
vtkSmartPointer<vtkIntArray> Histogram(const shape::HexMesh& solid)
{
  constexpr int bins = 20;
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(bins);
  for (const double value : shape::ScaledJacobians(solid))
  {
    ++counts(std::clamp(static_cast<int>(bins * value), 0, bins - 1));
  }
  return vtkShapeConvert::ToIntegers(counts, "HexRemesh.ScaledJacobianHistogram");
}

void AddFacts(const shape::HexRemeshResult& result, vtkDataObject* output)
{
  const shape::HexFit& fit = result.Fit;
  const shape::Topology topology =
    shape::SurfaceTopology({ fit.Solid.Points, shape::SplitQuads(fit.Quads) });
  const std::pair<const char*, double> facts[] = {
    { "Hexahedra", static_cast<double>(fit.Solid.Hexahedra.rows()) },
    { "MinimumScaledJacobian", fit.LeastScaledJacobian },
    { "MeanScaledJacobian", fit.MeanScaledJacobian },
    { "Distance", fit.Distance },
    { "CellSize", result.CellSize },
    { "Patches", result.Features.Patches },
    { "Corners", static_cast<double>(result.Features.Corners.size()) },
    { "CreasesKept", fit.CreasesKept ? 1.0 : 0.0 },
    { "CornersKept", fit.Creases.Corners },
    { "CreaseDistance", fit.Creases.Distance },
    { "CreaseShare", result.Features.CurveShare() },
    { "Crossings", result.Crossings },
    { "EulerNumber", topology.EulerNumber },
    { "Components", topology.Components },
  };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("HexRemesh.") + fact, value);
  }
  const bool polycube = result.Method == shape::HexRemeshOptions::MethodType::Polycube;
  vtkShapeConvert::AddFact(output, "HexRemesh.Method", polycube ? "Polycube" : "Grid");
  vtkShapeConvert::AddFact(output, "HexRemesh.Reason", result.Reason);
  output->GetFieldData()->AddArray(Histogram(fit.Solid));
}

} // namespace

void vtkShapeHexRemesh::Execute(const shape::Progress& progress)
{
  // Every process has all of the input, and one of them does the work.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkPolyData* input = this->GetWhole(0).Data;
  const shape::Mesh surface = vtkShapeConvert::ToMesh(input, "the Surface");
  const shape::HexRemeshResult result =
    shape::HexRemesh(surface, this->Options, progress.Part(0.0, 0.98));
  WriteHexahedra(result.Fit, vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(0)));
  WriteBoundary(result.Fit, surface, vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
  for (const int port : { 0, 1 })
  {
    this->GetOutputDataObject(port)->GetFieldData()->PassData(input->GetFieldData());
    AddFacts(result, this->GetOutputDataObject(port));
  }
  progress(1.0);
}
