#include "vtkShapeRegisterVolume.h"

#include "vtkShapeCarry.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <sstream>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkShapeRegisterVolume);

vtkShapeRegisterVolume::vtkShapeRegisterVolume()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Target", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareFacts();
}

namespace
{

/// Adds the facts about a quality; `when` is Before or After.
void AddQuality(
  const shape::RegistrationQuality& quality, const std::string& when, vtkDataObject* output)
{
  const std::pair<const char*, double> facts[] = {
    { "MeanDistance", quality.MeanDistance },
    { "MaximumDistance", quality.MaximumDistance },
    { "Distortion", quality.Distortion },
  };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("RegisterVolume.") + fact + when, value);
  }
}

void WriteSolid(const shape::RegisterVolumeResult& result, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(result.SolidTargets, "Points"));
  vtkNew<vtkCellArray> cells;
  for (const auto corners : result.Solid.Tetrahedra.rowwise())
  {
    cells->InsertNextCell({ corners(0), corners(1), corners(2), corners(3) });
  }
  output->SetPoints(points);
  output->SetCells(VTK_TETRA, cells);
}

} // namespace

// Every process computes the same result, and writes the rows of its own points.
void vtkShapeRegisterVolume::Execute(const shape::Progress& progress)
{
  const GatheredInput& input = this->GetGatheredInput(0);
  const shape::Surface boundary = vtkShapeConvert::ToMesh(input.Data, "the Input");
  const shape::Surface target =
    vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "the Target");
  const shape::RegisterVolumeResult result =
    shape::RegisterVolume(boundary, target, this->Options, progress.Part(0.0, 0.98));
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(0, 0), this->GetOutputDataObject(0),
    { { "TargetPosition", vtkShapeConvert::Rows(result.Targets, input.OwnPoints) } });
  constexpr double far = 0.05;
  if (result.After.MaximumDistance > far)
  {
    std::ostringstream words;
    words << "the image is up to " << result.After.MaximumDistance
          << " of the Target's size away from it; move the Input nearer to the Target, or lower "
             "Distortion Weight";
    this->Warn(words.str());
  }
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  auto* solid = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(1));
  WriteSolid(result, solid);
  const shape::Provenance provenance = shape::TraceClosestPositions(
    boundary, result.Solid, progress.Part(0.98, 1.0, "transferring the arrays"));
  vtkShapeCarry::Carry({ { input.Data, provenance } }, solid);
  vtkPointData* data = solid->GetPointData();
  vtkShapeCarry::AddOriginals(result.Solid.Provenance.Points, "OriginalPointId", data);
  vtkShapeCarry::RenumberOriginals(input.GivenPoints, data);
  data->AddArray(vtkShapeConvert::ToArray(result.Solid.Points, "SourcePosition"));
  AddQuality(result.Before, "Before", solid);
  AddQuality(result.After, "After", solid);
  vtkShapeConvert::AddFact(solid, "RegisterVolume.Iterations", result.Iterations);
  vtkShapeConvert::AddFact(
    solid, "RegisterVolume.Tetrahedra", static_cast<double>(result.Solid.Tetrahedra.rows()));
  progress(1.0);
}
