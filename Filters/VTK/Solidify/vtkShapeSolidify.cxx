#include "vtkShapeSolidify.h"

#include "vtkShapeCarry.h"
#include "vtkShapeConvert.h"
#include "vtkShapeSoup.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"

#include <array>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkShapeSolidify);

vtkShapeSolidify::vtkShapeSolidify()
{
  this->DeclareInput(
    "Input", PortData::WholeGrid, PortUse::Required, { "vtkPolyData", "vtkUnstructuredGrid" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkPolyData");
  this->DeclareFacts();
  this->DeclareShown(0, { "Origin" });
  this->DeclareShown(1, { "Defect" });
}

namespace
{

/// The names of the facts, in the order of shape::DefectKind.
constexpr std::array<const char*, shape::NumberOfDefectKinds> DefectFacts = { "NotFinitePoints",
  "LoosePoints", "DuplicatePoints", "DegenerateTriangles", "DuplicateTriangles", "NonManifoldEdges",
  "NonManifoldPoints", "MisorientedEdges", "InvertedPieces", "OpenLoops", "SelfIntersections",
  "SmallPieces" };

/// In the order of shape::SolidifyMethod.
constexpr std::array<const char*, 5> MethodNames = { "Automatic", "Report", "Mend", "Solid",
  "Wrap" };

/// Throws shape::InvalidInput if a block has no cells at all, such as a table.
void RequireDataSets(vtkDataObject* data)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    return;
  }
  vtkSmartPointer<vtkCompositeDataIterator> it;
  it.TakeReference(composite->NewIterator());
  for (it->InitTraversal(); !it->IsDoneWithTraversal(); it->GoToNextItem())
  {
    if (!vtkDataSet::SafeDownCast(it->GetCurrentDataObject()))
    {
      throw shape::InvalidInput(std::string("the Input contains a ") +
        it->GetCurrentDataObject()->GetClassName() +
        ", which is not a surface; remove it with Extract Block");
    }
  }
}

/// Writes the grid's polygons as they are.
void WriteUnchanged(vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  output->SetPoints(grid->GetPoints());
  output->SetPolys(grid->GetCells());
  output->GetPointData()->ShallowCopy(grid->GetPointData());
  output->GetCellData()->ShallowCopy(grid->GetCellData());
}

void WriteMended(const shape::MendedSurface& mended, const vtkShapeSoup& soup,
  vtkUnstructuredGrid* grid, vtkPolyData* output)
{
  vtkShapeConvert::FromMesh(mended.Surface, output);
  shape::Provenance provenance = mended.Provenance;
  provenance.Cells = shape::ComposeIndices(soup.Cells, provenance.Cells);
  vtkShapeCarry::Carry({ { grid, provenance } }, output);
}

void WriteDefects(const shape::SurfaceDefects& defects, vtkPolyData* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> vertices;
  vtkNew<vtkIntArray> kinds;
  kinds->SetName("Defect");
  for (const shape::SurfaceDefect& defect : defects.Defects)
  {
    vertices->InsertNextCell({ points->InsertNextPoint(defect.Position.data()) });
    kinds->InsertNextValue(static_cast<int>(defect.Kind));
  }
  output->SetPoints(points);
  output->SetVerts(vertices);
  output->GetPointData()->AddArray(kinds);
}

} // namespace

// 1. Triangulate the polygons.
// 2. Find the defects, and make a solid.
// 3. Write the surface, the defects and the facts.
void vtkShapeSolidify::Execute(const shape::Progress& progress)
{
  RequireDataSets(this->GetInputDataObject(0, 0));
  // Every process has the complete input, and one of them computes the result.
  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  vtkUnstructuredGrid* grid = this->GetGatheredInput(0).Grid;
  const vtkShapeSoup soup(grid, "the Input");
  const shape::SolidifyResult result =
    shape::Solidify(soup.Surface, this->Options, progress.Part(0.0, 0.95));
  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  const bool isUnchanged = result.Method == shape::SolidifyMethod::Report;
  if (isUnchanged && soup.IsPolygons)
  {
    WriteUnchanged(grid, output);
  }
  else
  {
    WriteMended(result.Mended, soup, grid, output);
  }
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(isUnchanged
      ? Eigen::VectorXi(Eigen::VectorXi::Zero(output->GetNumberOfCells()))
      : result.Mended.Origin,
    "Origin"));
  WriteDefects(result.Defects, vtkPolyData::SafeDownCast(this->GetOutputDataObject(1)));
  this->AddFacts(result);
  progress(1.0);
}

void vtkShapeSolidify::AddFacts(const shape::SolidifyResult& result)
{
  vtkDataObject* output = this->GetOutputDataObject(0);
  const auto add = [&](const std::string& name, auto value)
  { vtkShapeConvert::AddFact(output, "Solidify." + name, value); };
  add("Method", std::string(MethodNames[static_cast<std::size_t>(result.Method)]));
  add("Defects", static_cast<double>(result.Defects.Defects.size()));
  for (std::size_t kind = 0; kind < DefectFacts.size(); ++kind)
  {
    add(DefectFacts[kind], static_cast<double>(result.Defects.Counts[kind]));
  }
  const auto countOrigin = [&](shape::TriangleOrigin origin) {
    return static_cast<double>((result.Mended.Origin.array() == static_cast<int>(origin)).count());
  };
  const std::pair<const char*, double> facts[] = { { "PiecesBefore", result.Defects.Pieces },
    { "Pieces", result.Pieces }, { "EulerNumberBefore", result.Defects.EulerNumber },
    { "EulerNumber", result.EulerNumber }, { "Kept", countOrigin(shape::TriangleOrigin::Kept) },
    { "Mended", countOrigin(shape::TriangleOrigin::Mended) },
    { "Made", countOrigin(shape::TriangleOrigin::Made) },
    { "GapsClosed", result.Mended.GapsClosed }, { "SplitPoints", result.Mended.SplitPoints },
    { "ReversedTriangles", result.Mended.ReversedTriangles },
    { "RemovedTriangles", result.Mended.RemovedTriangles },
    { "RemovedPieces", result.Mended.RemovedPieces }, { "GridSpacing", result.Mended.GridSpacing },
    { "DistanceFromInput", result.Distances.FromFirst },
    { "DistanceToInput", result.Distances.FromSecond } };
  for (const auto& [fact, value] : facts)
  {
    add(fact, value);
  }
}
