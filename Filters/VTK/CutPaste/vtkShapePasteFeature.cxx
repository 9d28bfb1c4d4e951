#include "vtkShapePasteFeature.h"

#include "vtkShapeCloud.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFeatureBase.h"
#include "vtkShapePastedData.h"
#include "vtkShapeSeenInput.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapePasteFeature);

namespace
{

/// Returns why a target cannot be a manifold; empty if it is one.
std::string DescribeFaults(const shape::Mesh& target)
{
  const shape::Topology topology = shape::ComputeTopology(target);
  const std::pair<int, const char*> faults[] = { { topology.NonManifoldEdges,
                                                   " edges with three or more triangles" },
    { topology.NonManifoldPoints, " points where sheets touch" },
    { topology.MisorientedEdges, " edges between triangles of opposite orientation" } };
  std::string text;
  for (const auto& [count, words] : faults)
  {
    if (count > 0)
    {
      text += (text.empty() ? "" : ", ") + std::to_string(count) + words;
    }
  }
  return text;
}

const char* NameOf(shape::TargetLayout layout)
{
  switch (layout)
  {
    case shape::TargetLayout::Conformal:
      return "conformal";
    case shape::TargetLayout::MinimumDistortion:
      return "least distortion";
    default:
      return "exponential map";
  }
}

} // namespace

/// The data that depend on one input only.
struct vtkShapePasteFeature::Kept
{
  vtkShapeSeenInput FeatureInput, TargetInput;
  vtkShapePastedData::Part Feature, Target;
  shape::JoinedLoops Joined;
  shape::DeformOptions Deformation;
  std::vector<std::string> Fields; ///< the names of their arrays
  shape::ExponentialMapOptions Flattening;
  std::unique_ptr<shape::FeatureToPaste> Paste;
  std::unique_ptr<shape::PasteTarget> Position;
  std::unique_ptr<shape::SoupTarget> Soup; ///< instead of Position, if the target is a soup
  /// Instead of both, if Feature or Target is a point cloud.
  std::unique_ptr<shape::PointTarget> Points;
  bool BridgesGaps = false;
  double SampledAt = 0.0;  ///< the spacing at which the target, a surface, was sampled
  std::string SoupReason;  ///< why the target is a soup
  Eigen::MatrixXd Normals; ///< of the feature, if the target is a point cloud
  bool HasOwnFill = false;
  int NonManifold = 0;                      ///< edges and points of the feature
  vtkNew<vtkPolyData> LastResult, LastLoop; ///< empty if there were none
};

vtkShapePasteFeature::vtkShapePasteFeature()
  : Cache(std::make_unique<Kept>())
{
  this->DeclareInput("Feature", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Target", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareMeasures({ "Normals" });
}

vtkShapePasteFeature::~vtkShapePasteFeature() = default;

void vtkShapePasteFeature::Execute(const shape::Progress& progress)
{
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  shape::RequireOption(this->BlendWidth >= 0.0 && this->BlendWidth <= 1.0, "BlendWidth",
    this->BlendWidth, "at least 0 and at most 1");
  this->PrepareFeature(progress.Part(0.0, 0.2, "preparing the feature"));
  this->PrepareTarget(progress.Part(0.2, 0.3, "preparing the target"));
  this->Paste.Frames = this->Frames;
  this->Placement.Seed << this->Seed[0], this->Seed[1], this->Seed[2];
  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  auto* loop = vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
  try
  {
    this->PasteInto(output, loop, progress.Part(0.3, 1.0));
  }
  catch (const std::runtime_error& refusal)
  {
    if (!this->Paste.Dragging)
    {
      throw;
    }
    // Until the mouse reaches a valid position, the last result is kept.
    output->ShallowCopy(this->Cache->LastResult);
    loop->ShallowCopy(this->Cache->LastLoop);
    vtkShapeConvert::AddFact(output, "PasteFeature.Refused", 1.0);
    vtkShapeConvert::AddFact(output, "PasteFeature.Refusal", refusal.what());
    return;
  }
  this->Cache->LastResult->ShallowCopy(output);
  this->Cache->LastLoop->ShallowCopy(loop);
}

/// The feature's weights do not depend on the target nor on the placement: dragging reuses them.
void vtkShapePasteFeature::PrepareFeature(const shape::Progress& progress)
{
  Kept& kept = *this->Cache;
  const std::vector<std::string> fields = { this->RigidityArray, this->ScaleArray,
    this->SegmentArray };
  if (!kept.FeatureInput.IsNew(*this, 0, this->GetGatheredInput(0).Data) && kept.Paste &&
    kept.Joined == this->Joined && kept.Deformation == this->Options && kept.Fields == fields)
  {
    return;
  }
  kept.Paste.reset();
  kept.Normals.resize(0, 3);
  kept.LastResult->Initialize();
  kept.LastLoop->Initialize();
  kept.NonManifold = 0;
  vtkPolyData* data = this->GetGatheredInput(0).Data;
  kept.Feature = vtkShapeCloud::IsPointCloud(data)
    ? vtkShapePastedData::ReadCloud(data, progress.Part(0.0, 0.1))
    : vtkShapePastedData::Read(data, "the Feature", progress.Part(0.0, 0.1));
  const shape::Mesh& surface = kept.Feature.Surface;
  vtkShapeFeatureBase::Feature feature =
    vtkShapeFeatureBase::Read(kept.Feature.Data, surface, this->Joined, progress.Part(0.1, 0.5));
  kept.HasOwnFill = feature.HasOwnFill;
  if (!vtkShapeCloud::IsPointCloud(data)) // local triangles overlap
  {
    const shape::Topology topology = shape::ComputeTopology(surface);
    kept.NonManifold = topology.NonManifoldEdges + topology.NonManifoldPoints;
  }
  kept.Paste = std::make_unique<shape::FeatureToPaste>(surface, std::move(feature.Bases),
    this->Options, this->ReadFields(kept.Feature.Data, "the Feature"), progress.Part(0.5, 1.0));
  kept.Joined = this->Joined;
  kept.Deformation = this->Options;
  kept.Fields = fields;
}

/// A surface is sampled as densely as the feature's loop, within limits. Edges are split in two,
/// so the mean edge is about this length divided by the square root of 2.
double vtkShapePasteFeature::SpacingOnTarget() const
{
  const Kept& kept = *this->Cache;
  constexpr double finest = 1.0 / 300.0; // of the diagonal: at most about 300,000 points
  const shape::BoundaryHandle& loop = kept.Paste->LoopHandle();
  double length = 0.0;
  for (const auto side : loop.Segments.rowwise())
  {
    length += (loop.Positions.row(side(1)) - loop.Positions.row(side(0))).norm();
  }
  return std::max(M_SQRT2 * length / static_cast<double>(loop.Segments.rows()),
    finest * shape::ComputeBoxDiagonal(kept.Target.Surface));
}

void vtkShapePasteFeature::PrepareTarget(const shape::Progress& progress)
{
  Kept& kept = *this->Cache;
  const bool isFlattenedSo = kept.Flattening.UpwindAverage == this->Flattening.UpwindAverage &&
    kept.Flattening.NormalSmoothing == this->Flattening.NormalSmoothing;
  vtkPolyData* data = this->GetGatheredInput(1).Data;
  const bool isCloud = vtkShapeCloud::IsPointCloud(data);
  const bool isOfPoints = isCloud || vtkShapeCloud::IsPointCloud(this->GetGatheredInput(0).Data);
  const bool isReady = isOfPoints ? !!kept.Points : kept.Position || kept.Soup;
  const bool isNew = kept.TargetInput.IsNew(*this, 1, data);
  if (!isNew && isReady && isFlattenedSo && kept.BridgesGaps == this->BridgeGaps &&
    (!isOfPoints || isCloud || kept.SampledAt == this->SpacingOnTarget()))
  {
    return;
  }
  kept.Position.reset();
  kept.Soup.reset();
  kept.Points.reset();
  kept.LastResult->Initialize();
  kept.LastLoop->Initialize();
  kept.Target = isCloud ? vtkShapePastedData::ReadCloud(data, progress.Part(0.0, 0.7))
                        : vtkShapePastedData::Read(data, "the Target", progress.Part(0.0, 0.3));
  kept.SoupReason = isOfPoints ? "" : DescribeFaults(kept.Target.Surface);
  if (isOfPoints)
  {
    if (!isCloud)
    {
      kept.SampledAt = this->SpacingOnTarget();
      kept.Target = vtkShapePastedData::SamplePart(
        kept.Target, kept.SampledAt, progress.Part(0.3, 0.7, "sampling the target"));
    }
    kept.Points = std::make_unique<shape::PointTarget>(
      kept.Target.Samples, this->Flattening, progress.Part(0.7, 1.0));
  }
  else if (this->BridgeGaps || !kept.SoupReason.empty())
  {
    kept.Soup = std::make_unique<shape::SoupTarget>(
      kept.Target.Surface, this->Flattening, progress.Part(0.3, 1.0));
  }
  else
  {
    kept.Position = std::make_unique<shape::PasteTarget>(
      kept.Target.Surface, this->Flattening, progress.Part(0.3, 1.0));
  }
  kept.Flattening = this->Flattening;
  kept.BridgesGaps = this->BridgeGaps;
}

void vtkShapePasteFeature::PasteInto(
  vtkPolyData* output, vtkPolyData* loop, const shape::Progress& progress)
{
  Kept& kept = *this->Cache;
  if (kept.Points && kept.Normals.rows() == 0)
  {
    kept.Normals = vtkShapePastedData::NormalsOf(kept.Feature, progress.Part(0.0, 0.1));
  }
  const shape::PastedFeature pasted = kept.Points
    ? kept.Paste->PasteOn(
        *kept.Points, kept.Normals, this->Placement, this->Paste, progress.Part(0.1, 1.0))
    : kept.Soup ? kept.Paste->PasteOn(*kept.Soup, this->Placement, this->Paste, progress)
                : kept.Paste->PasteOn(*kept.Position, this->Placement, this->Paste, progress);
  vtkShapePastedData::Write(
    pasted, *kept.Paste, kept.Target, kept.Feature, this->BlendWidth, output);
  vtkShapePastedData::WriteLoop(pasted, *kept.Paste, loop);
  if (kept.NonManifold > 0)
  {
    this->Warn("the Feature has " + std::to_string(kept.NonManifold) +
      " edges with three or more triangles or points where sheets touch, and so has the result; "
      "repair the Feature with Shape Solidify");
  }
  if (pasted.IsOnSoup)
  {
    std::ostringstream words;
    words << "the Target stays a polygon soup ("
          << (kept.SoupReason.empty() ? "BridgeGaps is on" : kept.SoupReason)
          << "): it was cut along the loop of the feature; " << 100.0 * pasted.JoinedShare
          << " % of the seam is joined edge by edge, and the largest gap is " << pasted.LargestGap
          << "; for a manifold, repair the Target with Shape Solidify";
    this->Warn(words.str());
  }
  if (kept.Target.Data != this->GetGatheredInput(1).Data && pasted.IsOfPoints)
  {
    this->Warn("the Feature is a point cloud, and so is the result: the Target was sampled at " +
      std::to_string(kept.Target.Surface.Points.rows()) +
      " points; for a surface, connect the points of both first");
  }
  const shape::TangentFrame& seed = pasted.Landings.front().Seed;
  const std::pair<const char*, Eigen::RowVector3d> frame[] = { { "Seed", seed.Origin },
    { "Normal", seed.Normal }, { "Direction", seed.XAxis } };
  for (const auto& [fact, value] : frame)
  {
    output->GetFieldData()->AddArray(
      vtkShapeConvert::ToArray(value, std::string("PasteFeature.") + fact));
  }
  const auto isWithoutNormals = [this](int port)
  {
    vtkPolyData* data = this->GetGatheredInput(port).Data;
    return vtkShapeCloud::IsPointCloud(data) && !vtkShapeCloud::HasNormals(data);
  };
  const bool areEstimated = isWithoutNormals(0) || isWithoutNormals(1);
  int flipped = 0;
  shape::TargetLayout layout = shape::TargetLayout::ExponentialMap;
  for (const shape::LoopOnTarget& landing : pasted.Landings)
  {
    flipped += landing.Cover.Flipped;
    layout = std::max(layout, landing.Layout);
  }
  const std::pair<const char*, double> facts[] = {
    { "DeviationBefore", shape::ComputePercentile(pasted.AnglesBefore, 0.5) },
    { "Deviation95Before", shape::ComputePercentile(pasted.AnglesBefore, 0.95) },
    { "DeviationAfter", shape::ComputePercentile(pasted.AnglesAfter, 0.5) },
    { "Deviation95After", shape::ComputePercentile(pasted.AnglesAfter, 0.95) },
    { "BandTriangles", pasted.BandTriangles }, { "FlippedTriangles", flipped },
    { "EulerNumber", pasted.EulerNumber }, { "Loops", static_cast<double>(pasted.Landings.size()) },
    { "NonManifold", kept.NonManifold }, { "Soup", pasted.IsOnSoup ? 1.0 : 0.0 },
    { "PointCloud", pasted.IsOfPoints ? 1.0 : 0.0 }, { "Spacing", pasted.Spacing },
    { "AddedPoints", pasted.AddedPoints }, { "EstimatedNormals", areEstimated ? 1.0 : 0.0 },
    { "LargestGap", pasted.LargestGap }, { "JoinedShare", pasted.JoinedShare },
    { "WeldedPoints", kept.Feature.WeldedPoints + kept.Target.WeldedPoints }
  };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("PasteFeature.") + fact, value);
  }
  vtkShapeConvert::AddFact(output, "PasteFeature.Layout", NameOf(layout));
  vtkShapeConvert::AddFact(output, "PasteFeature.Refused", 0.0);
  vtkShapeConvert::AddFact(
    output, "PasteFeature.Base", kept.HasOwnFill ? "own fill" : "where it was cut");
}
