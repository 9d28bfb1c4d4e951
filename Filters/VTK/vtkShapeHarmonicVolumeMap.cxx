#include "vtkShapeHarmonicVolumeMap.h"

#include "vtkShapeChargeSet.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFeatures.h"
#include "vtkShapeSolid.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "Core/Errors.h"
#include "Core/Topology.h"
#include "Geometry/Nesting.h"
#include "Geometry/SignedDistance.h"
#include "Volume/ApplyVolumeMap.h"
#include "Volume/FreeBoundary.h"
#include "Volume/TargetDistance.h"

#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeHarmonicVolumeMap);

vtkShapeHarmonicVolumeMap::vtkShapeHarmonicVolumeMap()
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

void WriteLevels(const std::vector<shape::HarmonicVolumeMapResult::Level>& levels, vtkTable* output)
{
  Eigen::MatrixXd columns(levels.size(), 8);
  for (std::size_t i = 0; i < levels.size(); ++i)
  {
    const auto& level = levels[i];
    columns.row(i) << level.Number, level.Sources, level.Collocations, level.RMSEVertices,
      level.RMSEInside, level.Maximum, level.Seconds, level.Kept;
  }
  const char* names[] = { "Level", "Sources", "Collocations", "RMSEVertices", "RMSEInside",
    "Maximum", "Seconds", "Kept" };
  for (int c = 0; c < columns.cols(); ++c)
  {
    output->AddColumn(vtkShapeConvert::ToArray(columns.col(c), names[c]));
  }
}

const char* Word(shape::HarmonicVolumeMapResult::Stop reason)
{
  switch (reason)
  {
    case shape::HarmonicVolumeMapResult::Stop::Tolerance:
      return "Tolerance";
    case shape::HarmonicVolumeMapResult::Stop::NoImprovement:
      return "NoImprovement";
    case shape::HarmonicVolumeMapResult::Stop::Levels:
      break;
  }
  return "Levels";
}

} // namespace

void vtkShapeHarmonicVolumeMap::Execute(const shape::Progress& progress)
{
  vtkDataObject* domain = this->GetInputDataObject(0, 0);
  for (vtkDataSet* leaf : vtkShapeConvert::Leaves(domain))
  {
    shape::RequireFinite(vtkShapeConvert::ToPoints(leaf), "the Domain");
  }
  if (this->FoldFree)
  {
    vtkShapeSolid::RequireOneSolid(domain, this->GetController());
  }
  vtkPolyData* boundary = this->GetWhole(1).Data;
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
    ? shape::TargetDistance(mesh, targets,
        vtkShapeConvert::ToMesh(this->GetWhole(4).Data, "the Target"), progress.Part(0.0, 0.02))
    : 0.0;
  const auto wholes = [&](int port)
  {
    std::vector<vtkPolyData*> all;
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      all.push_back(this->GetWhole(port, i).Data);
    }
    return all;
  };
  const shape::VolumeFeatures features = vtkShapeFeatures::Read(wholes(2), wholes(3),
    this->MapArray, this->Options.FeatureWeight, LongestStep * shape::LongestSide(mesh.Points));
  shape::HarmonicVolumeMapResult result = shape::HarmonicVolumeMap(
    mesh, targets, features, this->Options, progress.Part(0.02, this->FreeBoundary ? 0.3 : 0.8));
  shape::FreeBoundaryResult freed;
  if (this->FreeBoundary)
  {
    freed = shape::FreeBoundary(mesh, targets,
      vtkShapeConvert::ToMesh(this->GetWhole(4).Data, "the Target"), features, this->Options,
      result, progress.Part(0.3, 0.8));
    targets = freed.Targets;
    result = freed.Map;
  }

  const double farthest = vtkShapeChargeSet::Farthest(result.OffsetDistance, mesh);
  const shape::SignedDistance distance(
    shape::OrientedByNesting(mesh, "the Boundary", progress.Part(0.8, 0.82)));
  vtkDataObject* moved = this->GetOutputDataObject(0);
  const auto counts = vtkShapeChargeSet::Move(
    domain, moved,
    [&](const Eigen::MatrixXd& points, const shape::Progress& part)
    { return shape::ApplyVolumeMap(result.Map, distance, farthest, points, part); },
    progress.Part(0.82, this->FoldFree ? 0.9 : 1.0));
  if (this->FoldFree)
  {
    const auto inverted = vtkShapeSolid::MakeFoldFree(
      domain, moved, mesh, targets, this->GetController(), progress.Part(0.9, 1.0));
    vtkShapeConvert::AddFact(moved, "HarmonicVolumeMap.InvertedBefore", inverted.first);
    vtkShapeConvert::AddFact(moved, "HarmonicVolumeMap.InvertedAfter", inverted.second);
  }

  // Every process has found the same map: one of them hands it on.
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    vtkShapeChargeSet::Write(
      result.Map, mesh, vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
    WriteLevels(result.Levels, vtkTable::SafeDownCast(this->GetOutputDataObject(2)));
  }
  // The last level's errors are those of the whole sum, whether it was kept or not.
  const auto& last = result.Levels.back();
  for (const int port : { 0, 1 })
  {
    vtkDataObject* output = this->GetOutputDataObject(port);
    const std::pair<const char*, double> facts[] = { { "RMSEVertices", last.RMSEVertices },
      { "RMSEInside", last.RMSEInside }, { "Maximum", last.Maximum },
      { "RMSEFeatures", result.RMSEFeatures },
      { "FeaturePoints", static_cast<double>(features.Points.rows()) },
      { "OffsetDistance", result.OffsetDistance }, { "DeletedSources", result.DeletedSources },
      { "InsertedSources", result.InsertedSources } };
    for (const auto& [fact, value] : facts)
    {
      vtkShapeConvert::AddFact(output, std::string("HarmonicVolumeMap.") + fact, value);
    }
    this->AddCount(port, "HarmonicVolumeMap.OutsidePoints", static_cast<double>(counts[1]));
    vtkShapeConvert::AddFact(output, "HarmonicVolumeMap.Stop", Word(result.Reason));
    if (hasTarget)
    {
      vtkShapeConvert::AddFact(output, "HarmonicVolumeMap.TargetDistance", targetDistance);
    }
    if (this->FreeBoundary)
    {
      vtkShapeConvert::AddFact(
        output, "HarmonicVolumeMap.DistortionBefore", freed.DistortionBefore);
      vtkShapeConvert::AddFact(output, "HarmonicVolumeMap.DistortionAfter", freed.DistortionAfter);
      vtkShapeConvert::AddFact(
        output, "HarmonicVolumeMap.FreeBoundary", freed.Kept ? "Slid" : "NotLower");
    }
  }
}
