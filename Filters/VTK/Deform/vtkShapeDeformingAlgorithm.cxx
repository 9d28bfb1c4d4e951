#include "vtkShapeDeformingAlgorithm.h"

#include "vtkShapeConvert.h"
#include "vtkShapeHandle.h"

#include "vtkDataSet.h"

vtkShapeDeformingAlgorithm::vtkShapeDeformingAlgorithm() = default;

shape::DeformFields vtkShapeDeformingAlgorithm::ReadFields(
  vtkDataSet* shape, const std::string& name) const
{
  const auto isChosen = [](const std::string& array) { return !array.empty() && array != "None"; };
  shape::DeformFields fields;
  if (isChosen(this->RigidityArray))
  {
    fields.Rigidity = vtkShapeConvert::ToPointArray(shape, this->RigidityArray, 1, name).col(0);
  }
  if (isChosen(this->ScaleArray))
  {
    fields.Scale = vtkShapeConvert::ToPointArray(shape, this->ScaleArray, 1, name).col(0);
  }
  if (isChosen(this->SegmentArray))
  {
    fields.Segments = vtkShapeHandle::ToLabels(shape, this->SegmentArray, name);
  }
  return fields;
}
