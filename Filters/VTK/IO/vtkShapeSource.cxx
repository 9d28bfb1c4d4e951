#include "vtkShapeSource.h"

#include "vtkShapeLabel.h"

#include "vtkDataObject.h"
#include "vtkDataObjectTypes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkSmartPointer.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "Base/Errors.h"

#include <array>
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
  info->Set(vtkDataObject::DATA_TYPE_NAME(),
    this->GetOutputType() == "vtkImageData" ? "vtkImageData" : "vtkPointSet");
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
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    return this->Try([&]() { this->Announce(outputs->GetInformationObject(0)); }) ? 1 : 0;
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
  bool isStopped = false;
  const bool isMade = this->Try(
    [&]()
    {
      try
      {
        this->Make(vtkDataObject::GetData(outputs), progress);
      }
      catch (const shape::Aborted&)
      {
        isStopped = true;
      }
    });
  if (!isMade || isStopped)
  {
    for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
    {
      vtkDataObject::GetData(outputs, port)->Initialize();
    }
    return isStopped ? 1 : 0;
  }
  vtkInformation* const first = outputs->GetInformationObject(0);
  auto* const image = vtkImageData::SafeDownCast(vtkDataObject::GetData(first));
  if (image && first->Has(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT()))
  {
    std::array<int, 6> extent{};
    first->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent.data());
    image->Crop(extent.data());
  }
  return 1;
}

bool vtkShapeSource::Try(const std::function<void()>& function)
{
  std::string message;
  try
  {
    function();
    return true;
  }
  catch (const std::bad_alloc&)
  {
    message = "out of memory; use a coarser mesh";
  }
  catch (const std::exception& error)
  {
    message = error.what();
  }
  vtkErrorMacro(<< this->GetLabel() << ": " << message);
  return false;
}
