#include "vtkShapeBoundaryDistance.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include <algorithm>

vtkStandardNewMacro(vtkShapeBoundaryDistance);

vtkShapeBoundaryDistance::vtkShapeBoundaryDistance()
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Surface", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareOutputLikeInput();
  this->DeclareShown(0, { "BoundaryDistance" });
}

void vtkShapeBoundaryDistance::Execute(const shape::Progress& progress)
{
  const shape::Mesh surface =
    vtkShapeConvert::ToMesh(this->GetGatheredInput(1).Data, "the Surface");
  progress(0.1);
  // One search structure for all blocks.
  const shape::BoundaryDistance distance(surface, this->Options, progress.Part(0.1, 0.3));
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  const double share =
    0.7 / std::max<vtkIdType>(1, input->GetNumberOfElements(vtkDataObject::POINT));
  double done = 0.3;
  vtkShapeComposite::ForEach(input, this->GetOutputDataObject(0), vtkShapeComposite::Points::Kept,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const double next = done + share * from->GetNumberOfPoints();
      const Eigen::VectorXd values = distance.Evaluate(
        vtkShapeConvert::ToPoints(from), progress.Part(done, next, "computing distances"));
      done = next;
      to->ShallowCopy(from);
      to->GetPointData()->AddArray(vtkShapeConvert::ToArray(values, "BoundaryDistance"));
    });
}
