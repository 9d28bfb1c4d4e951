#include "vtkShapeApplyVolumeMap.h"

#include "vtkShapeChargeSet.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/PiecewiseInverseMap.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeApplyVolumeMap);

vtkShapeApplyVolumeMap::vtkShapeApplyVolumeMap()
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Map", PortData::Whole, PortUse::Required, { "vtkPolyData" });
  this->DeclareMovedOutput();
  this->DeclareFacts();
}

void vtkShapeApplyVolumeMap::Execute(const shape::Progress& progress)
{
  vtkDataObject* domain = this->GetInputDataObject(0, 0);
  for (vtkDataSet* leaf : vtkShapeComposite::Of(domain))
  {
    shape::RequireFinite(vtkShapeConvert::ToPoints(leaf), "the Input");
  }
  const std::vector<vtkDataSet*> maps = vtkShapeComposite::Of(this->GetInputDataObject(1, 0));
  const auto count = std::count_if(
    maps.begin(), maps.end(), [](vtkDataSet* leaf) { return leaf->GetNumberOfPoints() > 0; });
  if (count > 1)
  {
    throw shape::InvalidInput("the Map has " + std::to_string(count) +
      " blocks; extract one charge set with Extract Block");
  }
  const auto map = std::make_shared<const shape::PiecewiseHarmonicMap>(
    vtkShapeChargeSet::Read(this->GetGatheredInput(1).Data, "the Map"),
    progress.Part(0.05, 0.1, "preparing the map"));

  std::array<std::vector<Eigen::RowVector3d>, 2> found;
  vtkDataObject* moved = this->GetOutputDataObject(0);
  if (this->Inverse)
  {
    const shape::PiecewiseInverseMap inverse(
      map, {}, progress.Part(0.1, 0.2, "preparing the inverse map"));
    const auto position = [&](const Eigen::MatrixXd& points, const shape::Progress& part)
    {
      const shape::InverseMap::Result result = inverse.Find(points, part);
      return shape::MovedPoints{ result.Points, result.States };
    };
    found = vtkShapeChargeSet::Move(
      domain, moved, position, progress.Part(0.2, 1.0, "inverting the map"));
  }
  else
  {
    const auto position = [&](const Eigen::MatrixXd& points, const shape::Progress& part)
    { return shape::ApplyVolumeMap(*map, points, part); };
    found = vtkShapeChargeSet::Move(
      domain, moved, position, progress.Part(0.1, 1.0, "moving the points"));
  }
  this->AddCount(0, "ApplyVolumeMap.OutsidePoints", std::move(found[0]));
  this->AddCount(0, "ApplyVolumeMap.NotInverted", std::move(found[1]));
}
