#include "vtkShapeGeodesicDistance.h"

#include "vtkShapeConvert.h"
#include "vtkShapeLeaves.h"

#include "vtkObjectFactory.h"
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

  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeLeaves::AddPointFields(this->GetInputDataObject(0, 0), output,
    { { "GeodesicDistance", vtkShapeConvert::Rows(result.Distances, whole.OwnPoints) } });
  vtkShapeConvert::AddFact(output, "GeodesicDistance.UnreachedPoints", result.Unreached);
}
