#include "vtkShapeAlgorithm.h"

#include "vtkShapeComplete.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeFacts.h"
#include "vtkShapeGather.h"
#include "vtkShapeLabel.h"
#include "vtkShapeMeasures.h"
#include "vtkShapeProgress.h"
#include "vtkShapeRepair.h"
#include "vtkShapeRequests.h"
#include "vtkShapeSurfaces.h"
#include "vtkShapeTexts.h"
#include "vtkShapeTurn.h"

#include "vtkDataObjectTypes.h"
#include "vtkDemandDrivenPipeline.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Base/Memory.h"

#include <algorithm>
#include <cstring>

struct vtkShapeAlgorithm::InputPort
{
  std::string Name;
  PortData Data;
  PortUse Use;
  std::vector<std::string> Types;
};

struct vtkShapeAlgorithm::Count
{
  int Port;
  std::string Name;
  std::vector<Eigen::RowVector3d> Positions;
};

vtkShapeAlgorithm::vtkShapeAlgorithm()
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(0);
  this->SetController(vtkMultiProcessController::GetGlobalController());
}

vtkShapeAlgorithm::~vtkShapeAlgorithm()
{
  this->SetController(nullptr);
}

vtkCxxSetObjectMacro(vtkShapeAlgorithm, Controller, vtkMultiProcessController);

vtkMultiProcessController* vtkShapeAlgorithm::GetController()
{
  return this->Controller;
}

std::string vtkShapeAlgorithm::GetLabel()
{
  return vtkShapeLabel::Of(this->GetClassName());
}

std::string vtkShapeAlgorithm::GetInputName(int port)
{
  return this->InputPorts[port].Name;
}

bool vtkShapeAlgorithm::IsInputRequired(int port)
{
  return this->InputPorts[port].Use == PortUse::Required;
}

void vtkShapeAlgorithm::DeclareInput(
  const std::string& name, PortData data, PortUse use, const std::vector<std::string>& types)
{
  this->InputPorts.push_back({ name, data, use, types });
  this->SetNumberOfInputPorts(static_cast<int>(this->InputPorts.size()));
}

void vtkShapeAlgorithm::DeclareOutput(const std::string& type)
{
  this->OutputTypes.push_back(type);
  this->SetNumberOfOutputPorts(static_cast<int>(this->OutputTypes.size()));
}

void vtkShapeAlgorithm::DeclareOutputLikeInput(int input)
{
  this->LikeInput[static_cast<int>(this->OutputTypes.size())] = input;
  this->DeclareOutput("");
}

void vtkShapeAlgorithm::DeclareMovedOutput(int input)
{
  this->MovedOutputs.insert(static_cast<int>(this->OutputTypes.size()));
  this->DeclareOutputLikeInput(input);
}

void vtkShapeAlgorithm::DeclareMeasures(const std::set<std::string>& names)
{
  this->MadeMeasures = names;
}

void vtkShapeAlgorithm::DeclareFacts(const std::map<int, std::set<std::string>>& kept)
{
  this->FactsPort = static_cast<int>(this->OutputTypes.size());
  this->KeptFacts = kept;
  this->DeclareOutput("vtkTable");
}

void vtkShapeAlgorithm::DeclareShown(int port, const std::vector<std::string>& names)
{
  this->Shown[port] = names;
}

void vtkShapeAlgorithm::DeclareMemoryRemedy(const std::string& remedy)
{
  this->MemoryRemedy = remedy;
}

void vtkShapeAlgorithm::Warn(const std::string& text)
{
  // A kernel may meet the same fact many times.
  if (std::find(this->Warnings.begin(), this->Warnings.end(), text) == this->Warnings.end())
  {
    this->Warnings.push_back(text);
  }
}

int vtkShapeAlgorithm::FillInputPortInformation(int port, vtkInformation* info)
{
  const InputPort& declared = this->InputPorts[port];
  for (const std::string& type : declared.Types)
  {
    info->Append(INPUT_REQUIRED_DATA_TYPE(), type.c_str());
    if (type == "vtkPolyData")
    {
      info->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkUnstructuredGrid"); // with surface cells
    }
  }
  // Accepted by every port: the default composite executive would run the filter once for each
  // block.
  info->Append(INPUT_REQUIRED_DATA_TYPE(), "vtkCompositeDataSet");
  // Optional for VTK, because processes must agree that one of them lacks a required input.
  info->Set(INPUT_IS_OPTIONAL(), 1);
  info->Set(INPUT_IS_REPEATABLE(), declared.Use == PortUse::OptionalRepeatable);
  return 1;
}

int vtkShapeAlgorithm::FillOutputPortInformation(int port, vtkInformation* info)
{
  const std::string& type = this->OutputTypes[port];
  info->Set(vtkDataObject::DATA_TYPE_NAME(), type.empty() ? "vtkDataObject" : type.c_str());
  return 1;
}

/// The passes of the pipeline: create the outputs, describe them, request the inputs, compute.
vtkTypeBool vtkShapeAlgorithm::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA_OBJECT()))
  {
    return this->CreateOutputs(inputs, outputs);
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_INFORMATION()))
  {
    vtkShapeRequests::OfferTimes(this->GetNumberOfInputPorts(), inputs, outputs);
    this->DescribeOutputs(inputs, outputs);
  }
  if (request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_TIME()) ||
    request->Has(vtkStreamingDemandDrivenPipeline::REQUEST_UPDATE_EXTENT()))
  {
    vtkShapeRequests::RequestOwnExtents(this->GetNumberOfInputPorts(), inputs);
    this->RequestInputs(inputs, outputs);
  }
  if (request->Has(vtkDemandDrivenPipeline::REQUEST_DATA()))
  {
    return this->Run(outputs);
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

void vtkShapeAlgorithm::DescribeOutputs(vtkInformationVector**, vtkInformationVector*)
{
}

void vtkShapeAlgorithm::RequestInputs(vtkInformationVector**, vtkInformationVector*)
{
}

int vtkShapeAlgorithm::CreateOutputs(vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    const auto like = this->LikeInput.find(port);
    vtkDataObject* input =
      vtkDataObject::GetData(inputs[like == this->LikeInput.end() ? 0 : like->second]);
    std::string type = this->OutputTypes[port];
    if (type.empty())
    {
      // If a required input is missing, the request for data fails with a message.
      const auto points = this->MovedOutputs.count(port) ? vtkShapeComposite::Points::Moved
                                                         : vtkShapeComposite::Points::Kept;
      // The type is known only now, because an output like an input has the type of that input.
      type = input ? vtkShapeComposite::FindOutputType(input, points) : "vtkPolyData";
    }
    vtkDataObject* output = vtkDataObject::GetData(outputs, port);
    // An output of the right type is kept, so that views and links to it remain valid.
    if (!output || type != output->GetClassName())
    {
      vtkSmartPointer<vtkDataObject> created;
      created.TakeReference(vtkDataObjectTypes::NewDataObject(type.c_str()));
      outputs->GetInformationObject(port)->Set(vtkDataObject::DATA_OBJECT(), created);
    }
  }
  return 1;
}

void vtkShapeAlgorithm::GatherInput(int port, int connection)
{
  const InputPort& declared = this->InputPorts[port];
  vtkDataObject* input = this->GetInputDataObject(port, connection);
  GatheredInput whole;
  if (declared.Data == PortData::WholeGrid)
  {
    whole.Grid = vtkShapeGather::GatherGrid(input, this->Controller);
    this->GatheredInputs[port].push_back(whole);
    return;
  }
  // Inputs that name this type take solids, too: what is meant is their boundary.
  vtkSmartPointer<vtkDataObject> surface = input;
  if (std::count(declared.Types.begin(), declared.Types.end(), "vtkUnstructuredGrid") > 0)
  {
    surface = vtkShapeSurfaces::SolidAsBoundary(input, declared.Name, this->Controller);
  }
  whole.Data = vtkShapeGather::Gather(surface, declared.Name,
    declared.Data == PortData::Whole ? vtkShapeGather::Joined::Copies
                                     : vtkShapeGather::Joined::Coincident,
    this->Controller, whole.OwnPoints);
  whole.Given = whole.Data;
  const std::string warning = vtkShapeComplete::DescribeShortSides(whole.Data, declared.Name);
  if (!warning.empty())
  {
    this->Warn(warning);
  }
  this->GatheredInputs[port].push_back(whole);
  if (declared.Data == PortData::WholeSurface)
  {
    this->RepairInput(port, connection);
  }
}

void vtkShapeAlgorithm::RepairInput(int port, int connection, bool separate)
{
  GatheredInput& whole = this->GatheredInputs[port][connection];
  std::unique_ptr<vtkShapeRepair>& repair = this->Repairs[{ port, connection }];
  if (!repair)
  {
    repair = std::make_unique<vtkShapeRepair>();
  }
  vtkShapeRepaired repaired =
    repair->Apply(whole.Data, "the input '" + this->GetInputName(port) + "'", separate);
  if (repaired.Description.empty())
  {
    return;
  }
  this->Warn(repaired.Description);
  this->SplitPoints += repaired.SplitPoints;
  this->RemovedTriangles += repaired.RemovedTriangles;
  for (int& point : whole.OwnPoints)
  {
    point = repaired.Representatives.empty() ? point : repaired.Representatives[point];
  }
  whole.Data = repaired.Data;
  whole.GivenPoints = std::move(repaired.Points);
  whole.GivenTriangles = std::move(repaired.Triangles);
  whole.GivenCells = std::move(repaired.Cells);
}

void vtkShapeAlgorithm::PrepareInputs()
{
  this->GatheredInputs.assign(this->InputPorts.size(), {});
  this->SplitPoints = this->RemovedTriangles = 0;
  vtkShapeComplete::RequireConnections(*this);
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    const InputPort& declared = this->InputPorts[port];
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      // A selection may be empty, and is gathered with the surface that it marks. A table has no
      // points.
      if (declared.Data == PortData::Selection || declared.Data == PortData::Table)
      {
        continue;
      }
      vtkDataObject* input = this->GetInputDataObject(port, i);
      // An input is empty only if it is empty on all processes: a process without a piece must
      // still take part in the collective calls.
      if (vtkShapeGather::CountPoints(input, this->Controller) == 0)
      {
        throw shape::InvalidInput(
          "the input '" + declared.Name + "' has no points; connect data with points");
      }
      vtkShapeComplete::RequireArrays(input, declared.Name);
      if (declared.Data != PortData::Pieces)
      {
        this->GatherInput(port, i);
      }
    }
  }
}

const vtkShapeAlgorithm::GatheredInput& vtkShapeAlgorithm::GetGatheredInput(
  int port, int connection) const
{
  return this->GatheredInputs[port][connection];
}

shape::Progress vtkShapeAlgorithm::MakeProgress()
{
  return vtkShapeProgress::Make(this, this->GetLabel());
}

void vtkShapeAlgorithm::AddCount(
  int port, const std::string& name, std::vector<Eigen::RowVector3d> positions)
{
  this->Counts.push_back({ port, name, std::move(positions) });
}

/// Called after the processes have agreed on success, because counting is a collective call.
void vtkShapeAlgorithm::WriteCounts(vtkInformationVector* outputs)
{
  for (const Count& count : this->Counts)
  {
    vtkShapeConvert::AddFact(vtkDataObject::GetData(outputs, count.Port), count.Name,
      vtkShapeGather::CountOnce(this->Controller, count.Positions));
  }
}

std::string vtkShapeAlgorithm::GetFactPrefix()
{
  return std::string(this->GetClassName()).substr(std::strlen("vtkShape")) + ".";
}

std::vector<vtkDataObject*> vtkShapeAlgorithm::GetInputs()
{
  std::vector<vtkDataObject*> inputs;
  for (int port = 0; port < this->GetNumberOfInputPorts(); ++port)
  {
    for (int i = 0; i < this->GetNumberOfInputConnections(port); ++i)
    {
      inputs.push_back(this->GetInputDataObject(port, i));
    }
  }
  for (const std::vector<GatheredInput>& wholes : this->GatheredInputs)
  {
    for (const GatheredInput& whole : wholes)
    {
      inputs.insert(inputs.end(), { whole.Data.Get(), whole.Given.Get(), whole.Grid.Get() });
    }
  }
  inputs.erase(std::remove(inputs.begin(), inputs.end(), nullptr), inputs.end());
  return inputs;
}

/// Called after the processes have agreed on success, because gathering is a collective call.
void vtkShapeAlgorithm::WriteWarnings(vtkInformationVector* outputs)
{
  this->Warnings = vtkShapeTexts::GatherOnce(this->Controller, this->Warnings);
  if (this->Warnings.empty() || (this->Controller && this->Controller->GetLocalProcessId() != 0))
  {
    return;
  }
  for (const std::string& warning : this->Warnings)
  {
    vtkWarningMacro(<< this->GetLabel() << ": " << warning);
  }
  vtkShapeFacts::AddWarnings(this->GetFactPrefix(), this->Warnings, this->SplitPoints,
    this->RemovedTriangles, vtkDataObject::GetData(outputs, 0));
}

void vtkShapeAlgorithm::MoveFacts(vtkInformationVector* outputs)
{
  if (this->FactsPort == -1)
  {
    return;
  }
  const std::vector<vtkDataObject*> inputs = this->GetInputs();
  vtkNew<vtkTable> facts;
  for (int port = 0; port < this->FactsPort; ++port)
  {
    const auto kept = this->KeptFacts.find(port);
    vtkShapeFacts::Move(this->GetFactPrefix(), inputs,
      kept == this->KeptFacts.end() ? std::set<std::string>() : kept->second,
      vtkDataObject::GetData(outputs, port), facts);
  }
  vtkDataObject* table = vtkDataObject::GetData(outputs, this->FactsPort);
  table->Initialize();
  // One row in all, not one for each process.
  if (!this->Controller || this->Controller->GetLocalProcessId() == 0)
  {
    table->ShallowCopy(facts);
  }
}

void vtkShapeAlgorithm::ActivateShown(vtkInformationVector* outputs)
{
  for (const auto& [port, names] : this->Shown)
  {
    vtkShapeComposite::ActivateScalars(vtkDataObject::GetData(outputs, port), names);
  }
}

void vtkShapeAlgorithm::RenewMeasures(vtkInformationVector* outputs)
{
  vtkShapeMeasures::Filter filter;
  filter.Name = std::string(this->GetClassName()).substr(std::strlen("vtkShape"));
  filter.Made = this->MadeMeasures;
  filter.Inputs = this->GetInputs();
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    vtkShapeMeasures::Renew(filter, vtkDataObject::GetData(outputs, port));
  }
}

/// The only place that catches the exceptions of kernels and wrappers. After it, all processes
/// agree on failure, before the next collective.
int vtkShapeAlgorithm::Run(vtkInformationVector* outputs)
{
  bool stopped = true;
  std::string message; // empty if the user stopped it
  try
  {
    this->UpdateProgress(0.0);
    const vtkShapeTurn turn(this, this->Controller);
    shape::RequireThreadMemory();
    this->Counts.clear();
    this->Warnings.clear();
    this->PrepareInputs();
    this->Execute(this->MakeProgress());
    this->RenewMeasures(outputs);
    stopped = false;
  }
  catch (const shape::Aborted&)
  {
  }
  catch (const std::bad_alloc&)
  {
    message = "out of memory; use a coarser input" +
      (this->MemoryRemedy.empty() ? "" : ", or " + this->MemoryRemedy);
  }
  catch (const std::exception& error)
  {
    message = error.what();
  }
  // Gathered inputs are copies as large as the inputs.
  this->GatheredInputs.clear();
  vtkShapeGather::AgreeOnFailure(this->Controller, stopped, message);
  if (!stopped)
  {
    this->WriteCounts(outputs);
    this->WriteWarnings(outputs);
    this->MoveFacts(outputs);
    this->ActivateShown(outputs);
    this->UpdateProgress(1.0);
    return 1;
  }
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port)
  {
    // Outputs are complete or empty.
    vtkDataObject::GetData(outputs, port)->Initialize();
  }
  // An abort by the user is not an error.
  if (message.empty())
  {
    return 1;
  }
  vtkErrorMacro(<< this->GetLabel() << ": " << message);
  vtkShapeRequests::SilenceFailure(this->GetExecutive());
  return 0;
}

void vtkShapeAlgorithm::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Label: " << this->GetLabel() << "\n";
  for (const InputPort& port : this->InputPorts)
  {
    os << indent << "Input: " << port.Name << "\n";
  }
}
