#include "vtkShapeSource.h"

#include "vtkShapeLabel.h"

#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"

#include "Base/Errors.h"

#include <new>

vtkShapeSource::vtkShapeSource()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(1);
}

std::string vtkShapeSource::GetLabel()
{
  return vtkShapeLabel::Of(this->GetClassName());
}

int vtkShapeSource::FillOutputPortInformation(int, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkPointSet");
  return 1;
}

vtkTypeBool vtkShapeSource::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  // The outputs are those of the request: ParaView's reader of file series passes its own.
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    this->CreateOutput(outputs);
    return 1;
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->Run(outputs);
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

void vtkShapeSource::CreateOutput(vtkInformationVector* outputs)
{
  const std::string type = this->GetOutputType();
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    if (!output || type != output->GetClassName())
    {
      vtkSmartPointer<vtkDataObject> created;
      created.TakeReference(vtkDataObjectTypes::NewDataObject(type.c_str()));
      outputs->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), created);
    }
  }
}

vtkDataObject* vtkShapeSource::GetFurtherOutput(int port)
{
  return vtkDataObject::GetData(this->Outputs, port);
}

int vtkShapeSource::Run(vtkInformationVector* outputs)
{
  this->Outputs = outputs;
  const shape::Progress progress(
    [this](double fraction)
    {
      this->UpdateProgress(fraction);
      return !this->GetAbortExecute();
    });
  std::string message; // empty if the user stopped it
  try
  {
    this->Make(vtkDataObject::GetData(outputs), progress);
    return 1;
  }
  catch (const shape::Aborted&)
  {
  }
  catch (const std::bad_alloc&)
  {
    message = "out of memory; use a coarser mesh";
  }
  catch (const std::exception& error)
  {
    message = error.what();
  }
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
  if (message.empty())
  {
    return 1;
  }
  vtkErrorMacro(<< this->GetLabel() << ": " << message);
  return 0;
}
