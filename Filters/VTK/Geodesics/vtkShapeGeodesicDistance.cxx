#include "vtkShapeGeodesicDistance.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapePositions.h"
#include "vtkShapeSeenInput.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"

vtkStandardNewMacro(vtkShapeGeodesicDistance);

/// The surface, which keeps the factorisations that belong to it.
struct vtkShapeGeodesicDistance::Kept
{
  vtkShapeSeenInput Input;
  std::unique_ptr<shape::Surface> Mesh;
  bool IsSeparated = false; ///< see RepairInput
};

vtkShapeGeodesicDistance::vtkShapeGeodesicDistance()
  : Cache(std::make_unique<Kept>())
{
  this->DeclareInput("Input", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Seeds", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareOutputLikeInput();
  this->DeclareFacts();
  this->DeclareShown(0, { "GeodesicDistance" });
}

vtkShapeGeodesicDistance::~vtkShapeGeodesicDistance() = default;

void vtkShapeGeodesicDistance::SetNumberOfSeedPoints(int count)
{
  if (vtkShapePositions::Resize(this->SeedPoints, count))
  {
    this->Modified();
  }
}

void vtkShapeGeodesicDistance::SetSeedPoints(int index, double x, double y, double z)
{
  if (vtkShapePositions::Set(this->SeedPoints, index, x, y, z))
  {
    this->Modified();
  }
}

Eigen::MatrixXd vtkShapeGeodesicDistance::FindSeeds()
{
  const Eigen::MatrixXd picked = vtkShapePositions::ToRows(this->SeedPoints);
  const Eigen::MatrixXd given = this->GetNumberOfInputConnections(1) > 0
    ? vtkShapeConvert::ToPoints(this->GetGatheredInput(1).Grid)
    : Eigen::MatrixXd(0, 3);
  if (given.rows() + picked.rows() == 0)
  {
    throw shape::InvalidInput(
      "no seed; press Pick and click on the surface, or connect points to Seeds");
  }
  Eigen::MatrixXd seeds(given.rows() + picked.rows(), 3);
  seeds << given, picked;
  return seeds;
}

void vtkShapeGeodesicDistance::Execute(const shape::Progress& progress)
{
  const bool isSeparated =
    this->Options.Method == shape::GeodesicDistanceOptions::MethodType::Exact;
  this->RepairInput(0, 0, isSeparated);
  const GatheredInput& whole = this->GetGatheredInput(0);
  if (this->Cache->Input.IsNew(*this, 0, whole.Data) || !this->Cache->Mesh ||
    this->Cache->IsSeparated != isSeparated)
  {
    this->Cache->IsSeparated = isSeparated;
    this->Cache->Mesh.reset(); // an error below must not leave the last surface
    this->Cache->Mesh =
      std::make_unique<shape::Surface>(vtkShapeConvert::ToMesh(whole.Data, "the surface"));
  }
  const shape::GeodesicDistanceResult result =
    shape::ComputeGeodesicDistance(*this->Cache->Mesh, this->FindSeeds(), this->Options, progress);

  if (result.Unreached > 0)
  {
    this->Warn(std::to_string(result.Unreached) +
      " points are connected to no seed: their GeodesicDistance is -1; add a seed on each "
      "component, "
      "or remove them with Connectivity");
  }
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(0, 0), output,
    { { "GeodesicDistance", vtkShapeConvert::Rows(result.Distances, whole.OwnPoints) } });
  vtkShapeConvert::AddFact(output, "GeodesicDistance.UnreachedPoints", result.Unreached);
}
