#include "vtkShapeCutParts.h"

#include "vtkShapeCarry.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFeatureBase.h"
#include "vtkShapeFillValues.h"

#include "vtkCellData.h"
#include "vtkIntArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Fill/FillHoles.h"

#include <string>
#include <utility>
#include <vector>

namespace
{

/// Writes a part of the surface and its fills, if it has any. Points on the cut get interpolated
/// values; points of a fill get harmonic values. A triangle gets the data of the cell that contains
/// it. A triangle of a fill gets the data of the nearest cell at the loop.
void WritePart(const shape::DividedPart& part, const std::vector<shape::FilledHole>& holes,
  const shape::NumberedSurface& numbered, vtkPolyData* surface, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh(part.Surface, output);
  shape::Provenance provenance = part.Provenance;
  provenance.Cells = shape::ComposeIndices(numbered.Cells, part.Provenance.Cells);
  vtkShapeCarry::Carry({ { surface, provenance } }, output);
  if (!holes.empty())
  {
    vtkShapeFillValues::Continue(part.Surface, holes, holes.front().FirstTriangle, output);
  }
  vtkShapeCarry::AddOriginals(provenance.Points, "OriginalPointId", output->GetPointData());
}

} // namespace

void vtkShapeCutParts::Write(const shape::CutFeatureResult& cut,
  const shape::NumberedSurface& numbered, vtkPolyData* surface, vtkPolyData* feature,
  vtkPolyData* rest)
{
  WritePart(cut.Feature, {}, numbered, surface, feature);
  vtkShapeFeatureBase::Write(cut.Bases, cut.Feature.Ids, cut.Gaps.Count > 0, feature);
  WritePart(cut.Rest, cut.Holes, numbered, surface, rest);
  Eigen::VectorXi filled = Eigen::VectorXi::Zero(cut.Rest.Surface.Triangles.rows());
  for (const shape::FilledHole& hole : cut.Holes)
  {
    filled.segment(hole.FirstTriangle, hole.Triangles).setOnes();
  }
  rest->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(filled, "Filled"));
}

void vtkShapeCutParts::AddFacts(const shape::CutFeatureResult& cut, vtkPolyData* output)
{
  const double area = 0.5 * shape::ComputeAreaVectors(cut.Feature.Surface).rowwise().norm().sum();
  const std::pair<const char*, double> facts[] = { { "Loops", cut.Loops },
    { "LoopsLeftOut", cut.LoopsLeftOut }, { "CutLength", cut.CutLength }, { "FeatureArea", area },
    { "Holes", static_cast<double>(cut.Holes.size()) }, { "WeldedPoints", cut.WeldedPoints },
    { "GapsCrossed", cut.Gaps.Count }, { "WidestGap", cut.Gaps.Widest } };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("CutFeature.") + fact, value);
  }
}
