#include "vtkShapeCutFeature.h"

#include "vtkShapeCarry.h"
#include "vtkShapeCloud.h"
#include "vtkShapeConvert.h"
#include "vtkShapeCutCloud.h"
#include "vtkShapeCutParts.h"
#include "vtkShapeGather.h"
#include "vtkShapeList.h"
#include "vtkShapePreciseMap.h"
#include "vtkShapeRepair.h"
#include "vtkShapeSeenInput.h"
#include "vtkShapeSelectedCells.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "CutPaste/CutPoints.h"
#include "Geodesics/SurfaceLoop.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkShapeCutFeature);

/// The data that depend on the input only, and the last outputs before a refusal.
struct vtkShapeCutFeature::Kept
{
  vtkShapeSeenInput Input;
  shape::NumberedSurface Numbered;
  std::unique_ptr<shape::FeatureCutter> Cutter;
  std::unique_ptr<shape::PointCutter> PointCutter; ///< instead of Cutter, for a point cloud
  vtkNew<vtkPolyData> LastFeature, LastRest;
};

vtkShapeCutFeature::vtkShapeCutFeature()
  : Cache(std::make_unique<Kept>())
{
  this->DeclareInput("Input", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Loop", PortData::WholePolygons, PortUse::Optional, { "vtkPolyData" });
  this->DeclareInput(
    "Selection", PortData::Selection, PortUse::Optional, { "vtkSelection", "vtkDataSet" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts(
    { { 0, { "Seed", "SeedNormal", "SeedDirection", "ConformalRadius", "Refined" } } });
  this->DeclareMeasures({ "Normals" });
}

vtkShapeCutFeature::~vtkShapeCutFeature() = default;

void vtkShapeCutFeature::SetNumberOfLoopPoints(int count)
{
  vtkShapeList::Resize(this, this->LoopPoints, count, 3);
}

void vtkShapeCutFeature::SetLoopPoints(int index, double x, double y, double z)
{
  vtkShapeList::Set(this, "Loop Points", this->LoopPoints, index, { x, y, z });
}

namespace
{

std::vector<Eigen::MatrixXd> ToCurves(vtkPolyData* loop)
{
  const std::vector<std::vector<int>> lines = vtkShapeConvert::ToLines(loop);
  if (lines.empty())
  {
    throw shape::InvalidInput("the Loop has no lines; connect a closed polyline");
  }
  const Eigen::MatrixXd points = vtkShapeConvert::ToPoints(loop);
  shape::RequireFinite(points, "the Loop");
  return shape::ChainClosedCurves(points, lines, "the Loop");
}

std::vector<char> SelectedTriangles(vtkPolyData* marked, const Eigen::VectorXi& cells)
{
  vtkDataArray* marks = marked->GetCellData()->GetArray(vtkShapeSelectedCells::Name.c_str());
  std::vector<char> isSelected;
  for (const int cell : cells)
  {
    isSelected.push_back(static_cast<char>(marks->GetComponent(cell, 0) != 0.0));
  }
  return isSelected;
}

} // namespace

/// An invalid loop must not empty the view during a drag. The last result stays, and the reason is
/// added as a fact.
void vtkShapeCutFeature::Execute(const shape::Progress& progress)
{
  vtkSmartPointer<vtkPolyData> marked;
  if (this->GetNumberOfInputConnections(2) > 0)
  {
    vtkSmartPointer<vtkDataObject> own;
    vtkShapeGather::RunOnAllOrFail(this->GetController(),
      [&]
      {
        own = vtkShapeSelectedCells::Mark(
          this->GetInputDataObject(0, 0), this->GetInputDataObject(2, 0), this->GetController());
      });
    std::vector<int> ownPoints;
    // The marks of all processes, gathered like the Input itself, so that cells have the same
    // order.
    marked = vtkShapeGather::Gather(
      own, "Input", vtkShapeGather::Joined::Coincident, this->GetController(), ownPoints);
  }
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  std::string refusal;
  try
  {
    this->Cut(marked, progress);
  }
  catch (const std::runtime_error& error)
  {
    if (!this->Dragging)
    {
      throw;
    }
    refusal = error.what();
    this->GetOutputDataObject(0)->ShallowCopy(this->Cache->LastFeature);
    this->GetOutputDataObject(1)->ShallowCopy(this->Cache->LastRest);
  }
  for (const int port : { 0, 1 })
  {
    vtkDataObject* output = this->GetOutputDataObject(port);
    vtkShapeConvert::AddFact(output, "CutFeature.Refused", refusal.empty() ? 0.0 : 1.0);
    if (!refusal.empty())
    {
      vtkShapeConvert::AddFact(output, "CutFeature.Refusal", refusal);
    }
  }
}

/// marked: the Input with its selected cells, or nullptr.
void vtkShapeCutFeature::Cut(vtkPolyData* marked, const shape::Progress& progress)
{
  const bool hasLoop = this->GetNumberOfInputConnections(1) > 0;
  const auto loopPoints = static_cast<Eigen::Index>(this->LoopPoints.size() / 3);
  if (hasLoop && this->GetNumberOfInputConnections(2) > 0)
  {
    throw shape::InvalidInput("both Loop and Selection are connected; disconnect one of them");
  }
  if (!hasLoop && !marked && loopPoints < 3)
  {
    throw shape::InvalidInput("press Draw Loop, or connect a polyline to Loop or a selection to "
                              "Selection: there is no loop "
                              "(Loop Points has " +
      std::to_string(loopPoints) + " positions, and needs at least 3)");
  }
  const GatheredInput& input = this->GetGatheredInput(0);
  vtkPolyData* surface = input.Data;
  Kept& kept = *this->Cache;
  const bool isCloud = vtkShapeCloud::IsPointCloud(surface);
  // A new loop on the same surface uses the stored search structures.
  if (kept.Input.IsNew(*this, 0, surface) || !(isCloud ? !!kept.PointCutter : !!kept.Cutter))
  {
    kept.Cutter.reset();
    kept.PointCutter.reset();
    kept.LastFeature->Initialize();
    kept.LastRest->Initialize();
    this->Prepare(isCloud, progress.Part(0.0, 0.1, "preparing the surface"));
  }
  auto* feature = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  auto* rest = vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
  const FactWriter addFacts = isCloud ? this->CutCloud(marked, progress.Part(0.1, 1.0))
                                      : this->CutSurface(marked, progress.Part(0.1, 1.0));
  for (vtkPolyData* part : { feature, rest })
  {
    vtkShapeCarry::RenumberOriginals(input.GivenPoints, part->GetPointData());
  }
  if (this->KeepOriginal)
  {
    auto* own = vtkPolyData::SafeDownCast(this->GetInputDataObject(0, 0));
    const bool isAlone =
      !this->GetController() || this->GetController()->GetNumberOfProcesses() == 1;
    // The input itself keeps all arrays and cells. The gathered input replaces composite and
    // distributed data.
    rest->ShallowCopy(own && isAlone ? own : input.Given.Get());
  }
  addFacts(feature);
  addFacts(rest);
  kept.LastFeature->ShallowCopy(feature);
  kept.LastRest->ShallowCopy(rest);
}

void vtkShapeCutFeature::Prepare(bool isCloud, const shape::Progress& progress)
{
  Kept& kept = *this->Cache;
  vtkPolyData* surface = this->GetGatheredInput(0).Data;
  if (isCloud)
  {
    kept.PointCutter = std::make_unique<shape::PointCutter>(
      vtkShapeCloud::Connect(surface, progress.Part(0.0, 0.7)), progress.Part(0.7, 1.0));
    return;
  }
  kept.Numbered = vtkShapePreciseMap::ToSurface(surface, "the Input");
  kept.Cutter = std::make_unique<shape::FeatureCutter>(kept.Numbered.Surface, progress);
}

std::vector<Eigen::MatrixXd> vtkShapeCutFeature::ReadCurves()
{
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    return ToCurves(this->GetGatheredInput(1).Data);
  }
  using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
  const auto count = static_cast<Eigen::Index>(this->LoopPoints.size() / 3);
  return { Eigen::Map<const Positions>(this->LoopPoints.data(), count, 3) };
}

vtkShapeCutFeature::FactWriter vtkShapeCutFeature::CutSurface(
  vtkPolyData* marked, const shape::Progress& progress)
{
  Kept& kept = *this->Cache;
  const GatheredInput& input = this->GetGatheredInput(0);
  shape::CutFeatureOptions options = this->Options;
  // Filling is too slow for a step of a drag. The hole is filled when the mouse button is released.
  options.FillHole = options.FillHole && !this->Dragging;
  const shape::CutFeatureResult cut = marked
    ? kept.Cutter->Cut(
        SelectedTriangles(marked, vtkShapeRepaired::ToGiven(input.GivenCells, kept.Numbered.Cells)),
        options, progress)
    : kept.Cutter->Cut(this->ReadCurves(), options, progress);
  vtkShapeCutParts::Write(cut, kept.Numbered, input.Data,
    vtkPolyData::SafeDownCast(this->GetOutputDataObject(0)),
    vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
  return [cut](vtkPolyData* output) { vtkShapeCutParts::AddFacts(cut, output); };
}

vtkShapeCutFeature::FactWriter vtkShapeCutFeature::CutCloud(
  vtkPolyData* marked, const shape::Progress& progress)
{
  if (marked)
  {
    throw shape::InvalidInput("the Input is a point cloud, which is cut along a loop: selected "
                              "points have no ordered boundary; draw Loop Points around them");
  }
  const std::vector<Eigen::MatrixXd> curves = this->ReadCurves();
  const auto count = static_cast<int>(curves.size());
  const int index = this->Options.LoopIndex == -1 && count == 1 ? 0 : this->Options.LoopIndex;
  if (index < 0 || index >= count)
  {
    throw shape::InvalidInput("the Input is a point cloud, which is cut along one loop, but there "
                              "are " +
      std::to_string(count) + " and Loop Index is " + std::to_string(index) +
      "; set Loop Index to one of them, numbered from 0");
  }
  Kept& kept = *this->Cache;
  vtkPolyData* cloud = this->GetGatheredInput(0).Data;
  const shape::CutPointsOptions options{ this->Options.Side,
    this->Options.FillHole && !this->Dragging, this->Options.Fill };
  const shape::CutPointsResult cut = kept.PointCutter->Cut(curves[index], options, progress);
  vtkShapeCutCloud::Write(cut, kept.PointCutter->Sampled(), cloud,
    vtkPolyData::SafeDownCast(this->GetOutputDataObject(0)),
    vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
  return
    [cut, spacing = kept.PointCutter->Spacing(), isEstimated = !vtkShapeCloud::HasNormals(cloud)](
      vtkPolyData* output) { vtkShapeCutCloud::AddFacts(cut, spacing, isEstimated, output); };
}
