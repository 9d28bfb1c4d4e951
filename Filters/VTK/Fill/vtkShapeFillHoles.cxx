#include "vtkShapeFillHoles.h"

#include "vtkShapeCloud.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFilledData.h"
#include "vtkShapePreciseMap.h"

#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Fill/CloudHoles.h"
#include "Fill/CurveNetwork.h"
#include "Geometry/SampledSurface.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

vtkStandardNewMacro(vtkShapeFillHoles);

/// The data that depend on the input and the choice of loops, and the last values of both.
struct vtkShapeFillHoles::Kept
{
  shape::NumberedSurface Surface;
  shape::BoundaryLoops Border;   ///< of polygons
  shape::CurveNetwork Curves;    ///< of lines, if there are no polygons
  shape::SampledSurface Samples; ///< of a point cloud, if there are neither
  shape::CloudBoundary Cloud;
  std::vector<int> Chosen; ///< indices of loops or rims
  shape::HoleFillerOptions Options;
  std::unique_ptr<shape::SurfaceFiller> Filler;
};

vtkShapeFillHoles::vtkShapeFillHoles()
  : Cache(std::make_unique<Kept>())
{
  this->DeclareInput("Input", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareShown(0, { "Filled" });
  this->DeclareMeasures({ "Normals" });
}

vtkShapeFillHoles::~vtkShapeFillHoles() = default;

void vtkShapeFillHoles::SetNumberOfLoopIndices(int count)
{
  if (static_cast<std::size_t>(std::max(count, 0)) != this->Choice.Indices.size())
  {
    this->Choice.Indices.resize(static_cast<std::size_t>(std::max(count, 0)), 0);
    this->Modified();
  }
}

void vtkShapeFillHoles::SetLoopIndices(int index, int loop)
{
  if (index < 0)
  {
    vtkErrorMacro(<< this->GetLabel() << ": Loop Indices has no index " << index
                  << "; use an index from 0");
    return;
  }
  const auto position = static_cast<std::size_t>(index);
  this->Choice.Indices.resize(std::max(this->Choice.Indices.size(), position + 1), 0);
  this->Choice.Indices[position] = loop;
  this->Modified();
}

namespace
{

bool AreSame(const shape::Mesh& a, const shape::Mesh& b)
{
  return a.Points.rows() == b.Points.rows() && a.Triangles.rows() == b.Triangles.rows() &&
    a.Points == b.Points && a.Triangles == b.Triangles;
}

bool AreSame(const shape::HoleFillerOptions& a, const shape::HoleFillerOptions& b)
{
  const auto all = [](const shape::HoleFillerOptions& options)
  { return std::tie(options.OptimizeNormals, options.EdgeGrowth, options.MaximumPoints); };
  return all(a) == all(b);
}

/// Points, and no lines that say where the holes are.
bool IsCloud(vtkPolyData* data)
{
  return vtkShapeCloud::IsPointCloud(data) && data->GetNumberOfLines() == 0;
}

shape::CurveNetwork ToCurveNetwork(vtkPolyData* data)
{
  const std::vector<std::vector<int>> lines = vtkShapeConvert::ToLines(data);
  if (lines.empty())
  {
    throw shape::InvalidInput("the Input has neither triangles with three different points nor "
                              "lines; connect a surface, closed polylines around the holes, or "
                              "points alone");
  }
  vtkDataArray* normals = data->GetPointData()->GetNormals();
  const bool hasNormals = normals || data->GetPointData()->HasArray("Normals");
  return shape::FindCurveLoops(vtkShapeConvert::ToPoints(data), lines,
    hasNormals ? vtkShapeConvert::ToPointArray(data,
                   normals && normals->GetName() ? normals->GetName() : "Normals", 3, "the Input")
               : Eigen::MatrixXd(0, 3));
}

} // namespace

void vtkShapeFillHoles::Prepare(const shape::Progress& progress)
{
  vtkPolyData* data = this->GetGatheredInput(0).Data;
  Kept fresh;
  fresh.Surface = vtkShapePreciseMap::ToSurface(data, "the Input");
  const shape::Mesh& surface = fresh.Surface.Surface;
  shape::RequireFinite(surface.Points, "the Input");
  shape::RequireExtent(surface, "the Input");
  progress(0.2);
  if (IsCloud(data))
  {
    fresh.Samples = vtkShapeCloud::Connect(data, progress.Part(0.2, 0.5));
    fresh.Cloud = shape::FindCloudBoundary(fresh.Samples, progress.Part(0.5, 0.6));
    fresh.Chosen = shape::ChooseLoops(surface.Points, fresh.Cloud.Holes, this->Choice);
  }
  else if (surface.Triangles.rows() == 0)
  {
    fresh.Curves = ToCurveNetwork(data);
    fresh.Chosen = shape::ChooseLoops(surface.Points, fresh.Curves.Loops, this->Choice);
  }
  else
  {
    fresh.Border = shape::FindBoundaryLoops(surface);
    fresh.Chosen = shape::ChooseLoops(surface.Points, fresh.Border.Loops, this->Choice);
  }
  progress(0.6);
  Kept& kept = *this->Cache;
  // The prepared fills are kept as long as geometry, loops and sizes are the same: deformation
  // parameters then change in real time.
  const bool isSame = kept.Filler && AreSame(surface, kept.Surface.Surface) &&
    fresh.Chosen == kept.Chosen && AreSame(this->Fill.Filler, kept.Options) &&
    fresh.Curves.Loops == kept.Curves.Loops &&
    fresh.Curves.Normals.rows() == kept.Curves.Normals.rows() &&
    fresh.Curves.Normals == kept.Curves.Normals && fresh.Cloud.Holes == kept.Cloud.Holes &&
    fresh.Samples.Normals.rows() == kept.Samples.Normals.rows() &&
    fresh.Samples.Normals == kept.Samples.Normals;
  if (!isSame)
  {
    const std::vector<std::vector<int>>& all = IsCloud(data) ? fresh.Cloud.Holes
      : surface.Triangles.rows() == 0                        ? fresh.Curves.Loops
                                                             : fresh.Border.Loops;
    std::vector<std::vector<int>> loops;
    for (const int loop : fresh.Chosen)
    {
      loops.push_back(all[loop]);
    }
    fresh.Options = this->Fill.Filler;
    fresh.Filler = surface.Triangles.rows() > 0
      ? std::make_unique<shape::SurfaceFiller>(surface, loops, this->Fill.Filler)
      : std::make_unique<shape::SurfaceFiller>(surface, loops,
          IsCloud(data) ? fresh.Samples.Normals : fresh.Curves.Normals, this->Fill.Filler);
    kept = std::move(fresh);
  }
  else
  {
    kept.Surface = std::move(fresh.Surface); // its cells may be numbered differently
  }
  progress(1.0);
}

// 1. Find and choose the loops; reuse the prepared fills if these are the same (Prepare).
// 2. Fill the holes.
// 3. Write geometry, data and facts (vtkShapeFilledData).
void vtkShapeFillHoles::Execute(const shape::Progress& progress)
{
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  this->Prepare(progress.Part(0.0, 0.1));
  this->Fill.Deformation = this->Options;
  this->Fill.Frames = this->Frames;
  const Kept& kept = *this->Cache;
  const shape::FilledSurface filled = kept.Filler->Fill(this->Fill, progress.Part(0.1, 0.9));
  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  vtkPolyData* input = this->GetGatheredInput(0).Data;
  const bool isCloud = IsCloud(input);
  if (isCloud)
  {
    vtkShapeFilledData::WriteCloud(filled, kept.Samples.Normals, input, output);
  }
  else
  {
    vtkShapeFilledData::Write(filled, kept.Surface, input, output);
  }
  const int copies =
    this->SplitSheets && !isCloud ? vtkShapeFilledData::Split(filled, kept.Surface, output) : 0;
  if (copies > 0)
  {
    this->Warn(std::to_string(copies) +
      " copies of points were added where sheets of the surface touch: each sheet has its own now; "
      "see Split Sheets");
  }
  if (kept.Border.UnclosedSides > 0)
  {
    this->Warn(std::to_string(kept.Border.UnclosedSides) +
      " boundary edges are in no closed loop and stay open; repair the surface with Shape "
      "Solidify, or remove the triangles there");
  }
  progress(0.95);
  const std::size_t loops =
    kept.Curves.Loops.size() + kept.Border.Loops.size() + kept.Cloud.Holes.size();
  const std::pair<const char*, double> facts[] = { { "Loops", static_cast<double>(loops) },
    { "OuterLoops", static_cast<double>(kept.Cloud.Outer.size()) },
    { "PointCloud", isCloud ? 1.0 : 0.0 },
    { "EstimatedNormals", isCloud && !vtkShapeCloud::HasNormals(input) ? 1.0 : 0.0 },
    { "UnclosedSides", kept.Border.UnclosedSides }, { "LooseSegments", kept.Curves.LooseSegments },
    { "SkippedFaces", kept.Curves.SkippedFaces }, { "CopiedPoints", copies } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("FillHoles.") + fact, value);
  }
  vtkShapeFilledData::AddFacts(filled, kept.Chosen, output);
}
