#include "vtkShapeRequests.h"

#include "vtkCallbackCommand.h"
#include "vtkExecutive.h"
#include "vtkExtentTranslator.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkOutputWindow.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <set>
#include <vector>

namespace
{

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// Lets the error through, unless it only repeats that the request failed.
void OnExecutiveError(vtkObject* executive, unsigned long, void* command, void* text)
{
  auto* self = static_cast<vtkCallbackCommand*>(command);
  const auto* message = static_cast<const char*>(text);
  if (message && std::strstr(message, "returned failure for request"))
  {
    self->AbortFlagOn();
  }
  const bool isHeard = self->GetAbortFlag();
  executive->RemoveObserver(self);
  if (!isHeard && message && !executive->HasObserver(vtkCommand::ErrorEvent))
  {
    vtkOutputWindowDisplayErrorText(message);
  }
}

} // namespace

void vtkShapeRequests::OfferTimes(
  int inputPorts, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  std::set<double> steps, ends;
  for (int port = 0; port < inputPorts; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(i);
      const double* own = info->Get(Pipeline::TIME_STEPS());
      steps.insert(own, own + info->Length(Pipeline::TIME_STEPS()));
      const double* range = info->Get(Pipeline::TIME_RANGE());
      ends.insert(range, range + info->Length(Pipeline::TIME_RANGE()));
    }
  }
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(port);
    if (!steps.empty())
    {
      const std::vector<double> all(steps.begin(), steps.end());
      info->Set(Pipeline::TIME_STEPS(), all.data(), static_cast<int>(all.size()));
    }
    if (!ends.empty())
    {
      const double range[] = { *ends.begin(), *ends.rbegin() };
      info->Set(Pipeline::TIME_RANGE(), range, 2);
    }
  }
}

void vtkShapeRequests::OfferUnitTime(vtkInformationVector* outputs)
{
  std::array<double, 41> steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    steps[i] = static_cast<double>(i) / (steps.size() - 1);
  }
  const double range[2] = { 0.0, 1.0 };
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    vtkInformation* info = outputs->GetInformationObject(port);
    info->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
    info->Set(Pipeline::TIME_RANGE(), range, 2);
  }
}

double vtkShapeRequests::GetUnitTime(vtkInformation* output)
{
  return output->Has(Pipeline::UPDATE_TIME_STEP())
    ? std::clamp(output->Get(Pipeline::UPDATE_TIME_STEP()), 0.0, 1.0)
    : 0.0;
}

void vtkShapeRequests::RequestFirstTimes(int inputPorts, vtkInformationVector** inputs)
{
  for (int port = 0; port < inputPorts; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(i);
      if (info->Has(Pipeline::TIME_STEPS()))
      {
        info->Set(Pipeline::UPDATE_TIME_STEP(), info->Get(Pipeline::TIME_STEPS(), 0));
      }
      else if (info->Has(Pipeline::TIME_RANGE()))
      {
        info->Set(Pipeline::UPDATE_TIME_STEP(), info->Get(Pipeline::TIME_RANGE(), 0));
      }
      else
      {
        info->Remove(Pipeline::UPDATE_TIME_STEP());
      }
    }
  }
}

void vtkShapeRequests::RequestOwnExtents(int inputPorts, vtkInformationVector** inputs)
{
  for (int port = 1; port < inputPorts; ++port)
  {
    for (int i = 0; i < inputs[port]->GetNumberOfInformationObjects(); ++i)
    {
      vtkInformation* info = inputs[port]->GetInformationObject(i);
      if (!info->Has(Pipeline::WHOLE_EXTENT()))
      {
        continue;
      }
      const bool pieces = info->Has(Pipeline::UPDATE_NUMBER_OF_PIECES());
      int whole[6], own[6];
      info->Get(Pipeline::WHOLE_EXTENT(), whole);
      vtkNew<vtkExtentTranslator> translator;
      translator->PieceToExtentThreadSafe(pieces ? info->Get(Pipeline::UPDATE_PIECE_NUMBER()) : 0,
        pieces ? info->Get(Pipeline::UPDATE_NUMBER_OF_PIECES()) : 1, 0, whole, own,
        vtkExtentTranslator::BLOCK_MODE, 0);
      info->Set(Pipeline::UPDATE_EXTENT(), own, 6);
    }
  }
}

void vtkShapeRequests::SilenceFailure(vtkExecutive* executive)
{
  // If warnings are off, the executive says nothing, and the observer would stay.
  if (!vtkObject::GetGlobalWarningDisplay())
  {
    return;
  }
  vtkNew<vtkCallbackCommand> command;
  command->SetCallback(OnExecutiveError);
  command->SetClientData(command);
  constexpr float first = 1e6F; // before other observers
  executive->AddObserver(vtkCommand::ErrorEvent, command, first);
}
