#include "vtkShapeApplyVolumeMap.h"

#include "vtkShapeChargeSet.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFiniteElements.h"

#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/FiniteElementMap.h"
#include "Harmonic/PiecewiseInverseMap.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <array>
#include <functional>
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
  this->Device = { shape::SumDevice::KindType::Automatic,
    [this](const std::string& warning) { this->Warn(warning); } };
}

namespace
{

/// Moves the points of one data set.
using Position =
  std::function<shape::MovedPoints(const Eigen::MatrixXd& points, const shape::Progress& progress)>;

Position PrepareElements(vtkPolyData* data, bool inverse, const shape::Progress& progress)
{
  shape::FiniteElements elements = vtkShapeFiniteElements::Read(data, "the Map");
  if (inverse)
  {
    // The inverse of a map that is linear in tetrahedra is linear in their images.
    elements.Points.swap(elements.Images);
  }
  const auto map = std::make_shared<const shape::FiniteElementMap>(std::move(elements), progress);
  return [map](const Eigen::MatrixXd& points, const shape::Progress& part)
  { return shape::ApplyVolumeMap(*map, points, part); };
}

Position PrepareCharges(
  vtkPolyData* data, bool inverse, const shape::SumDevice& device, const shape::Progress& progress)
{
  shape::PiecewiseCharges charges = vtkShapeChargeSet::Read(data, "the Map");
  charges.Device = device;
  const auto map =
    std::make_shared<const shape::PiecewiseHarmonicMap>(charges, progress.Part(0.0, 0.3));
  if (!inverse)
  {
    return [map](const Eigen::MatrixXd& points, const shape::Progress& part)
    { return shape::ApplyVolumeMap(*map, points, part); };
  }
  const auto inverted = std::make_shared<const shape::PiecewiseInverseMap>(
    map, shape::InverseMapOptions(), progress.Part(0.3, 1.0, "preparing the inverse map"));
  return [inverted](const Eigen::MatrixXd& points, const shape::Progress& part)
  {
    const shape::InverseMap::Result result = inverted->Find(points, part);
    return shape::MovedPoints{ result.Points, result.States };
  };
}

} // namespace

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
  vtkPolyData* data = this->GetGatheredInput(1).Data;
  const Position position = vtkShapeFiniteElements::Has(data)
    ? PrepareElements(data, this->Inverse, progress.Part(0.05, 0.2, "preparing the map"))
    : PrepareCharges(
        data, this->Inverse, this->Device, progress.Part(0.05, 0.2, "preparing the map"));
  std::array<std::vector<Eigen::RowVector3d>, 2> found =
    vtkShapeChargeSet::Move(domain, this->GetOutputDataObject(0), position,
      progress.Part(0.2, 1.0, this->Inverse ? "inverting the map" : "moving the points"));
  this->AddCount(0, "ApplyVolumeMap.OutsidePoints", std::move(found[0]));
  this->AddCount(0, "ApplyVolumeMap.NotInverted", std::move(found[1]));
}
