#include "vtkShapeDeformingAlgorithm.h"

#include "vtkShapeConvert.h"
#include "vtkShapeHandle.h"

#include "vtkDataSet.h"

vtkShapeDeformingAlgorithm::vtkShapeDeformingAlgorithm() = default;

shape::DeformFields vtkShapeDeformingAlgorithm::ReadFields(
  vtkDataSet* shape, const std::string& name) const
{
  shape::DeformFields fields;
  if (vtkShapeConvert::IsChosen(this->RigidityArray))
  {
    fields.Rigidity = vtkShapeConvert::ToPointArray(shape, this->RigidityArray, 1, name).col(0);
  }
  if (vtkShapeConvert::IsChosen(this->ScaleArray))
  {
    fields.Scale = vtkShapeConvert::ToPointArray(shape, this->ScaleArray, 1, name).col(0);
  }
  if (vtkShapeConvert::IsChosen(this->SegmentArray))
  {
    fields.Segments = vtkShapeHandle::ToLabels(shape, this->SegmentArray, name);
  }
  return fields;
}
