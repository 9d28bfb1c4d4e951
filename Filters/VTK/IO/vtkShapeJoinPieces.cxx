#include "vtkShapeJoinPieces.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkShapeJoinPieces);

int vtkShapeJoinPieces::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  this->MergePoints = this->GetNumberOfInputConnections(0) > 1;
  return this->Superclass::RequestData(request, inputs, outputs);
}
