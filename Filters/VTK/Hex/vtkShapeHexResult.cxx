#include "vtkShapeHexResult.h"

#include "vtkShapeCarry.h"
#include "vtkShapeConvert.h"
#include "vtkShapeMeasures.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Hex/FacePatches.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <string>
#include <utility>

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

Eigen::VectorXi ToVector(const std::vector<int>& values)
{
  return Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size()));
}

/// Computes the distances of the quads' centres from a surface.
Eigen::VectorXd Distances(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads, const shape::Surface& surface)
{
  return shape::SurfaceLocator(surface).Find(shape::ComputeQuadCentres(points, quads)).Distances;
}

/// Verdict's measures except for the scaled Jacobian, which the kernel computes.
std::vector<std::string> Measures()
{
  std::vector<std::string> names = vtkShapeMeasures::NamesOfHexahedra();
  names.erase(std::find(names.begin(), names.end(), "ScaledJacobian"));
  return names;
}

/// Counts the scaled Jacobians in each twentieth of [0, 1].
vtkSmartPointer<vtkIntArray> Histogram(const shape::HexMesh& solid)
{
  constexpr int bins = 20;
  Eigen::VectorXi counts = Eigen::VectorXi::Zero(bins);
  for (const double value : shape::ComputeScaledJacobians(solid))
  {
    ++counts(std::clamp(static_cast<int>(bins * value), 0, bins - 1));
  }
  return vtkShapeConvert::ToIntegers(counts, "HexRemesh.ScaledJacobianHistogram");
}

/// Computes the minimum, mean and maximum of an array's values.
vtkSmartPointer<vtkDoubleArray> Summary(vtkDataArray* values, const std::string& name)
{
  Eigen::RowVector3d sums = Eigen::RowVector3d::Zero();
  const vtkIdType count = values->GetNumberOfTuples();
  for (vtkIdType i = 0; i < count; ++i)
  {
    const double value = values->GetComponent(i, 0);
    sums(0) = i == 0 ? value : std::min(sums(0), value);
    sums(1) += value / static_cast<double>(count);
    sums(2) = i == 0 ? value : std::max(sums(2), value);
  }
  vtkSmartPointer<vtkDoubleArray> summary = vtkShapeConvert::ToArray(sums, name);
  summary->SetComponentName(0, "Minimum");
  summary->SetComponentName(1, "Mean");
  summary->SetComponentName(2, "Maximum");
  return summary;
}

/// Returns an array whose tuples are the rows of `values`.
vtkSmartPointer<vtkIntArray> ToTuples(const Eigen::MatrixXi& values, const char* name)
{
  vtkNew<vtkIntArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(values.cols()));
  array->SetNumberOfTuples(values.rows());
  for (Eigen::Index row = 0; row < values.rows(); ++row)
  {
    for (Eigen::Index column = 0; column < values.cols(); ++column)
    {
      array->SetTypedComponent(row, static_cast<int>(column), values(row, column));
    }
  }
  return array;
}

/// Computes the share of quads that are at most 1.2 times as large as wanted, and the median ratio.
void AddSizeFacts(const Eigen::VectorXd& ratios, vtkDataObject* output)
{
  std::vector<double> sorted(ratios.begin(), ratios.end());
  const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
  std::nth_element(sorted.begin(), middle, sorted.end());
  vtkShapeConvert::AddFact(output, "HexRemesh.MedianSizeRatio", *middle);
  constexpr double large = 1.2;
  vtkShapeConvert::AddFact(output, "HexRemesh.ShareOfSizesMet",
    static_cast<double>((ratios.array() <= large).count()) / static_cast<double>(ratios.size()));
}

} // namespace

void vtkShapeHexResult::WriteHexahedra(
  const shape::HexFit& fit, const shape::HexGrid& grid, vtkUnstructuredGrid* output)
{
  output->SetPoints(ToVtkPoints(fit.Solid.Points));
  output->SetCells(VTK_HEXAHEDRON, ToCellArray(fit.Solid.Hexahedra));
  output->GetCellData()->AddArray(
    vtkShapeConvert::ToArray(shape::ComputeScaledJacobians(fit.Solid), "ScaledJacobian"));
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(fit.RegionOf, "RegionId"));
  output->GetCellData()->AddArray(
    ToTuples(shape::FindFacePatches(fit.Solid, fit.Quads, fit.PatchOf), "FacePatch"));
  vtkShapeMeasures::AddToHexahedra(Measures(), output);
  output->GetPointData()->AddArray(
    vtkShapeConvert::ToArray(grid.SourcePositions, "SourcePosition"));
}

void vtkShapeHexResult::WriteGrid(
  const shape::HexFit& fit, const shape::HexGrid& grid, vtkUnstructuredGrid* output)
{
  const std::vector<int> used = shape::FindUsedPoints(grid.Cells, fit.Solid.Points.rows());
  output->SetPoints(ToVtkPoints(grid.SourcePositions(used, Eigen::all)));
  output->SetCells(
    VTK_HEXAHEDRON, ToCellArray(shape::RenumberPoints(grid.Cells, used, fit.Solid.Points.rows())));
  output->GetPointData()->AddArray(
    vtkShapeConvert::ToArray(fit.Solid.Points(used, Eigen::all), "TargetPosition"));
  vtkShapeCarry::AddOriginals(ToVector(used), "OriginalPointId", output->GetPointData());
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(grid.BlockOf, "Block"));
  output->GetCellData()->AddArray(ToTuples(grid.Indices, "BlockIndex"));
}

/// Joins the quads of the boundary and then the quads of each interface, and renumbers their
/// points.
void vtkShapeHexResult::WriteBoundary(const shape::HexRemeshResult& result,
  const shape::Surface& surface, const std::vector<shape::Surface>& innerSurfaces,
  vtkPolyData* output)
{
  const shape::HexFit& fit = result.Fit;
  Eigen::Index count = fit.Quads.rows();
  for (const Eigen::MatrixXi& interface : fit.Interfaces)
  {
    count += interface.rows();
  }
  Eigen::MatrixXi quads(count, 4);
  Eigen::VectorXi interfaceOf = Eigen::VectorXi::Zero(count), patchOf(count);
  Eigen::VectorXd distances(count);
  Eigen::Index row = fit.Quads.rows();
  quads.topRows(row) = fit.Quads;
  patchOf.head(row) = fit.PatchOf;
  distances.head(row) = Distances(fit.Solid.Points, fit.Quads, surface);
  for (std::size_t i = 0; i < fit.Interfaces.size(); ++i)
  {
    const Eigen::MatrixXi& own = fit.Interfaces[i];
    quads.middleRows(row, own.rows()) = own;
    interfaceOf.segment(row, own.rows()).setConstant(static_cast<int>(i) + 1);
    patchOf.segment(row, own.rows()).setConstant(fit.PatchOf.maxCoeff() + 1 + static_cast<int>(i));
    distances.segment(row, own.rows()) =
      Distances(fit.Solid.Points, own, innerSurfaces.empty() ? surface : innerSurfaces[i]);
    row += own.rows();
  }
  const std::vector<int> used = shape::FindUsedPoints(quads, fit.Solid.Points.rows());
  output->SetPoints(ToVtkPoints(fit.Solid.Points(used, Eigen::all)));
  output->SetPolys(ToCellArray(shape::RenumberPoints(quads, used, fit.Solid.Points.rows())));
  vtkShapeCarry::AddOriginals(ToVector(used), "OriginalPointId", output->GetPointData());
  vtkCellData* data = output->GetCellData();
  data->AddArray(vtkShapeConvert::ToIntegers(patchOf, "Patch"));
  data->AddArray(vtkShapeConvert::ToIntegers(interfaceOf, "Interface"));
  data->AddArray(vtkShapeConvert::ToArray(distances, "Distance"));
  if (fit.QuadRegions.size() > 0)
  {
    data->AddArray(ToTuples(fit.QuadRegions, "Regions"));
  }
}

namespace
{

/// Adds the facts of regions that touch: a value for each of them, and their curves.
void AddRegionFacts(const shape::HexRemeshResult& result, vtkDataObject* output)
{
  const auto add = [&](const char* name, double (*number)(const shape::HexRegion&))
  {
    vtkNew<vtkDoubleArray> numbers;
    numbers->SetName((std::string("HexRemesh.Region") + name).c_str());
    for (const shape::HexRegion& region : result.Regions)
    {
      numbers->InsertNextValue(number(region));
    }
    output->GetFieldData()->AddArray(numbers);
  };
  add("Labels", [](const shape::HexRegion& region) { return double(region.Label); });
  add("Hexahedra", [](const shape::HexRegion& region) { return double(region.Hexahedra); });
  add("Volumes", [](const shape::HexRegion& region) { return region.Volume; });
  add("EulerNumbers", [](const shape::HexRegion& region) { return double(region.EulerNumber); });
  add("Components", [](const shape::HexRegion& region) { return double(region.Components); });
  vtkShapeConvert::AddFact(output, "HexRemesh.Curves", result.Curves);
  vtkShapeConvert::AddFact(output, "HexRemesh.CurvesKept", result.CurvesKept);
  vtkShapeConvert::AddFact(output, "HexRemesh.CurveDistance", result.CurveDistance);
  vtkShapeConvert::AddFact(output, "HexRemesh.Junctions", result.Junctions);
  vtkShapeConvert::AddFact(output, "HexRemesh.JunctionsKept", result.JunctionsKept);
}

/// Adds where the lost creases are, and how long they are.
void AddLostCreases(const std::vector<shape::CreaseLine>& lost, vtkDataObject* output)
{
  Eigen::MatrixXd midpoints(lost.size(), 3), lengths(lost.size(), 1);
  for (Eigen::Index i = 0; i < midpoints.rows(); ++i)
  {
    midpoints.row(i) = shape::FindMidpoint(lost[i]);
    lengths(i) = shape::ComputeLength({ lost[i] });
  }
  output->GetFieldData()->AddArray(
    vtkShapeConvert::ToArray(midpoints, "HexRemesh.LostCreasePositions"));
  output->GetFieldData()->AddArray(
    vtkShapeConvert::ToArray(lengths, "HexRemesh.LostCreaseLengths"));
}

} // namespace

void vtkShapeHexResult::AddFacts(
  const shape::HexRemeshResult& result, vtkUnstructuredGrid* hexahedra, vtkDataObject* output)
{
  const shape::HexFit& fit = result.Fit;
  const shape::Topology topology =
    shape::ComputeTopology({ fit.Solid.Points, shape::SplitQuads(fit.Quads) });
  const std::pair<const char*, double> facts[] = {
    { "Hexahedra", static_cast<double>(fit.Solid.Hexahedra.rows()) },
    { "MinimumScaledJacobian", fit.MinimumScaledJacobian },
    { "MeanScaledJacobian", fit.MeanScaledJacobian },
    { "Distance", fit.Distance },
    { "InnerDistance", fit.InnerDistance },
    { "Blocks", result.Grid.Blocks },
    { "Regions",
      result.Regions.empty() ? fit.RegionOf.maxCoeff() + 1.0
                             : static_cast<double>(result.Regions.size()) },
    { "CellSize", result.CellSize },
    { "Patches",
      static_cast<double>(std::set<int>(fit.PatchOf.begin(), fit.PatchOf.end()).size()) },
    { "Corners", static_cast<double>(result.Features.Corners.size()) },
    { "CreasesKept", fit.CreasesKept && result.LostCreases.empty() ? 1.0 : 0.0 },
    { "LostCreases", static_cast<double>(result.LostCreases.size()) },
    { "CornersKept", static_cast<double>(fit.Creases.CornerPoints.size()) },
    { "CreaseDistance", fit.Creases.Distance },
    { "CreaseShare", result.Features.CurveShare() },
    { "ReleasedPoints", static_cast<double>(result.Fit.Released) },
    { "InnerCreasesKept", result.InnerCreasesKept ? 1.0 : 0.0 },
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
  if (!result.LostCreases.empty())
  {
    AddLostCreases(result.LostCreases, output);
  }
  if (!result.Regions.empty())
  {
    AddRegionFacts(result, output);
  }
  if (result.SizeRatios.size() > 0)
  {
    AddSizeFacts(result.SizeRatios, output);
  }
  for (const std::string& name : Measures())
  {
    output->GetFieldData()->AddArray(
      Summary(hexahedra->GetCellData()->GetArray(name.c_str()), "HexRemesh." + name));
  }
}
