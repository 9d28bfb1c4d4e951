#include "vtkShapeJoinPieces.h"

#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkShapeJoinPieces);

int vtkShapeJoinPieces::RequestData(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // A single piece keeps its points and their order.
  this->MergePoints = this->GetNumberOfInputConnections(0) > 1;
  return this->Superclass::RequestData(request, inputs, outputs);
}
