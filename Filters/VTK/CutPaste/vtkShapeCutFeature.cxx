#include "vtkShapeCutFeature.h"

#include "vtkShapeCarry.h"
#include "vtkShapeComplete.h"
#include "vtkShapeConvert.h"
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
  vtkShapeComplete::RequireNoPointCloud(
    surface, "the Input", "a feature is cut along edges of polygons");
  Kept& kept = *this->Cache;
  // A new loop on the same surface uses the stored search structures.
  if (kept.Input.IsNew(*this, 0, surface) || !kept.Cutter)
  {
    kept.Cutter.reset();
    kept.LastFeature->Initialize();
    kept.LastRest->Initialize();
    kept.Numbered = vtkShapePreciseMap::ToSurface(surface, "the Input");
    kept.Cutter =
      std::make_unique<shape::FeatureCutter>(kept.Numbered.Surface, progress.Part(0.0, 0.1));
  }
  shape::CutFeatureOptions options = this->Options;
  // Filling is too slow for a step of a drag. The hole is filled when the mouse button is released.
  options.FillHole = options.FillHole && !this->Dragging;
  shape::CutFeatureResult cut;
  if (marked)
  {
    cut = kept.Cutter->Cut(
      SelectedTriangles(marked, vtkShapeRepaired::ToGiven(input.GivenCells, kept.Numbered.Cells)),
      options, progress.Part(0.1, 1.0));
  }
  else
  {
    using Positions = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
    std::vector<Eigen::MatrixXd> curves;
    if (hasLoop)
    {
      curves = ToCurves(this->GetGatheredInput(1).Data);
    }
    else
    {
      curves.emplace_back(Eigen::Map<const Positions>(this->LoopPoints.data(), loopPoints, 3));
    }
    cut = kept.Cutter->Cut(curves, options, progress.Part(0.1, 1.0));
  }

  auto* feature = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  auto* rest = vtkPolyData::SafeDownCast(this->GetOutputDataObject(1));
  vtkShapeCutParts::Write(cut, kept.Numbered, surface, feature, rest);
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
  vtkShapeCutParts::AddFacts(cut, feature);
  vtkShapeCutParts::AddFacts(cut, rest);
  kept.LastFeature->ShallowCopy(feature);
  kept.LastRest->ShallowCopy(rest);
}
