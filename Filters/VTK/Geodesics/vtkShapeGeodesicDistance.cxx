#include "vtkShapeGeodesicDistance.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkShapeGeodesicDistance);

vtkShapeGeodesicDistance::vtkShapeGeodesicDistance()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Seeds", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareOutputLikeInput();
  this->DeclareFacts();
  this->DeclareShown(0, { "GeodesicDistance" });
}

void vtkShapeGeodesicDistance::Execute(const shape::Progress& progress)
{
  const GatheredInput& whole = this->GetGatheredInput(0);
  const shape::Surface mesh = vtkShapeConvert::ToMesh(whole.Data, "the surface");
  const shape::GeodesicDistanceResult result = shape::ComputeGeodesicDistance(
    mesh, vtkShapeConvert::ToPoints(this->GetGatheredInput(1).Grid), this->Options, progress);

  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(0, 0), output,
    { { "GeodesicDistance", vtkShapeConvert::Rows(result.Distances, whole.OwnPoints) } });
  vtkShapeConvert::AddFact(output, "GeodesicDistance.UnreachedPoints", result.Unreached);
}
