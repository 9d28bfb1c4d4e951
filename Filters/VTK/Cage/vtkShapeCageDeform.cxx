#include "vtkShapeCageDeform.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include "Base/Errors.h"

#include <algorithm>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkShapeCageDeform);

vtkShapeCageDeform::vtkShapeCageDeform()
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Cage", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("MovedCage", PortData::WholePolygons, PortUse::Required, { "vtkPolyData" });
  this->DeclareMovedOutput();
  this->DeclareFacts();
  this->DeclareMeasures({ "DeformationGradient" });
}

namespace
{

/// Returns the first polygon, or strip, that has other points in the two arrays; -1 if there is
/// none.
vtkIdType FindDifference(vtkCellArray* cells, vtkCellArray* others)
{
  vtkNew<vtkIdList> points, otherPoints;
  for (vtkIdType cell = 0; cell < cells->GetNumberOfCells(); ++cell)
  {
    cells->GetCellAtId(cell, points);
    others->GetCellAtId(cell, otherPoints);
    if (!std::equal(points->begin(), points->end(), otherPoints->begin(), otherPoints->end()))
    {
      return cell;
    }
  }
  return -1;
}

/// The two cages must have the same points and cells: the polygons of the first are triangulated
/// for both, since a polygon that is not flat can be divided in several ways.
void RequireSameCells(vtkPolyData* cage, vtkPolyData* moved)
{
  const vtkIdType points = cage->GetNumberOfPoints();
  if (moved->GetNumberOfPoints() != points)
  {
    throw shape::InvalidInput("the MovedCage has " + std::to_string(moved->GetNumberOfPoints()) +
      " points and the Cage " + std::to_string(points) +
      ", where points that no triangle uses count, too; connect the same surface with its points "
      "moved");
  }
  for (const auto& [cells, others] : { std::pair(cage->GetPolys(), moved->GetPolys()),
         std::pair(cage->GetStrips(), moved->GetStrips()) })
  {
    if (cells->GetNumberOfCells() != others->GetNumberOfCells())
    {
      throw shape::InvalidInput("the MovedCage has " + std::to_string(others->GetNumberOfCells()) +
        " polygons and the Cage " + std::to_string(cells->GetNumberOfCells()) +
        "; connect the same surface with its points moved");
    }
    if (const vtkIdType first = FindDifference(cells, others); first >= 0)
    {
      throw shape::InvalidInput("polygon " + std::to_string(first) +
        " of the MovedCage has other points than that of the Cage; connect the same surface with "
        "its points moved");
    }
  }
}

} // namespace

void vtkShapeCageDeform::Execute(const shape::Progress& progress)
{
  vtkPolyData* cage = this->GetGatheredInput(1).Data;
  vtkPolyData* moved = this->GetGatheredInput(2).Data;
  RequireSameCells(cage, moved);
  const bool fills = this->Options.Coordinates == shape::CageCoordinates::Harmonic;
  const double prepared = fills ? 0.9 : 0.1;
  const shape::CageDeformer deformer(vtkShapeConvert::ToMesh(cage, "the Cage"),
    vtkShapeConvert::ToPoints(moved), this->Options, progress.Part(0.0, prepared));
  this->AddCount(0, "CageDeform.OutsidePoints", this->Move(deformer, progress.Part(prepared, 1.0)));
  vtkShapeConvert::AddFact(
    this->GetOutputDataObject(0), "CageDeform.Tetrahedra", deformer.GetTetrahedra());
  progress(1.0);
}

std::vector<Eigen::RowVector3d> vtkShapeCageDeform::Move(
  const shape::CageDeformer& deformer, const shape::Progress& progress)
{
  std::vector<Eigen::RowVector3d> outside;
  vtkDataObject* domain = this->GetInputDataObject(0, 0);
  const double share =
    1.0 / std::max<vtkIdType>(1, domain->GetNumberOfElements(vtkDataObject::POINT));
  double done = 0.0;
  vtkShapeComposite::ForEach(domain, this->GetOutputDataObject(0), vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* input, vtkDataSet* output)
    {
      const Eigen::MatrixXd sources = vtkShapeConvert::ToPoints(input);
      const double next = std::min(1.0, done + share * static_cast<double>(sources.rows()));
      const shape::CageMovedPoints moved =
        deformer.Evaluate(sources, progress.Part(done, next, "moving the points"));
      done = next;
      vtkUnsignedCharArray* ghosts = input->GetPointGhostArray();
      for (Eigen::Index i = 0; i < sources.rows(); ++i)
      {
        // Points that belong to another process are counted by that process.
        if (moved.OutsideDomain(i) == 1 &&
          (!ghosts || (ghosts->GetValue(i) & vtkDataSetAttributes::DUPLICATEPOINT) == 0))
        {
          outside.emplace_back(sources.row(i));
        }
      }
      vtkShapeComposite::Move(input, moved.Points, output);
      vtkPointData* arrays = output->GetPointData();
      arrays->AddArray(vtkShapeConvert::ToArray(sources, "SourcePosition"));
      arrays->AddArray(vtkShapeConvert::ToIntegers(moved.OutsideDomain, "OutsideDomain"));
      if (this->Options.DeformationGradient)
      {
        arrays->AddArray(vtkShapeConvert::ToArray(moved.Gradients, "DeformationGradient"));
      }
    });
  return outside;
}
