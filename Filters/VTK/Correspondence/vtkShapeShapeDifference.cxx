#include "vtkShapeShapeDifference.h"

#include "vtkShapeConvert.h"
#include "vtkShapeLeaves.h"
#include "vtkShapePreciseMap.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

vtkStandardNewMacro(vtkShapeShapeDifference);

vtkShapeShapeDifference::vtkShapeShapeDifference()
{
  this->DeclareInput("SurfaceA", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("SurfaceB", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
  this->DeclareOutput("vtkTable");
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

void vtkShapeShapeDifference::Execute(const shape::Progress& progress)
{
  const WholeInput& whole = this->GetWhole(0);
  const shape::Mesh first = vtkShapeConvert::ToMesh(whole.Data, "SurfaceA");
  const shape::Mesh second = vtkShapeConvert::ToMesh(this->GetWhole(1).Data, "SurfaceB");
  const Eigen::MatrixXd images =
    vtkShapeConvert::ToPointArray(whole.Data, this->MapArray, 3, "SurfaceA");
  shape::RequireFinite(images, "the map array '" + this->MapArray + "' of SurfaceA");
  shape::RequireManifold(second, "SurfaceB");
  const bool precise = vtkShapePreciseMap::Has(whole.Data, this->MapArray);
  shape::PreciseMap map;
  if (precise)
  {
    map = vtkShapePreciseMap::Read(whole.Data, "SurfaceA",
      vtkShapePreciseMap::ToSurface(this->GetWhole(1).Data, "SurfaceB"), "SurfaceB");
  }
  else
  {
    map = shape::SurfaceLocator(second).Find(images, progress.Part(0.0, 0.05));
  }
  const shape::ShapeDifferenceResult result =
    shape::ShapeDifference(first, second, map, this->Options, progress.Part(0.05, 1.0));

  const auto own = [&](const Eigen::MatrixXd& values)
  { return vtkShapeConvert::Rows(values, whole.OwnPoints); };
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeLeaves::AddPointFields(this->GetInputDataObject(0, 0), output,
    { { "AreaDifference", own(result.Area.Field) },
      { "ConformalDifference", own(result.Conformal.Field) },
      { "AreaEigenfunctions", own(result.Area.Eigenfunctions) },
      { "ConformalEigenfunctions", own(result.Conformal.Eigenfunctions) } });
  vtkFieldData* facts = output->GetFieldData();
  facts->AddArray(
    vtkShapeConvert::ToArray(result.Area.Eigenvalues, "ShapeDifference.AreaEigenvalues"));
  facts->AddArray(
    vtkShapeConvert::ToArray(result.Conformal.Eigenvalues, "ShapeDifference.ConformalEigenvalues"));
  vtkShapeConvert::AddFact(output, "ShapeDifference.UndeterminedFunctions", result.Undetermined);
  vtkShapeConvert::AddFact(output, "ShapeDifference.PreciseMap", precise ? 1.0 : 0.0);
  // Every process has the same operators: one of them hands them on.
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    auto* table = vtkTable::SafeDownCast(this->GetOutputDataObject(1));
    AddColumns(result.Area.Matrix, "Area", table);
    AddColumns(result.Conformal.Matrix, "Conformal", table);
  }
}
