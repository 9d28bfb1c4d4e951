#include "vtkShapeMeshMotion.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Mesh/FaceMesh.h"
#include "Mesh/Topology.h"
#include "Quality/SolidQuality.h"
#include "Search/RowFinder.h"

#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeMeshMotion);

vtkShapeMeshMotion::vtkShapeMeshMotion()
{
  this->DeclareInput("Input", PortData::WholeGrid, PortUse::Required,
    { "vtkUnstructuredGrid", "vtkStructuredGrid", "vtkRectilinearGrid", "vtkImageData" });
  this->DeclareInput(
    "Boundary", PortData::Whole, PortUse::Required, { "vtkPolyData", "vtkUnstructuredGrid" });
  this->DeclareOutput("vtkUnstructuredGrid");
  this->DeclareFacts();
  this->DeclareMeasures({ "ScaledJacobian", "NonOrthogonality", "Skewness", "Inverted" });
  this->DeclareShown(0, { "ScaledJacobian" });
}

namespace
{

/// Returns the faces of each polyhedron, in the form of shape::BuildFaceMesh.
std::vector<std::vector<int>> ReadPolyhedra(vtkUnstructuredGrid* grid)
{
  std::vector<std::vector<int>> polyhedra;
  vtkNew<vtkIdList> stream;
  for (vtkIdType cell = 0; cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_POLYHEDRON)
    {
      grid->GetFaceStream(cell, stream);
      // The number of faces comes first.
      polyhedra.emplace_back(stream->begin() + 1, stream->end());
    }
  }
  return polyhedra;
}

/// Adds the facts about a quality; `when` is Before or After.
void AddQuality(const shape::SolidQuality& quality, const std::string& when, vtkDataObject* output)
{
  const std::pair<const char*, double> facts[] = {
    { "Inverted", quality.Inverted.sum() },
    { "MinimumScaledJacobian", quality.ScaledJacobian.minCoeff() },
    { "MaximumNonOrthogonality", quality.NonOrthogonality.maxCoeff() },
    { "MeanNonOrthogonality", quality.NonOrthogonality.mean() },
    { "MaximumSkewness", quality.Skewness.maxCoeff() },
  };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("MeshMotion.") + fact + when, value);
  }
}

} // namespace

void vtkShapeMeshMotion::Execute(const shape::Progress& progress)
{
  vtkShapeComposite::RequireDataSets(this->GetInputDataObject(0, 0));
  // Every process has the complete input, and one of them computes the result.
  vtkMultiProcessController* controller = this->GetController();
  if (controller && controller->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkUnstructuredGrid* input = this->GetGatheredInput(0).Grid;
  shape::Cells cells = vtkShapeConvert::ToCells(input, "the Input");
  vtkShapeConvert::ReorderVoxels(cells);
  shape::RequireFinite(cells.Points, "the Input");
  std::vector<std::vector<int>> polyhedra = ReadPolyhedra(input);
  shape::Cells connected = cells;
  // Coincident points of different pieces are one. Within one data set, they may belong to faces
  // that are separate on purpose.
  const bool hasPieces = (controller && controller->GetNumberOfProcesses() > 1) ||
    vtkCompositeDataSet::SafeDownCast(this->GetInputDataObject(0, 0));
  if (hasPieces)
  {
    const std::vector<int> first = shape::RowFinder(cells.Points).Find(cells.Points);
    for (int& corner : connected.Corners)
    {
      corner = first[corner];
    }
    for (std::vector<int>& stream : polyhedra)
    {
      for (std::size_t k = 0; k < stream.size(); k += stream[k] + 1)
      {
        for (int corner = 1; corner <= stream[k]; ++corner)
        {
          stream[k + corner] = first[stream[k + corner]];
        }
      }
    }
  }
  progress(0.02);
  const shape::FaceMesh faces = shape::BuildFaceMesh(connected, polyhedra);
  const Eigen::MatrixXi boundary = shape::TriangulateBoundary(faces);
  progress(0.08);

  vtkPolyData* given = this->GetGatheredInput(1).Data;
  const shape::Surface surface = vtkShapeConvert::ToMesh(given, "the Boundary");
  const Eigen::MatrixXd images =
    vtkShapeConvert::ToPointArray(given, this->MapArray, 3, "the Boundary");
  shape::RequireFinite(images, "the map array of the Boundary");
  const shape::BoundaryMotion motion = shape::FindBoundaryMotion(cells.Points, boundary, surface,
    images, this->Options.MatchTolerance, progress.Part(0.08, 0.15, "matching the boundary"));
  const shape::SolidQuality before = shape::ComputeSolidQuality(connected, faces);
  progress(0.2);
  const shape::MeshMotionResult result = shape::MoveMesh(cells.Points, boundary,
    motion.Displacements, this->Options, progress.Part(0.2, 0.9, "moving the mesh"));
  connected.Points = result.Points;
  const shape::SolidQuality after = shape::ComputeSolidQuality(connected, faces);
  progress(0.95);

  auto* output = vtkUnstructuredGrid::SafeDownCast(this->GetOutputDataObject(0));
  output->ShallowCopy(input);
  vtkNew<vtkPoints> points;
  points->SetData(vtkShapeConvert::ToArray(result.Points, "Points"));
  output->SetPoints(points);
  output->GetPointData()->AddArray(vtkShapeConvert::ToArray(cells.Points, "SourcePosition"));
  vtkCellData* data = output->GetCellData();
  data->AddArray(vtkShapeConvert::ToArray(after.ScaledJacobian, "ScaledJacobian"));
  data->AddArray(vtkShapeConvert::ToArray(after.NonOrthogonality, "NonOrthogonality"));
  data->AddArray(vtkShapeConvert::ToArray(after.Skewness, "Skewness"));
  data->AddArray(vtkShapeConvert::ToIntegers(after.Inverted, "Inverted"));

  const std::pair<const char*, double> facts[] = {
    { "MovingPoints", motion.Moving },
    { "FixedPoints", motion.Fixed },
    { "UnmatchedPoints", motion.Unmatched },
    { "Centres", result.Centres },
    { "BoundaryError", result.BoundaryError },
  };
  for (const auto& [fact, value] : facts)
  {
    vtkShapeConvert::AddFact(output, std::string("MeshMotion.") + fact, value);
  }
  AddQuality(before, "Before", output);
  AddQuality(after, "After", output);
  if (motion.Unmatched > 0)
  {
    this->Warn(std::to_string(motion.Unmatched) +
      " points of the Boundary are not on the boundary of the Input, and have no effect; raise "
      "Match Tolerance, or use the surface of the mesh");
  }
  if (after.Inverted.sum() > before.Inverted.sum())
  {
    this->Warn(std::to_string(after.Inverted.sum()) +
      " cells are inverted; apply Shape Untangle, with the Input as Rest Shape, or move the "
      "boundary in smaller steps");
  }
  progress(1.0);
}
