#include "vtkShapeMapDifference.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapePreciseMap.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "Base/Errors.h"
#include "Correspondence/Evaluate/MetricEmbedding.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <cmath>
#include <vector>

vtkStandardNewMacro(vtkShapeMapDifference);

vtkShapeMapDifference::vtkShapeMapDifference()
{
  this->DeclareInput("SurfaceA", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("SurfaceB", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
  this->DeclareOutput("vtkTable");
  this->DeclareFacts(
    { { 0, { "AreaEigenvalues", "ConformalEigenvalues" } }, { 1, { "OffsetDistance" } } });
  this->DeclareShown(0, { "AreaDifference" });
  this->DeclareMemoryRemedy("lower Number Of Eigenpairs");
}

namespace
{

void AddColumns(const Eigen::MatrixXd& matrix, const std::string& name, vtkTable* table)
{
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
  {
    table->AddColumn(vtkShapeConvert::ToArray(matrix.col(column), name + std::to_string(column)));
  }
}

} // namespace

void vtkShapeMapDifference::Execute(const shape::Progress& progress)
{
  const GatheredInput& whole = this->GetGatheredInput(0);
  const shape::Surface first = vtkShapeConvert::ToMesh(whole.Data, "SurfaceA");
  const shape::Surface second = vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "SurfaceB");
  const Eigen::MatrixXd images =
    vtkShapeConvert::ToPointArray(whole.Data, this->MapArray, 3, "SurfaceA");
  shape::RequireFinite(images, "the map array '" + this->MapArray + "' of SurfaceA");
  shape::RequireManifold(second, "SurfaceB");
  // A precise map names the triangles, which are other ones if SurfaceB was repaired. Other map
  // arrays give positions, which are projected.
  const bool precise = vtkShapePreciseMap::Has(whole.Data, this->MapArray) &&
    this->GetGatheredInput(1).GivenTriangles.empty();
  shape::SurfacePoints map;
  if (precise)
  {
    map = vtkShapePreciseMap::Read(whole.Data, "SurfaceA",
      vtkShapePreciseMap::ToSurface(this->GetGatheredInput(1).Data, "SurfaceB"), "SurfaceB");
  }
  else
  {
    map = shape::SurfaceLocator(second).Find(images, progress.Part(0.0, 0.05));
  }
  shape::RequireOption(
    std::isfinite(this->OffsetDistance), "OffsetDistance", this->OffsetDistance, "finite");
  const bool hasOffset = this->OffsetDistance != 0.0;
  const shape::MapDifferenceResult result = shape::MapDifference(
    first, second, map, this->Options, progress.Part(0.05, hasOffset ? 0.55 : 1.0));

  // The offset surfaces have the triangles of the surfaces, and the map the same surface points.
  shape::MapDifferenceResult offset;
  if (hasOffset)
  {
    offset = shape::MapDifference(shape::OffsetSurface(first, this->OffsetDistance, "SurfaceA"),
      shape::OffsetSurface(second, this->OffsetDistance, "SurfaceB"), map, this->Options,
      progress.Part(0.55, 1.0));
  }

  const auto own = [&](const Eigen::MatrixXd& values)
  { return vtkShapeConvert::Rows(values, whole.OwnPoints); };
  vtkDataObject* output = this->GetOutputDataObject(0);
  std::vector<vtkShapeComposite::PointField> fields = {
    { "AreaDifference", own(result.Area.Field) },
    { "ConformalDifference", own(result.Conformal.Field) },
    { "AreaEigenfunctions", own(result.Area.Eigenfunctions) },
    { "ConformalEigenfunctions", own(result.Conformal.Eigenfunctions) },
  };
  if (hasOffset)
  {
    fields.push_back({ "OffsetAreaDifference", own(offset.Area.Field) });
    fields.push_back({ "OffsetConformalDifference", own(offset.Conformal.Field) });
  }
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(0, 0), output, fields);
  vtkFieldData* facts = output->GetFieldData();
  facts->AddArray(
    vtkShapeConvert::ToArray(result.Area.Eigenvalues, "MapDifference.AreaEigenvalues"));
  facts->AddArray(
    vtkShapeConvert::ToArray(result.Conformal.Eigenvalues, "MapDifference.ConformalEigenvalues"));
  vtkShapeConvert::AddFact(output, "MapDifference.UndeterminedFunctions", result.Undetermined);
  vtkShapeConvert::AddFact(output, "MapDifference.PreciseMap", precise ? 1.0 : 0.0);
  // Every process has the same operators: one of them outputs them.
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    auto* table = vtkTable::SafeDownCast(this->GetOutputDataObject(1));
    AddColumns(result.Area.Matrix, "Area", table);
    AddColumns(result.Conformal.Matrix, "Conformal", table);
    AddColumns(offset.Area.Matrix, "OffsetArea", table);
    AddColumns(offset.Conformal.Matrix, "OffsetConformal", table);
    vtkShapeConvert::AddFact(table, "MapDifference.OffsetDistance", this->OffsetDistance);
  }
}
