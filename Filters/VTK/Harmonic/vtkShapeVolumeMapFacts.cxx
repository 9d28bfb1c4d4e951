#include "vtkShapeVolumeMapFacts.h"

#include "vtkShapeConvert.h"

#include "vtkDataObject.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkTable.h"

#include <string>
#include <utility>

namespace
{

std::string Fact(const std::string& name)
{
  return vtkShapeVolumeMapFacts::Prefix + name;
}

const char* Word(shape::HarmonicVolumeMapOptions::MethodType method)
{
  switch (method)
  {
    case shape::HarmonicVolumeMapOptions::MethodType::SingleShot:
      return "SingleShot";
    case shape::HarmonicVolumeMapOptions::MethodType::MultiLevel:
      return "MultiLevel";
    case shape::HarmonicVolumeMapOptions::MethodType::FiniteElements:
      return "FiniteElements";
    case shape::HarmonicVolumeMapOptions::MethodType::Accelerated:
      break;
  }
  return "Accelerated";
}

const char* Word(shape::HarmonicVolumeMapResult::Stop reason)
{
  switch (reason)
  {
    case shape::HarmonicVolumeMapResult::Stop::Tolerance:
      return "Tolerance";
    case shape::HarmonicVolumeMapResult::Stop::NoImprovement:
      return "NoImprovement";
    case shape::HarmonicVolumeMapResult::Stop::Refinement:
      return "Refinement";
    case shape::HarmonicVolumeMapResult::Stop::Levels:
      break;
  }
  return "Levels";
}

/// Adds the errors at the boundaries of the regions, an entry for each region.
void AddBorders(
  const std::vector<shape::PiecewiseVolumeMapResult::Border>& boundaries, vtkDataObject* output)
{
  Eigen::MatrixXd columns(boundaries.size(), 5);
  for (std::size_t i = 0; i < boundaries.size(); ++i)
  {
    columns.row(i) << boundaries[i].RMSEVertices, boundaries[i].RMSEInside, boundaries[i].Maximum,
      boundaries[i].JumpRMS, boundaries[i].JumpMaximum;
  }
  const char* names[] = { "BorderRMSEVertices", "BorderRMSEInside", "BorderMaximum",
    "BorderJumpRMS", "BorderJumpMaximum" };
  for (int c = 0; c < columns.cols(); ++c)
  {
    output->GetAttributesAsFieldData(vtkDataObject::FIELD)
      ->AddArray(vtkShapeConvert::ToArray(columns.col(c), Fact(names[c])));
  }
}

} // namespace

void vtkShapeVolumeMapFacts::WriteLevels(
  const std::vector<shape::HarmonicVolumeMapResult>& regions, vtkTable* output)
{
  Eigen::MatrixXd columns(0, 10);
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    for (const auto& level : regions[region].Levels)
    {
      columns.conservativeResize(columns.rows() + 1, Eigen::NoChange);
      columns.bottomRows<1>() << level.Number, level.Sources, level.Collocations,
        level.RMSEVertices, level.RMSEInside, level.Maximum, level.Seconds, level.Kept,
        static_cast<double>(region), level.RMSECollocations;
    }
  }
  const char* names[] = { "Level", "Sources", "Collocations", "RMSEVertices", "RMSEInside",
    "Maximum", "Seconds", "Kept", "RegionId", "RMSECollocations" };
  for (int c = 0; c < columns.cols(); ++c)
  {
    output->AddColumn(vtkShapeConvert::ToArray(columns.col(c), names[c]));
  }
}

void vtkShapeVolumeMapFacts::AddFacts(const shape::PiecewiseVolumeMapResult& result,
  shape::HarmonicVolumeMapOptions::MethodType method, bool boundaries, vtkDataObject* output)
{
  using Stop = shape::HarmonicVolumeMapResult::Stop;
  const auto& boundary = result.Borders.front();
  double deleted = 0.0, inserted = 0.0, iterations = 0.0, refined = 0.0, without = 0.0;
  Stop reason = Stop::Tolerance;
  for (const shape::HarmonicVolumeMapResult& layer : result.Layers)
  {
    deleted += layer.DeletedSources;
    inserted += layer.InsertedSources;
    iterations += layer.Iterations;
    refined += layer.RefinedPoints;
    without += layer.PointsWithoutCharge;
    // The tolerance counts as reached only if all layers reached it.
    reason = layer.Reason == Stop::Tolerance ? reason : layer.Reason;
  }
  const std::pair<const char*, double> facts[] = { { "RMSEVertices", boundary.RMSEVertices },
    { "RMSEInside", boundary.RMSEInside }, { "Maximum", boundary.Maximum },
    { "RMSEFeatures", result.RMSEFeatures }, { "OffsetDistance", result.OffsetDistance },
    { "DeletedSources", deleted }, { "InsertedSources", inserted }, { "Iterations", iterations },
    { "RefinedPoints", refined }, { "PointsWithoutCharge", without } };
  for (const auto& [name, value] : facts)
  {
    vtkShapeConvert::AddFact(output, Fact(name), value);
  }
  vtkShapeConvert::AddFact(output, Fact("Method"), Word(method));
  vtkShapeConvert::AddFact(output, Fact("Stop"), Word(reason));
  if (boundaries)
  {
    AddBorders(result.Borders, output);
  }
}
