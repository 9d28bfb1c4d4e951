#include "vtkShapeSynthesize.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"
#include "vtkShapeList.h"
#include "vtkShapeRequests.h"
#include "vtkShapeSynthesizedData.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

vtkStandardNewMacro(vtkShapeSynthesize);

vtkShapeSynthesize::vtkShapeSynthesize()
  : Carried(std::make_unique<vtkShapeSynthesizedData>())
{
  this->DeclareInput("Atlas", PortData::WholeSurface, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Data", PortData::Pieces, PortUse::Optional, { "vtkDataSet" });
  this->DeclareMovedOutput();
  this->DeclareMovedOutput(1);
  this->DeclareFacts();
  this->DeclareMeasures({ "Inverted", "ScaledJacobian" });
  this->DeclareMemoryRemedy("lower Tetrahedra");
}

vtkShapeSynthesize::~vtkShapeSynthesize() = default;

void vtkShapeSynthesize::SetNumberOfWeights(int count)
{
  vtkShapeList::Resize(this, this->Weights, count);
}

void vtkShapeSynthesize::SetWeights(int mode, double weight)
{
  vtkShapeList::Set(this, "Weights", this->Weights, mode, { weight });
}

void vtkShapeSynthesize::DescribeOutputs(vtkInformationVector**, vtkInformationVector* outputs)
{
  if (this->Animate >= 0)
  {
    vtkShapeRequests::OfferUnitTime(outputs);
  }
}

/// While a mode is animated, the inputs are always read at their own first time.
void vtkShapeSynthesize::RequestInputs(vtkInformationVector** inputs, vtkInformationVector*)
{
  if (this->Animate >= 0)
  {
    vtkShapeRequests::RequestFirstTimes(this->GetNumberOfInputPorts(), inputs);
  }
}

namespace
{

const std::string Facts = "Synthesize.";
const std::string AtlasRemedy = "connect the mean shape of Shape Atlas";

/// Returns the number of arrays `<name>Mode0`, `<name>Mode1`, ... without a gap.
int CountModes(vtkDataSet* data, const std::string& name)
{
  int count = 0;
  while (data->GetPointData()->HasArray((name + "Mode" + std::to_string(count)).c_str()))
  {
    ++count;
  }
  return count;
}

/// Returns the modes side by side (n x components k).
Eigen::MatrixXd ReadModes(vtkDataSet* data, const std::string& name, int modes, int components)
{
  Eigen::MatrixXd values(data->GetNumberOfPoints(), static_cast<Eigen::Index>(components) * modes);
  for (int k = 0; k < modes; ++k)
  {
    const std::string array = name + "Mode" + std::to_string(k);
    values.middleCols(static_cast<Eigen::Index>(components) * k, components) =
      vtkShapeConvert::ToPointArray(data, array, components, "the Atlas", AtlasRemedy);
    shape::RequireFinite(values.middleCols(static_cast<Eigen::Index>(components) * k, components),
      "the array '" + array + "' of the Atlas");
  }
  return values;
}

/// Throws unless the arrays `Mode0`, `Mode1`, ... have no gap. Returns their number.
int RequireModes(vtkDataSet* data)
{
  const int modes = CountModes(data, "");
  if (modes == 0)
  {
    throw shape::InvalidInput(
      "the Atlas has no point array 'Mode0' of 3 components; " + AtlasRemedy);
  }
  for (int i = 0; i < data->GetPointData()->GetNumberOfArrays(); ++i)
  {
    const std::string name =
      data->GetPointData()->GetArrayName(i) ? data->GetPointData()->GetArrayName(i) : "";
    const std::string digits = name.substr(std::min<std::size_t>(4, name.size()));
    if (name.compare(0, 4, "Mode") == 0 && !digits.empty() && digits.size() < 7 &&
      std::all_of(digits.begin(), digits.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
      std::stoi(digits) >= modes)
    {
      throw shape::InvalidInput("the Atlas has the point array '" + name + "', but no 'Mode" +
        std::to_string(modes) + "'; number the modes from 0 without a gap");
    }
  }
  return modes;
}

/// Adds `<Name>` for each quantity with the arrays `<Name>Mean` and `<Name>Mode0`, ...
void AddQuantities(vtkDataSet* from, const Eigen::VectorXd& weights, vtkDataSet* to)
{
  const std::string end = "Mean";
  for (int i = 0; i < from->GetPointData()->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* mean = from->GetPointData()->GetArray(i);
    const std::string array = mean && mean->GetName() ? mean->GetName() : "";
    if (array.size() <= end.size() || array.substr(array.size() - end.size()) != end)
    {
      continue;
    }
    const std::string name = array.substr(0, array.size() - end.size());
    const int modes = std::min(CountModes(from, name), static_cast<int>(weights.size()));
    if (modes == 0)
    {
      continue; // a mean of something else
    }
    const int components = mean->GetNumberOfComponents();
    shape::ModeValues values;
    values.Mean = vtkShapeConvert::ToPointArray(from, array, components, "the Atlas");
    shape::RequireFinite(values.Mean, "the array '" + array + "' of the Atlas");
    values.Modes = ReadModes(from, name, modes, components);
    to->GetPointData()->AddArray(
      vtkShapeConvert::ToArray(shape::Synthesize(values, weights.head(modes)), name));
  }
}

/// Returns the mean and the modes of a piece or of the whole Atlas.
shape::ModeValues ReadShape(vtkDataSet* data, int modes)
{
  shape::ModeValues shape;
  shape.Mean = vtkShapeConvert::ToPoints(data);
  shape::RequireFinite(shape.Mean, "the Atlas");
  shape.Modes = ReadModes(data, "", modes, 3);
  return shape;
}

} // namespace

Eigen::VectorXd vtkShapeSynthesize::ReadWeights(int modes)
{
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(modes);
  for (int k = 0; k < static_cast<int>(this->Weights.size()) && k < modes; ++k)
  {
    weights(k) = this->Weights[k];
  }
  shape::RequireFinite(weights, "the list Weights");
  if (static_cast<int>(this->Weights.size()) > modes)
  {
    std::ostringstream words;
    words << "there are " << this->Weights.size() << " Weights, but the Atlas has " << modes
          << " modes; not used are number " << modes;
    if (static_cast<int>(this->Weights.size()) > modes + 1)
    {
      words << " to " << this->Weights.size() - 1;
    }
    this->Warn(words.str() + ", counted from 0");
  }
  if (this->Animate >= 0)
  {
    if (this->Animate >= modes)
    {
      throw shape::InvalidInput("Animate is " + std::to_string(this->Animate) +
        ", but the Atlas has the modes 0 to " + std::to_string(modes - 1) +
        "; choose one of them, or -1");
    }
    const double time = vtkShapeRequests::GetUnitTime(this->GetOutputInformation(0));
    weights(this->Animate) = this->Amplitude * std::sin(2.0 * M_PI * time);
    for (const int port : { 0, 1 })
    {
      this->GetOutputDataObject(port)->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
    }
  }
  return weights;
}

// 1. The sample is the sum of the mean and the weighted modes.
// 2. The maps of Data are solved for, unless the inputs are those of the last call.
// 3. They are added, and the moved cells are checked.
void vtkShapeSynthesize::Execute(const shape::Progress& progress)
{
  shape::RequireOption(this->Animate >= -1, "Animate", this->Animate, "at least -1");
  shape::RequireOption(this->Amplitude >= 0.0 && std::isfinite(this->Amplitude), "Amplitude",
    this->Amplitude, "at least 0 and finite");
  shape::RequireValid(this->Options);
  const shape::Progress making = progress.Part(0.0, 0.1, "making the sample");
  vtkPolyData* whole = this->GetGatheredInput(0).Data;
  const int modes = RequireModes(whole);
  vtkShapeAtlasShape atlas;
  atlas.Images = ReadShape(whole, modes);
  making(0.4);
  const Eigen::VectorXd weights = this->ReadWeights(modes);
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkShapeComposite::ForEach(this->GetInputDataObject(0, 0), output,
    vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      if (from->GetNumberOfPoints() == 0)
      {
        return; // an empty piece may have no arrays
      }
      vtkShapeComposite::Move(from, shape::Synthesize(ReadShape(from, modes), weights), to);
      AddQuantities(from, weights, to);
    });
  making(0.8);
  const auto addFacts = [&](vtkDataObject* to)
  {
    to->GetAttributesAsFieldData(vtkDataObject::FIELD)
      ->AddArray(vtkShapeConvert::ToArray(weights, "Weights"));
  };
  addFacts(output);
  vtkShapeConvert::AddFact(output, Facts + "Modes", modes);
  making(1.0);
  if (this->GetNumberOfInputConnections(1) == 0)
  {
    progress(1.0);
    return;
  }

  const shape::Mesh mean = vtkShapeConvert::ToMesh(whole, "the Atlas");
  Eigen::MatrixXd sources = vtkShapeConvert::ToPointArray(
    whole, "SourcePosition", 3, "the Atlas", AtlasRemedy + ", or disconnect Data");
  shape::RequireFinite(sources, "the SourcePosition of the Atlas");
  atlas.Template = shape::Surface(std::move(sources), mean.Triangles);
  const shape::Surface sample = atlas.Template.WithPoints(shape::Synthesize(atlas.Images, weights));
  this->Carried->Prepare(*this, whole, atlas, this->Options, progress.Part(0.1, 0.8));
  vtkMultiProcessController* controller = this->GetController();
  // The pieces of several processes cannot be repaired one by one with the same result.
  const bool isDistributed = controller && controller->GetNumberOfProcesses() > 1;
  shape::SynthesizeOptions options = this->Options;
  options.Untangle = options.Untangle && !isDistributed;
  options.WantedScaledJacobian = isDistributed ? 0.0 : options.WantedScaledJacobian;
  vtkShapeSynthesizedData::Result result;
  vtkShapeGather::RunOnAllOrFail(controller,
    [&] {
      result = this->Carried->Move(*this, atlas, sample, weights, options, progress.Part(0.8, 1.0));
    });

  double sums[] = { result.InvertedBefore, result.InvertedAfter, result.BoundaryPoints,
    result.NotUntangled, result.Hexahedra };
  double maxima[] = { this->Carried->TemplateDistance(), result.BoundaryDistance,
    -result.MinimumScaledJacobian };
  vtkShapeGather::Reduce(controller, sums, 5, vtkShapeGather::Reduction::Sum);
  vtkShapeGather::Reduce(controller, maxima, 3, vtkShapeGather::Reduction::Maximum);
  const double outside = vtkShapeGather::CountOnce(controller, result.Outside);
  vtkDataObject* moved = this->GetOutputDataObject(1);
  addFacts(moved);
  const auto fact = [&](const char* name, double value)
  { vtkShapeConvert::AddFact(moved, Facts + name, value); };
  fact("Tetrahedra", this->Carried->Tetrahedra());
  fact("OutsidePoints", outside);
  fact("TemplateDistance", maxima[0]);
  fact("InvertedBefore", sums[0]);
  fact("InvertedAfter", sums[1]);
  if (sums[4] > 0.0)
  {
    fact("MinimumScaledJacobian", -maxima[2]);
  }
  fact("BoundaryPoints", sums[2]);
  fact("BoundaryDistance", maxima[1] / shape::ComputeLongestBoxEdge(sample));
  const bool isRepaired = this->Options.Untangle && !isDistributed;
  this->WarnOfResult(outside, maxima[0], sums[3], isRepaired ? sums[1] - sums[3] : 0.0);
  if (isDistributed && sums[1] > 0.0)
  {
    this->Warn("inverted cells of Data on several processes are not untangled; apply Shape "
               "Untangle, or use one process");
  }
}

void vtkShapeSynthesize::WarnOfResult(
  double outside, double farthest, double notUntangled, double left)
{
  std::ostringstream words;
  if (outside > 0.0)
  {
    words << outside << " points of the Data are outside the template, the farthest by "
          << 100.0 * farthest
          << " % of its longest side; they keep their positions: Data must be in "
          << "the coordinates of SourcePosition of the Atlas";
    this->Warn(words.str());
  }
  if (notUntangled > 0.0)
  {
    words.str("");
    words << notUntangled << " cells are inverted and not untangled, since their block has cells "
          << "other than tetrahedra, pyramids, wedges and hexahedra; extract these with Extract "
          << "Cells By Type";
    this->Warn(words.str());
  }
  if (left > 0.0)
  {
    words.str("");
    words << left << " cells stay inverted, as the array Inverted shows: the surface of the sample "
          << "folds, or the cells do not fit into it; use smaller Weights, or smaller cells";
    this->Warn(words.str());
  }
}
