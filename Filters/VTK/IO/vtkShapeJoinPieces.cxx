#include "vtkShapeJoinPieces.h"

#include "vtkDataObject.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkShapeJoinPieces);

int vtkShapeJoinPieces::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // A single piece keeps its points and their order.
  this->MergePoints = this->MergePieces && this->GetNumberOfInputConnections(0) > 1;
  if (!this->Superclass::RequestData(request, inputs, outputs))
  {
    return 0;
  }
  if (vtkDataObject* first = vtkDataObject::GetData(inputs[0]))
  {
    vtkDataObject::GetData(outputs)->GetFieldData()->PassData(first->GetFieldData());
  }
  return 1;
}
