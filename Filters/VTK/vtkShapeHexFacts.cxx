#include "vtkShapeHexFacts.h"

#include "vtkShapeConvert.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMeshQuality.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

#include "Core/Topology.h"
#include "Quality/ScaledJacobian.h"

#include <algorithm>
#include <string>
#include <utility>

namespace
{

using Setter = void (vtkMeshQuality::*)();

/// What the arrays are called, and how Verdict is asked for them.
const std::pair<const char*, Setter> Measures[] = {
  { "Jacobian", &vtkMeshQuality::SetHexQualityMeasureToJacobian },
  { "Volume", &vtkMeshQuality::SetHexQualityMeasureToVolume },
  { "EdgeRatio", &vtkMeshQuality::SetHexQualityMeasureToEdgeRatio },
  { "MaxAspectFrobenius", &vtkMeshQuality::SetHexQualityMeasureToMaxAspectFrobenius },
  { "EquiangleSkew", &vtkMeshQuality::SetHexQualityMeasureToEquiangleSkew },
  { "Skew", &vtkMeshQuality::SetHexQualityMeasureToSkew },
  { "Taper", &vtkMeshQuality::SetHexQualityMeasureToTaper },
  { "Shape", &vtkMeshQuality::SetHexQualityMeasureToShape },
};

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

/// The least, the mean and the greatest of an array's values.
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

} // namespace

void vtkShapeHexFacts::AddMeasures(vtkUnstructuredGrid* hexahedra)
{
  vtkNew<vtkUnstructuredGrid> cells;
  cells->CopyStructure(hexahedra);
  for (const auto& [name, set] : Measures)
  {
    vtkNew<vtkMeshQuality> quality;
    quality->SetInputData(cells);
    (quality->*set)();
    quality->Update();
    vtkDataArray* values = quality->GetOutput()->GetCellData()->GetArray("Quality");
    values->SetName(name);
    hexahedra->GetCellData()->AddArray(values);
  }
}

void vtkShapeHexFacts::AddFacts(
  const shape::HexRemeshResult& result, vtkUnstructuredGrid* hexahedra, vtkDataObject* output)
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
  for (const auto& [name, unused] : Measures)
  {
    output->GetFieldData()->AddArray(
      Summary(hexahedra->GetCellData()->GetArray(name), std::string("HexRemesh.") + name));
  }
}
