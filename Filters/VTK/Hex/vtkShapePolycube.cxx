#include "vtkShapePolycube.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeLargeSize.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

vtkStandardNewMacro(vtkShapePolycube);

vtkShapePolycube::vtkShapePolycube()
{
  this->DeclareInput("Input", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
  this->DeclareMovedOutput();
  this->DeclareFacts();
  this->DeclareShown(0, { "Label" });
  this->DeclareShown(1, { "Label" });
}

namespace
{

/// Returns the labels of cells whose points have these positions.
vtkSmartPointer<vtkIntArray> Labels(vtkDataSet* data, const Eigen::MatrixXd& places)
{
  Eigen::VectorXi labels(data->GetNumberOfCells());
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < labels.size(); ++cell)
  {
    data->GetCellPoints(cell, ids);
    Eigen::MatrixXd corners(ids->GetNumberOfIds(), 3);
    for (vtkIdType k = 0; k < ids->GetNumberOfIds(); ++k)
    {
      corners.row(k) = places.row(ids->GetId(k));
    }
    labels(cell) = shape::FindPolygonLabel(corners);
  }
  return vtkShapeConvert::ToIntegers(labels, "Label");
}

} // namespace

void vtkShapePolycube::Execute(const shape::Progress& progress)
{
  const GatheredInput& whole = this->GetGatheredInput(0);
  const shape::Surface mesh = vtkShapeConvert::ToMesh(whole.Data, "the surface");
  const std::string warning = vtkShapeLargeSize::CheckCellSize(
    "Target Edge Length", this->Options.TargetEdgeLength, whole.Data);
  if (!warning.empty())
  {
    this->Warn(warning);
  }
  // Every process computes the same result, and writes the rows of its own points.
  const shape::PolycubeResult map = shape::BuildPolycube(mesh, this->Options, progress);

  // The points of this process are ordered by block.
  const Eigen::MatrixXd positions = vtkShapeConvert::Rows(map.Positions, whole.OwnPoints);
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  vtkDataObject* surface = this->GetOutputDataObject(0);
  vtkDataObject* polycube = this->GetOutputDataObject(1);
  vtkIdType first = 0;
  vtkShapeComposite::ForEach(input, surface, vtkShapeComposite::Points::Kept,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const Eigen::MatrixXd own = positions.middleRows(first, from->GetNumberOfPoints());
      to->ShallowCopy(from);
      to->GetPointData()->AddArray(vtkShapeConvert::ToArray(own, "TargetPosition"));
      to->GetCellData()->AddArray(Labels(from, own));
      first += from->GetNumberOfPoints();
    });
  first = 0;
  vtkShapeComposite::ForEach(input, polycube, vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const Eigen::MatrixXd own = positions.middleRows(first, from->GetNumberOfPoints());
      vtkShapeComposite::Move(from, own, to);
      to->GetPointData()->AddArray(
        vtkShapeConvert::ToArray(vtkShapeConvert::ToPoints(from), "SourcePosition"));
      to->GetCellData()->AddArray(Labels(from, own));
      first += from->GetNumberOfPoints();
    });

  for (vtkDataObject* output : { surface, polycube })
  {
    vtkShapeConvert::AddFact(output, "Polycube.Charts", map.Charts);
    vtkShapeConvert::AddFact(output, "Polycube.Corners", map.Corners);
    vtkShapeConvert::AddFact(output, "Polycube.EdgeLength", map.EdgeLength);
    vtkShapeConvert::AddFact(output, "Polycube.Distortion", map.Distortion);
  }
}
