#include "vtkShapeSkeleton.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "Mesh/Extent.h"

#include <numeric>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeSkeleton);

vtkShapeSkeleton::vtkShapeSkeleton()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Target", PortData::WholeSurface, PortUse::Optional, { "vtkPolyData" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareShown(0, { "Radius" });
  this->DeclareMeasures({ "Radius" });
}

namespace
{

/// Returns the branches in the order of the cells: vertices come before lines.
std::vector<int> OrderCells(const shape::CurveSkeleton& skeleton)
{
  std::vector<int> order;
  for (const bool lines : { false, true })
  {
    for (std::size_t i = 0; i < skeleton.Branches.size(); ++i)
    {
      if ((skeleton.Branches[i].size() > 1) == lines)
      {
        order.push_back(static_cast<int>(i));
      }
    }
  }
  return order;
}

/// numbers: what BranchId says of each branch.
void WriteSkeleton(
  const shape::CurveSkeleton& skeleton, const std::vector<int>& numbers, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(skeleton.Points, "Points"));
  vtkNew<vtkCellArray> lines, vertices;
  vtkNew<vtkIntArray> ids;
  ids->SetName("BranchId");
  for (const int number : OrderCells(skeleton))
  {
    const std::vector<int>& branch = skeleton.Branches[number];
    vtkCellArray* cells = branch.size() > 1 ? lines : vertices;
    cells->InsertNextCell(static_cast<int>(branch.size()));
    for (const int point : branch)
    {
      cells->InsertCellPoint(point);
    }
    ids->InsertNextValue(numbers[number]);
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->SetLines(lines);
  output->GetCellData()->AddArray(ids);
  output->GetPointData()->AddArray(vtkShapeConvert::ToArray(skeleton.Radii, "Radius"));
  output->GetPointData()->AddArray(vtkShapeConvert::ToIntegers(skeleton.Degrees, "Degree"));
}

void WriteMatching(const shape::SkeletonMatching& matching, vtkPolyData* output)
{
  output->GetPointData()->AddArray(
    vtkShapeConvert::ToArray(matching.TargetPositions, "TargetPosition"));
  vtkNew<vtkIntArray> ids;
  ids->SetName("TargetBranchId");
  for (const int number : OrderCells(matching.Skeleton))
  {
    ids->InsertNextValue(matching.Branches[number]);
  }
  output->GetCellData()->AddArray(ids);
  vtkShapeConvert::AddFact(output, "Skeleton.Difference", matching.Difference);
  vtkShapeConvert::AddFact(
    output, "Skeleton.AmbiguousBranches", static_cast<double>(matching.Ambiguous.size()));
  vtkShapeConvert::AddFact(
    output, "Skeleton.LeftOut", static_cast<double>(matching.LeftOut.size()));
  vtkShapeConvert::AddFact(
    output, "Skeleton.TargetLeftOut", static_cast<double>(matching.TargetLeftOut.size()));
}

} // namespace

void vtkShapeSkeleton::Execute(const shape::Progress& progress)
{
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  shape::RequireMatchingOptions(this->Matching); // also without a Target
  const bool hasTarget = this->GetNumberOfInputConnections(1) > 0;
  const double share = hasTarget ? 0.48 : 1.0;
  const shape::Surface surface =
    vtkShapeConvert::ToMesh(this->GetGatheredInput(0).Data, "the Input");
  shape::CurveSkeleton skeleton =
    shape::ExtractCurveSkeleton(surface, this->Options, progress.Part(0.0, share));
  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  if (hasTarget)
  {
    const shape::Surface target =
      vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "the Target");
    // Both skeletons have edges of the same relative length.
    shape::CurveSkeletonOptions options = this->Options;
    options.Resolution *=
      shape::ComputeBoxDiagonal(target.AsMesh()) / shape::ComputeBoxDiagonal(surface.AsMesh());
    const shape::CurveSkeleton other =
      shape::ExtractCurveSkeleton(target, options, progress.Part(share, 2.0 * share));
    const shape::SkeletonMatching matching = shape::MatchSkeletons(
      skeleton, other, this->Matching, progress.Part(2.0 * share, 1.0, "matching the branches"));
    skeleton = matching.Skeleton;
    WriteSkeleton(skeleton, matching.Numbers, output);
    WriteMatching(matching, output);
  }
  else
  {
    std::vector<int> numbers(skeleton.Branches.size());
    std::iota(numbers.begin(), numbers.end(), 0);
    WriteSkeleton(skeleton, numbers, output);
  }
  if (skeleton.OutsidePoints > 0)
  {
    this->Warn(std::to_string(skeleton.OutsidePoints) +
      " points of the skeleton are not inside the surface; lower Resolution, or raise Medial "
      "Weight");
  }
  const std::pair<const char*, double> facts[] = { { "Points",
                                                     static_cast<double>(skeleton.Points.rows()) },
    { "Branches", static_cast<double>(skeleton.Branches.size()) },
    { "Junctions", static_cast<double>((skeleton.Degrees.array() > 2).count()) },
    { "Ends", static_cast<double>((skeleton.Degrees.array() == 1).count()) },
    { "Cycles", skeleton.Cycles }, { "Components", skeleton.Components },
    { "OutsidePoints", skeleton.OutsidePoints } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("Skeleton.") + fact, value);
  }
}
