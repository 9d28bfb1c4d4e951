#include "vtkShapeDeform.h"

#include "vtkShapeConvert.h"
#include "vtkShapeHandle.h"

#include "vtkObjectFactory.h"
#include "vtkUnstructuredGrid.h"

#include "Deform/Deform.h"

#include <string>
#include <utility>

vtkStandardNewMacro(vtkShapeDeform);

vtkShapeDeform::vtkShapeDeform()
  : Deformer(std::make_unique<shape::Deformer>())
{
  this->DeclareInput("Input", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Boundary", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareMovedOutput();
  this->DeclareFacts();
  this->DeclareMeasures({ "Normals", "ArrivalTime", "Protrusion" });
}

vtkShapeDeform::~vtkShapeDeform() = default;

void vtkShapeDeform::Execute(const shape::Progress& progress)
{
  vtkUnstructuredGrid* grid = this->GetGatheredInput(0).Grid;
  vtkShapeHandle::Boundary boundary = vtkShapeHandle::Read(this->GetGatheredInput(1).Grid);
  shape::DeformProblem problem;
  problem.Shape = vtkShapeHandle::ToElements(grid, "the Input", progress.Part(0.0, 0.1));
  problem.Handle = std::move(boundary.Source);
  problem.Fields = this->ReadFields(grid, "the Input");
  problem.Options = this->Options;
  const shape::DeformedShape deformed =
    this->Deformer->Deform(problem, boundary.Target, this->Frames, progress.Part(0.1, 0.95));

  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeHandle::Write(this->GetInputDataObject(0, 0), problem.Shape.Points, deformed, output);
  const shape::DeformFacts& facts = this->Deformer->Facts();
  const std::pair<const char*, double> all[] = { { "Islands", facts.Islands },
    { "EmptyBands", facts.EmptyBands }, { "ZeroWeights", facts.ZeroWeights },
    { "WeldedPoints", facts.WeldedPoints }, { "Segments", facts.Segments },
    { "BasePoints", facts.BasePoints }, { "Streamed", facts.Streamed ? 1.0 : 0.0 },
    { "Prepared", this->Deformer->HasPrepared() ? 1.0 : 0.0 } };
  for (const auto& [fact, value] : all)
  {
    vtkShapeConvert::AddFact(output, std::string("Deform.") + fact, value);
  }
}
