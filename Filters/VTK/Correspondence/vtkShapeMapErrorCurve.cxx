#include "vtkShapeMapErrorCurve.h"

#include "vtkShapeConvert.h"

#include "vtkDoubleArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

vtkStandardNewMacro(vtkShapeMapErrorCurve);

vtkShapeMapErrorCurve::vtkShapeMapErrorCurve()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Target", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Truth", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareOutput("vtkTable");
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareFacts();
}

void vtkShapeMapErrorCurve::Execute(const shape::Progress& progress)
{
  vtkPolyData* source = this->GetGatheredInput(0).Data;
  vtkPolyData* goal = this->GetGatheredInput(1).Data;
  vtkUnstructuredGrid* positions = this->GetGatheredInput(2).Grid;
  const shape::Surface input = vtkShapeConvert::ToMesh(source, "the Input");
  const shape::Surface target = vtkShapeConvert::ToMesh(goal, "the Target");
  const Eigen::MatrixXd map = vtkShapeConvert::ToPointArray(source, this->MapArray, 3, "the Input");
  shape::GroundTruth truth;
  truth.Positions = vtkShapeConvert::ToPoints(positions);
  truth.Targets = vtkShapeConvert::ToPointArray(positions, this->MapArray, 3, "the Truth");
  if (positions->GetPointData()->HasArray(this->SymmetryArray.c_str()))
  {
    truth.Mirrored = vtkShapeConvert::ToPointArray(positions, this->SymmetryArray, 3, "the Truth");
  }

  // If the target has the map array, too, it is the map back, and the round trip is measured.
  const bool hasBack = goal->GetPointData()->HasArray(this->MapArray.c_str());
  const shape::MapErrorCurveResult result = shape::ComputeMapErrorCurve(
    input, map, target, truth, this->Options, progress.Part(0.0, hasBack ? 0.7 : 0.9));
  auto* output = vtkTable::SafeDownCast(this->GetOutputDataObject(0));
  const auto add = [&](const std::string& fact, double value)
  { vtkShapeConvert::AddFact(output, "MapErrorCurve." + fact, value); };
  add("Mean", result.Mean);
  add("Median", result.Median);
  add("Percentile95", result.Percentile95);
  add("Maximum", result.Maximum);
  add("AreaUnderCurve", result.AreaUnderCurve);
  add("Unit", result.Unit);
  add("Mirrored", result.Mirrored ? 1.0 : 0.0);
  add("UnreachedPlaces", result.Unreached);
  add("LargestGap", result.LargestGap);
  add("Coverage",
    shape::ComputeCoverage(
      input, map, target, progress.Part(hasBack ? 0.7 : 0.9, hasBack ? 0.75 : 1.0)));
  if (hasBack)
  {
    const Eigen::MatrixXd back =
      vtkShapeConvert::ToPointArray(goal, this->MapArray, 3, "the Target");
    const Eigen::VectorXd trips =
      shape::ComputeRoundTripErrors(input, map, target, back, progress.Part(0.75, 1.0));
    add("RoundTripMean", trips.size() > 0 ? trips.mean() : 0.0);
    add("RoundTripMaximum", trips.size() > 0 ? trips.maxCoeff() : 0.0);
  }
  // Every process has the same errors, and one of them outputs them.
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    output->AddColumn(vtkShapeConvert::ToArray(result.Errors, "Error"));
    output->AddColumn(vtkShapeConvert::ToArray(result.Shares, "Share"));
    auto* errors = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(1));
    errors->ShallowCopy(positions);
    errors->GetPointData()->AddArray(vtkShapeConvert::ToArray(result.PositionErrors, "Error"));
  }
}
