#include "vtkShapeHarmonicVolumeMap.h"

#include "vtkShapeChargeSet.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFeatures.h"
#include "vtkShapeFiniteElements.h"
#include "vtkShapeGather.h"
#include "vtkShapeRegions.h"
#include "vtkShapeSolid.h"
#include "vtkShapeVolumeMapFacts.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "Base/Errors.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/Certificate.h"
#include "Harmonic/FiniteElementMap.h"
#include "Harmonic/NearSurfaceCharges.h"
#include "Harmonic/PiecewiseHarmonicMap.h"
#include "Harmonic/RepairMap.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Solids/Nesting.h"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeHarmonicVolumeMap);

vtkShapeHarmonicVolumeMap::vtkShapeHarmonicVolumeMap()
  : Setup(std::make_shared<shape::AcceleratedSetup>())
{
  this->DeclareInput("Domain", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  // Any data set, although a surface is needed: ParaView only enables the filter if the selection
  // is valid for the alphabetically first input, and users select the solid.
  this->DeclareInput(
    "Boundary", PortData::WholeSurface, PortUse::Required, { "vtkDataSet", "vtkUnstructuredGrid" });
  this->DeclareInput("Features", PortData::Whole, PortUse::OptionalRepeatable, { "vtkPolyData" });
  this->DeclareInput(
    "TargetFeatures", PortData::Whole, PortUse::OptionalRepeatable, { "vtkPolyData" });
  this->DeclareInput("Target", PortData::WholeSurface, PortUse::Optional, { "vtkPolyData" });
  this->DeclareMovedOutput();
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkTable");
  this->DeclareFacts({ { 1, { "OffsetDistance" } } });
  this->DeclareMemoryRemedy("lower Collocation Ratio");
  this->DeclareMeasures({ "Inverted" });
  this->Options.Device = { shape::SumDevice::KindType::Automatic,
    [this](const std::string& warning) { this->Warn(warning); } };
}

void vtkShapeHarmonicVolumeMap::AddFeatures(vtkAlgorithmOutput* feature)
{
  this->AddInputConnection(2, feature);
}

void vtkShapeHarmonicVolumeMap::RemoveAllFeatures()
{
  this->SetInputConnection(2, nullptr);
}

void vtkShapeHarmonicVolumeMap::AddTargetFeatures(vtkAlgorithmOutput* target)
{
  this->AddInputConnection(3, target);
}

void vtkShapeHarmonicVolumeMap::RemoveAllTargetFeatures()
{
  this->SetInputConnection(3, nullptr);
}

namespace
{

/// The maximum distance of points on a matched curve, relative to the longest edge of the
/// boundary's bounding box.
constexpr double LongestStep = 0.01;

/// The prefix of the names of the facts.
const std::string Facts = vtkShapeVolumeMapFacts::Prefix;

/// Adds what is proven about the map, by CertifyMap or RepairMap.
template <typename Certificate>
void AddShares(const Certificate& certificate, vtkPolyData* facts)
{
  vtkShapeConvert::AddFact(facts, Facts + "CertifiedShare", certificate.CertifiedShare);
  vtkShapeConvert::AddFact(facts, Facts + "UndecidedShare", certificate.UndecidedShare);
  vtkShapeConvert::AddFact(facts, Facts + "InvertedShare", certificate.InvertedShare);
}

} // namespace

shape::VolumeMapResult vtkShapeHarmonicVolumeMap::Solve(
  vtkPolyData* facts, shape::AcceleratedSetup& setup, const shape::Progress& progress)
{
  if ((this->Certify || this->Repair) &&
    (this->Exact ||
      this->Options.Method == shape::HarmonicVolumeMapOptions::MethodType::FiniteElements))
  {
    throw shape::InvalidInput(std::string(this->Repair ? "Repair" : "Certify") +
      " needs one harmonic map of the whole solid; turn Exact off, and choose another Method than "
      "FiniteElements");
  }
  vtkPolyData* boundary = this->GetGatheredInput(1).Data;
  vtkShapeRegions::RequireNoneTouch(boundary, "the Boundary");
  shape::VolumeMapConditions conditions;
  conditions.Boundary = vtkShapeConvert::ToMesh(boundary, "the Boundary");
  conditions.Targets = vtkShapeConvert::ToPointArray(boundary, this->MapArray, 3, "the Boundary");
  shape::RequireFinite(conditions.Targets, "the map array of the Boundary");
  const bool hasTarget = this->GetNumberOfInputConnections(4) > 0;
  if (hasTarget)
  {
    conditions.Target = vtkShapeConvert::ToMesh(this->GetGatheredInput(4).Data, "the Target");
  }
  const auto wholes = [&](int port)
  {
    std::vector<vtkPolyData*> all;
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      all.push_back(this->GetGatheredInput(port, i).Data);
    }
    return all;
  };
  vtkShapeFeatures::Split given{ {}, wholes(2), wholes(3) };
  if (this->Exact)
  {
    for (std::size_t i = 0; i < given.Features.size(); ++i)
    {
      vtkShapeRegions::RequireNoneTouch(given.Features[i], "feature " + std::to_string(i));
    }
    given = vtkShapeFeatures::TakeSurfaces(given.Features, given.Targets, this->MapArray);
  }
  conditions.Surfaces = given.Surfaces;
  conditions.Features = vtkShapeFeatures::Read(given.Features, given.Targets, this->MapArray,
    this->Options.FeatureWeight, LongestStep * shape::ComputeLongestBoxEdge(conditions.Boundary));

  const shape::VolumeMapOptions options{ this->Options, this->Exact, this->FreeBoundary };
  shape::VolumeMapResult result = shape::ComputeVolumeMap(
    conditions, options, progress.Part(0.0, this->Certify || this->Repair ? 0.3 : 1.0), &setup);
  if (this->Repair)
  {
    shape::RepairMapOptions repairing;
    repairing.Tetrahedra = this->Options.Tetrahedra;
    shape::RepairMapResult repaired = shape::RepairMap(result.Map.Charges.Maps.front(),
      shape::OrientByNesting(conditions.Boundary, "the Boundary"), result.Targets, repairing,
      progress.Part(0.3, 1.0));
    result.Map.Charges.Repair = std::move(repaired.Repair);
    AddShares(repaired, facts);
    vtkShapeConvert::AddFact(facts, Facts + "CertifiedBefore", repaired.CertifiedBefore);
    vtkShapeConvert::AddFact(facts, Facts + "CoreShare", repaired.CoreShare);
    vtkShapeConvert::AddFact(facts, Facts + "RingShare", repaired.RingShare);
    if (!repaired.Unfilled.empty())
    {
      this->Warn("the map is not repaired, as its solid cannot be filled with tetrahedra: " +
        repaired.Unfilled);
    }
    if (repaired.ImageCrossings > 0)
    {
      this->Warn("the Map Array makes triangles of the Boundary cross or touch at " +
        std::to_string(repaired.ImageCrossings) +
        " pairs, so no map of the solid is one to one; some of it stays inverted");
    }
  }
  else if (this->Certify)
  {
    const shape::PiecewiseHarmonicMap map(result.Map.Charges);
    const shape::MapCertificate certificate =
      shape::CertifyMap(map.Map(0), map.Domain().GetSurface(), {}, progress.Part(0.3, 1.0));
    AddShares(certificate, facts);
  }
  vtkShapeVolumeMapFacts::AddFacts(result.Map, this->Options.Method, this->Exact, facts);
  vtkShapeConvert::AddFact(
    facts, Facts + "FeaturePoints", static_cast<double>(conditions.Features.Points.rows()));
  vtkShapeConvert::AddFact(facts, Facts + "Tetrahedra",
    result.Elements ? static_cast<double>(result.Elements->Tetrahedra.rows()) : 0.0);
  if (hasTarget)
  {
    vtkShapeConvert::AddFact(facts, Facts + "TargetDistance", result.TargetDistance);
  }
  if (this->FreeBoundary)
  {
    vtkShapeConvert::AddFact(facts, Facts + "DistortionBefore", result.DistortionBefore);
    vtkShapeConvert::AddFact(facts, Facts + "DistortionAfter", result.DistortionAfter);
    vtkShapeConvert::AddFact(facts, Facts + "FoldedBefore", result.FoldedBefore);
    vtkShapeConvert::AddFact(facts, Facts + "FoldedAfter", result.FoldedAfter);
    vtkShapeConvert::AddFact(
      facts, Facts + "FreeBoundary", result.SlidShare > 0.0 ? "Slid" : "NotLower");
    vtkShapeConvert::AddFact(facts, Facts + "SlidShare", result.SlidShare);
  }
  return result;
}

namespace
{

/// Moves the points of one data set.
using Position =
  std::function<shape::MovedPoints(const Eigen::MatrixXd& points, const shape::Progress& progress)>;

/// Sends a map from the first process to all, and prepares it.
Position ShareMap(vtkMultiProcessController* controller, shape::VolumeMapResult& result,
  bool byElements, const shape::SumDevice& device, const shape::Progress& progress)
{
  if (byElements)
  {
    if (!result.Elements)
    {
      result.Elements.emplace();
    }
    vtkShapeFiniteElements::Share(controller, *result.Elements);
    const auto map = std::make_shared<const shape::FiniteElementMap>(*result.Elements, progress);
    return [map](const Eigen::MatrixXd& points, const shape::Progress& part)
    { return shape::ApplyVolumeMap(*map, points, part); };
  }
  vtkShapeChargeSet::Share(controller, result.Map.Charges);
  result.Map.Charges.Device = device;
  const auto map =
    std::make_shared<const shape::PiecewiseHarmonicMap>(result.Map.Charges, progress);
  return [map](const Eigen::MatrixXd& points, const shape::Progress& part)
  { return shape::ApplyVolumeMap(*map, points, part); };
}

} // namespace

// 1. Check the domain on every process, and solve for the map: on all of them together where the
//    method can, otherwise on the first one.
// 2. Send the map and the facts to all processes.
// 3. Each process moves its own pieces by it.
// 4. With FoldFree, untangle the moved solid.
void vtkShapeHarmonicVolumeMap::Execute(const shape::Progress& progress)
{
  vtkMultiProcessController* controller = this->GetController();
  const bool first = !controller || controller->GetLocalProcessId() == 0;
  vtkDataObject* domain = this->GetInputDataObject(0, 0);
  vtkDataObject* moved = this->GetOutputDataObject(0);
  vtkNew<vtkPolyData> holder;                        // of the facts, as field data
  const double solved = this->FoldFree ? 0.9 : 0.97; // share of the time
  shape::VolumeMapResult result;
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]
    {
      for (vtkDataSet* leaf : vtkShapeComposite::Of(domain))
      {
        shape::RequireFinite(vtkShapeConvert::ToPoints(leaf), "the Domain");
      }
      if (this->FoldFree)
      {
        vtkShapeSolid::RequireOneSolid(domain, controller);
      }
      // A process without the device that is asked for would let the others wait for its sums.
      shape::ChooseOpenCL(this->Options.Device, 0.0);
    });
  // Below this number of boundary points, messages take longer than the work that is shared.
  constexpr vtkIdType worthSharing = 20000;
  const bool together =
    this->Options.Method == shape::HarmonicVolumeMapOptions::MethodType::Accelerated &&
    !this->Exact && !this->FreeBoundary && this->GetNumberOfInputConnections(2) == 0 &&
    this->GetGatheredInput(1).Data->GetNumberOfPoints() >= worthSharing;
  vtkShapeGather::RunTogether(controller,
    [&](const shape::Processes& processes)
    {
      // What several processes share is valid only here.
      shape::AcceleratedSetup shared;
      shared.Processes = processes;
      if (first || together)
      {
        result = this->Solve(holder, together && processes.Count > 1 ? shared : *this->Setup,
          progress.Part(0.0, solved));
      }
    });
  vtkShapeGather::Share(controller, holder);
  vtkShapeGather::Share(controller, result.Targets);
  const bool byElements =
    this->Options.Method == shape::HarmonicVolumeMapOptions::MethodType::FiniteElements;
  const Position position = ShareMap(
    controller, result, byElements, this->Options.Device, progress.Part(solved, solved + 0.01));
  const auto found = vtkShapeChargeSet::Move(domain, moved, position,
    progress.Part(solved + 0.01, this->FoldFree ? 0.95 : 1.0, "moving the points"));
  if (this->FoldFree)
  {
    const auto inverted = vtkShapeSolid::MakeFoldFree(domain, moved,
      vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "the Boundary"), result.Targets,
      controller, progress.Part(0.95, 1.0, "untangling the moved solid"));
    vtkShapeConvert::AddFact(moved, Facts + "InvertedBefore", inverted.first);
    vtkShapeConvert::AddFact(moved, Facts + "InvertedAfter", inverted.second);
  }

  // One process outputs the map; the others output the same facts about it.
  auto* charges = vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
  if (first)
  {
    if (byElements)
    {
      vtkShapeFiniteElements::Write(*result.Elements, charges);
    }
    else
    {
      vtkShapeChargeSet::Write(result.Map.Charges, charges);
    }
    vtkShapeVolumeMapFacts::WriteLevels(
      result.Map.Layers, vtkTable::SafeDownCast(this->GetOutputDataObject(2)));
  }
  vtkFieldData* facts = holder->GetFieldData();
  for (int i = 0; i < facts->GetNumberOfArrays(); ++i)
  {
    moved->GetAttributesAsFieldData(vtkDataObject::FIELD)->AddArray(facts->GetAbstractArray(i));
    charges->GetFieldData()->AddArray(facts->GetAbstractArray(i));
  }
  for (const int port : { 0, 1 })
  {
    this->AddCount(port, Facts + "OutsidePoints", found[0]);
  }
}
