#include "vtkShapeHarmonicVolumeMap.h"

#include "vtkShapeChargeSet.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFeatures.h"
#include "vtkShapeGather.h"
#include "vtkShapeSolid.h"
#include "vtkShapeVolumeMapFacts.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "Base/Errors.h"
#include "Distance/TargetDistance.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/FreeBoundary.h"
#include "Harmonic/NearSourceSystem.h"
#include "Harmonic/PiecewiseVolumeMap.h"
#include "Mesh/Topology.h"

#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeHarmonicVolumeMap);

vtkShapeHarmonicVolumeMap::vtkShapeHarmonicVolumeMap()
  : Setup(std::make_shared<shape::AcceleratedSetup>())
{
  this->DeclareInput("Domain", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  // Any data set, although a surface is needed: ParaView offers the filter in its menu only where
  // the selection suits the input that comes first in the alphabet, and users select the solid.
  this->DeclareInput("Boundary", PortData::WholeSurface, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Features", PortData::Whole, PortUse::OptionalRepeatable, { "vtkPolyData" });
  this->DeclareInput(
    "TargetFeatures", PortData::Whole, PortUse::OptionalRepeatable, { "vtkPolyData" });
  this->DeclareInput("Target", PortData::WholeSurface, PortUse::Optional, { "vtkPolyData" });
  this->DeclareMovedOutput();
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkTable");
  this->DeclareMeasures({ "Inverted" });
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

/// Between the points of a curve that is matched, as a share of the longest side of the boundary.
constexpr double LongestStep = 0.01;

/// What the names of the facts begin with.
const std::string Facts = vtkShapeVolumeMapFacts::Prefix;

/// One harmonic map as a solution of one region.
shape::PiecewiseVolumeMapResult OneRegion(
  shape::HarmonicVolumeMapResult map, const shape::Mesh& mesh)
{
  shape::PiecewiseVolumeMapResult result;
  result.Charges = { { map.Map }, mesh };
  result.Charges.Farthest = vtkShapeChargeSet::Farthest(map.OffsetDistance, mesh);
  // The last level's errors are those of the whole sum, whether it was kept or not.
  const auto& last = map.Levels.back();
  result.Borders.push_back({ last.RMSEVertices, last.RMSEInside, last.Maximum });
  result.RMSEFeatures = map.RMSEFeatures;
  result.OffsetDistance = map.OffsetDistance;
  result.Layers.push_back(std::move(map));
  return result;
}

} // namespace

Eigen::MatrixXd vtkShapeHarmonicVolumeMap::Solve(
  vtkPolyData* charges, vtkTable* levels, const shape::Progress& progress)
{
  vtkPolyData* boundary = this->GetGatheredInput(1).Data;
  const shape::Mesh mesh = vtkShapeConvert::ToMesh(boundary, "the Boundary");
  Eigen::MatrixXd targets =
    vtkShapeConvert::ToPointArray(boundary, this->MapArray, 3, "the Boundary");
  shape::RequireFinite(targets, "the map array of the Boundary");
  const bool hasTarget = this->GetNumberOfInputConnections(4) > 0;
  if (this->FreeBoundary && !hasTarget)
  {
    throw shape::InvalidInput("FreeBoundary needs the input 'Target', the surface that the "
                              "boundary's images slide on; connect it, or turn FreeBoundary off");
  }
  const double targetDistance = hasTarget
    ? shape::ComputeTargetDistance(mesh, targets,
        vtkShapeConvert::ToMesh(this->GetGatheredInput(4).Data, "the Target"),
        progress.Part(0.0, 0.02))
    : 0.0;
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
    given = vtkShapeFeatures::TakeSurfaces(given.Features, given.Targets, this->MapArray);
  }
  const shape::VolumeFeatures features =
    vtkShapeFeatures::Read(given.Features, given.Targets, this->MapArray,
      this->Options.FeatureWeight, LongestStep * shape::ComputeLongestBoxEdge(mesh.Points));
  shape::HarmonicVolumeMapResult one;
  shape::FreeBoundaryResult freed;
  if (this->FreeBoundary || !this->Exact)
  {
    one = shape::ComputeHarmonicVolumeMap(mesh, targets, features, this->Options,
      progress.Part(0.02, this->FreeBoundary ? 0.3 : 1.0), this->Setup.get());
  }
  if (this->FreeBoundary)
  {
    freed = shape::SlideBoundary(mesh, targets,
      vtkShapeConvert::ToMesh(this->GetGatheredInput(4).Data, "the Target"), features,
      this->Options, one, progress.Part(0.3, this->Exact ? 0.6 : 1.0));
    targets = freed.Targets;
    one = freed.Map;
  }
  const shape::PiecewiseVolumeMapResult result = this->Exact
    ? shape::ComputePiecewiseVolumeMap(mesh, targets, given.Surfaces, features, this->Options, {},
        progress.Part(this->FreeBoundary ? 0.6 : 0.02, 1.0))
    : OneRegion(std::move(one), mesh);

  vtkShapeChargeSet::Write(result.Charges, charges);
  vtkShapeVolumeMapFacts::WriteLevels(result.Layers, levels);
  vtkShapeVolumeMapFacts::AddFacts(result, this->Options.Method, this->Exact, charges);
  vtkShapeConvert::AddFact(
    charges, Facts + "FeaturePoints", static_cast<double>(features.Points.rows()));
  if (hasTarget)
  {
    vtkShapeConvert::AddFact(charges, Facts + "TargetDistance", targetDistance);
  }
  if (this->FreeBoundary)
  {
    vtkShapeConvert::AddFact(charges, Facts + "DistortionBefore", freed.DistortionBefore);
    vtkShapeConvert::AddFact(charges, Facts + "DistortionAfter", freed.DistortionAfter);
    vtkShapeConvert::AddFact(charges, Facts + "FreeBoundary", freed.Kept ? "Slid" : "NotLower");
  }
  return targets;
}

void vtkShapeHarmonicVolumeMap::Execute(const shape::Progress& progress)
{
  vtkMultiProcessController* controller = this->GetController();
  const bool first = !controller || controller->GetLocalProcessId() == 0;
  vtkDataObject* domain = this->GetInputDataObject(0, 0);
  vtkDataObject* moved = this->GetOutputDataObject(0);
  vtkNew<vtkPolyData> found;
  vtkNew<vtkTable> table;
  Eigen::MatrixXd images; // of the boundary's points
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
      if (first)
      {
        images = this->Solve(found, table, progress.Part(0.0, 0.8));
      }
    });
  vtkShapeGather::Share(controller, found);
  vtkShapeGather::Share(controller, images);
  const shape::PiecewiseHarmonicMap map(
    vtkShapeChargeSet::Read(found, "the map"), progress.Part(0.8, 0.82));
  const auto counts = vtkShapeChargeSet::Move(
    domain, moved,
    [&](const Eigen::MatrixXd& points, const shape::Progress& part)
    { return shape::ApplyVolumeMap(map, points, part); },
    progress.Part(0.82, this->FoldFree ? 0.9 : 1.0));
  if (this->FoldFree)
  {
    const auto inverted = vtkShapeSolid::MakeFoldFree(domain, moved,
      vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "the Boundary"), images, controller,
      progress.Part(0.9, 1.0));
    vtkShapeConvert::AddFact(moved, Facts + "InvertedBefore", inverted.first);
    vtkShapeConvert::AddFact(moved, Facts + "InvertedAfter", inverted.second);
  }

  // One process hands the charges on; the others say the same facts about them.
  auto* charges = vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
  if (first)
  {
    charges->CopyStructure(found);
    charges->GetPointData()->ShallowCopy(found->GetPointData());
    charges->GetCellData()->ShallowCopy(found->GetCellData());
    charges->GetFieldData()->ShallowCopy(found->GetFieldData());
    auto* levels = vtkTable::SafeDownCast(this->GetOutputDataObject(2));
    levels->GetRowData()->ShallowCopy(table->GetRowData());
  }
  vtkFieldData* facts = found->GetFieldData();
  for (int i = 0; i < facts->GetNumberOfArrays(); ++i)
  {
    vtkAbstractArray* fact = facts->GetAbstractArray(i);
    if (std::string(fact->GetName()).rfind(Facts, 0) == 0)
    {
      moved->GetAttributesAsFieldData(vtkDataObject::FIELD)->AddArray(fact);
      charges->GetFieldData()->AddArray(fact);
    }
  }
  for (const int port : { 0, 1 })
  {
    this->AddCount(port, Facts + "OutsidePoints", static_cast<double>(counts[1]));
  }
}
