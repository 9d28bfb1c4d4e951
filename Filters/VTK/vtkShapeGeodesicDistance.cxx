#include "vtkShapeGeodesicDistance.h"

#include "vtkShapeConvert.h"

#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkShapeGeodesicDistance);

vtkShapeGeodesicDistance::vtkShapeGeodesicDistance()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Seeds", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareOutputLikeInput();
}

void vtkShapeGeodesicDistance::Execute(const shape::Progress& progress)
{
  const WholeInput& whole = this->GetWhole(0);
  const shape::Mesh mesh = vtkShapeConvert::ToMesh(whole.Data, "the surface");
  const shape::GeodesicDistanceResult result = shape::GeodesicDistance(
    mesh, vtkShapeConvert::ToPoints(this->GetWhole(1).Grid), this->Options, progress);

  // This process's points come block by block.
  const Eigen::MatrixXd distances = vtkShapeConvert::Rows(result.Distances, whole.OwnPoints);
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkIdType first = 0;
  vtkShapeConvert::ForEachLeaf(this->GetInputDataObject(0, 0), output,
    vtkShapeConvert::Points::Kept,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const vtkIdType count = from->GetNumberOfPoints();
      to->ShallowCopy(from);
      to->GetPointData()->AddArray(
        vtkShapeConvert::ToArray(distances.middleRows(first, count), "GeodesicDistance"));
      first += count;
    });
  vtkShapeConvert::AddFact(output, "GeodesicDistance.UnreachedPoints", result.Unreached);
}
