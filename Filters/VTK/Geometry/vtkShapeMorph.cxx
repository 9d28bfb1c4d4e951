#include "vtkShapeMorph.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"

#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include "Mesh/Topology.h"

#include <algorithm>
#include <array>
#include <cstddef>

using Pipeline = vtkStreamingDemandDrivenPipeline;

vtkStandardNewMacro(vtkShapeMorph);

vtkShapeMorph::vtkShapeMorph()
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  this->DeclareMovedOutput();
}

void vtkShapeMorph::DescribeOutputs(vtkInformationVector**, vtkInformationVector* outputs)
{
  std::array<double, 41> steps;
  for (std::size_t i = 0; i < steps.size(); ++i)
  {
    steps[i] = static_cast<double>(i) / (steps.size() - 1);
  }
  const double range[2] = { 0.0, 1.0 };
  vtkInformation* info = outputs->GetInformationObject(0);
  info->Set(Pipeline::TIME_STEPS(), steps.data(), static_cast<int>(steps.size()));
  info->Set(Pipeline::TIME_RANGE(), range, 2);
}

/// The output's time is the parameter of the morph; the input is always read at its own first time.
void vtkShapeMorph::RequestInputs(vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkInformation* info = inputs[0]->GetInformationObject(0);
  if (!info)
  {
    return; // Execute says that the input is missing
  }
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

void vtkShapeMorph::Execute(const shape::Progress& progress)
{
  vtkInformation* request = this->GetOutputInformation(0);
  const double time = request->Has(Pipeline::UPDATE_TIME_STEP())
    ? std::clamp(request->Get(Pipeline::UPDATE_TIME_STEP()), 0.0, 1.0)
    : 0.0;
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  vtkDataObject* moved = this->GetOutputDataObject(0);
  const double share =
    1.0 / std::max<vtkIdType>(1, input->GetNumberOfElements(vtkDataObject::POINT));
  double done = 0.0;
  vtkShapeComposite::ForEach(input, moved, vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      const double next = done + share * from->GetNumberOfPoints();
      const shape::Progress part = progress.Part(done, next, "moving the points");
      done = next;
      const Eigen::MatrixXd positions = vtkShapeConvert::ToPoints(from);
      shape::RequireFinite(positions, "the Input");
      part(0.2);
      const Eigen::MatrixXd targets =
        vtkShapeConvert::ToPointArray(from, this->MapArray, 3, "the Input");
      shape::RequireFinite(targets, "the map array of the Input");
      part(0.4);
      vtkShapeComposite::Move(from, (1.0 - time) * positions + time * targets, to);
      part(0.8);
      to->GetPointData()->AddArray(vtkShapeConvert::ToArray(positions, "SourcePosition"));
      part(1.0);
    });
  moved->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
}
