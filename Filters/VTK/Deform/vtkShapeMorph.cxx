#include "vtkShapeMorph.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"
#include "vtkShapeHandle.h"
#include "vtkShapeList.h"
#include "vtkShapeRequests.h"
#include "vtkShapeWholeRows.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataObjectTypes.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "Deform/Morph.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

vtkStandardNewMacro(vtkShapeMorph);

/// The rigid morph of the last run, which fits all times and weights while the inputs stay the
/// same.
struct vtkShapeMorph::Kept
{
  const shape::RigidMorph& Prepare(const shape::ShapeElements& shape,
    const std::vector<Eigen::MatrixXd>& targets, const shape::Progress& progress)
  {
    const auto same = [](const auto& a, const auto& b)
    { return a.rows() == b.rows() && a.cols() == b.cols() && a == b; };
    const bool isKnown = this->Morph && same(this->Shape.Points, shape.Points) &&
      same(this->Shape.Lines, shape.Lines) && same(this->Shape.Triangles, shape.Triangles) &&
      same(this->Shape.Tetrahedra, shape.Tetrahedra) && this->Targets.size() == targets.size() &&
      std::equal(targets.begin(), targets.end(), this->Targets.begin(), same);
    if (!isKnown)
    {
      this->Morph.reset();
      this->Morph.emplace(shape, targets, progress);
      this->Shape = shape;
      this->Targets = targets;
    }
    return *this->Morph;
  }

private:
  shape::ShapeElements Shape;
  std::vector<Eigen::MatrixXd> Targets;
  std::optional<shape::RigidMorph> Morph;
};

vtkShapeMorph::vtkShapeMorph()
  : Cache(std::make_unique<Kept>())
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Targets", PortData::Pieces, PortUse::OptionalRepeatable, { "vtkDataSet" });
  this->DeclareMovedOutput();
}

vtkShapeMorph::~vtkShapeMorph() = default;

void vtkShapeMorph::AddTargets(vtkAlgorithmOutput* target)
{
  this->AddInputConnection(1, target);
}

void vtkShapeMorph::RemoveAllTargets()
{
  this->SetInputConnection(1, nullptr);
}

void vtkShapeMorph::SetNumberOfWeights(int count)
{
  vtkShapeList::Resize(this, this->Weights, count);
}

void vtkShapeMorph::SetWeights(int index, double weight)
{
  vtkShapeList::Set(this, "Weights", this->Weights, index, { weight });
}

void vtkShapeMorph::DescribeOutputs(vtkInformationVector**, vtkInformationVector* outputs)
{
  vtkShapeRequests::OfferUnitTime(outputs);
}

/// The output's time is the parameter of the morph; each input is read at its own first time.
void vtkShapeMorph::RequestInputs(vtkInformationVector** inputs, vtkInformationVector*)
{
  vtkShapeRequests::RequestFirstTimes(this->GetNumberOfInputPorts(), inputs);
}

namespace
{

/// The points of one block of the input, here and in the targets.
struct MorphBlock
{
  Eigen::MatrixXd Points;
  std::vector<Eigen::MatrixXd> Targets;
};

void RequireSameBlocks(const std::vector<vtkDataSet*>& blocks,
  const std::vector<vtkDataSet*>& targets, const std::string& name)
{
  if (targets.size() != blocks.size())
  {
    throw shape::InvalidInput(name + " has " + std::to_string(targets.size()) +
      " blocks, and the Input has " + std::to_string(blocks.size()) +
      "; connect targets with the blocks of the Input");
  }
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (targets[i]->GetNumberOfPoints() != blocks[i]->GetNumberOfPoints())
    {
      throw shape::InvalidInput(name + " has " + std::to_string(targets[i]->GetNumberOfPoints()) +
        " points, and the Input has " + std::to_string(blocks[i]->GetNumberOfPoints()) +
        "; connect the same shape in another pose, or map other shapes by Shape Correspondence");
    }
  }
}

Eigen::MatrixXd Blend(const MorphBlock& block, const std::vector<double>& weights)
{
  Eigen::MatrixXd moved = block.Points;
  for (std::size_t i = 0; i < weights.size(); ++i)
  {
    moved += weights[i] * (block.Targets[i] - block.Points);
  }
  return moved;
}

std::string NameOfTarget(std::size_t target)
{
  return "Morph.Target" + std::to_string(target);
}

} // namespace

std::vector<double> vtkShapeMorph::BlendWeights(std::size_t targets)
{
  if (this->Weights.empty())
  {
    return std::vector<double>(targets, 1.0 / static_cast<double>(targets));
  }
  if (this->Weights.size() > targets)
  {
    this->Warn("there are " + std::to_string(this->Weights.size()) + " Weights for " +
      std::to_string(targets) + " targets; the others are not used");
  }
  std::vector<double> weights = this->Weights;
  weights.resize(targets, 0.0);
  return weights;
}

void vtkShapeMorph::Execute(const shape::Progress& progress)
{
  const shape::Progress reading = progress.Part(0.0, 0.3, "reading the targets");
  const shape::Progress writing = progress.Part(0.9, 1.0, "moving the points");
  const double requested = vtkShapeRequests::GetUnitTime(this->GetOutputInformation(0));
  const double time = this->Animate ? requested : 1.0;
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  vtkDataObject* output = this->GetOutputDataObject(0);
  vtkMultiProcessController* controller = this->GetController();
  const int connections = this->GetNumberOfInputConnections(1);

  std::vector<MorphBlock> blocks;
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]
    {
      const std::vector<vtkDataSet*> from = vtkShapeComposite::Of(input);
      for (vtkDataSet* block : from)
      {
        blocks.push_back({ vtkShapeConvert::ToPoints(block), {} });
        shape::RequireFinite(blocks.back().Points, "the Input");
        if (connections == 0)
        {
          blocks.back().Targets.push_back(
            vtkShapeConvert::ToPointArray(block, this->MapArray, 3, "the Input"));
          shape::RequireFinite(blocks.back().Targets.back(), "the map array of the Input");
        }
      }
      reading(0.5);
      for (int i = 0; i < connections; ++i)
      {
        const std::string name = "target " + std::to_string(i) + " of Targets";
        const std::vector<vtkDataSet*> to = vtkShapeComposite::Of(this->GetInputDataObject(1, i));
        RequireSameBlocks(from, to, name);
        for (std::size_t k = 0; k < to.size(); ++k)
        {
          blocks[k].Targets.push_back(vtkShapeConvert::ToPoints(to[k]));
          shape::RequireFinite(blocks[k].Targets.back(), name);
        }
      }
    });
  reading(1.0);
  std::vector<double> weights =
    this->BlendWeights(connections == 0 ? 1 : static_cast<std::size_t>(connections));
  for (double& weight : weights)
  {
    weight *= time;
  }

  std::vector<Eigen::MatrixXd> moved;
  if (this->Path == PathType::Straight)
  {
    for (const MorphBlock& block : blocks)
    {
      moved.push_back(Blend(block, weights));
    }
  }
  else
  {
    std::vector<vtkShapeComposite::PointField> fields;
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      Eigen::Index rows = 0;
      for (const MorphBlock& block : blocks)
      {
        rows += block.Points.rows();
      }
      fields.push_back({ NameOfTarget(i), Eigen::MatrixXd(rows, 3) });
      rows = 0;
      for (const MorphBlock& block : blocks)
      {
        fields.back().Values.middleRows(rows, block.Points.rows()) = block.Targets[i];
        rows += block.Points.rows();
      }
    }
    const auto named = vtkSmartPointer<vtkDataObject>::Take(vtkDataObjectTypes::NewDataObject(
      vtkShapeComposite::FindOutputType(input, vtkShapeComposite::Points::Kept).c_str()));
    vtkShapeComposite::AddPointFields(input, named, fields);
    const vtkSmartPointer<vtkUnstructuredGrid> grid = vtkShapeGather::GatherGrid(named, controller);
    const shape::ShapeElements shape = vtkShapeHandle::ToElements(grid, "the Input");
    std::vector<Eigen::MatrixXd> targets;
    for (std::size_t i = 0; i < weights.size(); ++i)
    {
      targets.push_back(vtkShapeConvert::ToPointArray(grid, NameOfTarget(i), 3, "the Input"));
    }
    const shape::RigidMorph& morph =
      this->Cache->Prepare(shape, targets, progress.Part(0.3, 0.8, "preparing the motion"));
    const Eigen::MatrixXd whole = morph.At(weights, progress.Part(0.8, 0.9, "moving the points"));
    const Eigen::MatrixXd joined = shape::JoinPositions(shape.Points, targets);
    vtkShapeWholeRows rows(joined);
    for (const MorphBlock& block : blocks)
    {
      moved.push_back(
        vtkShapeConvert::Rows(whole, rows.Find(shape::JoinPositions(block.Points, block.Targets))));
    }
  }
  writing(0.0);
  std::size_t next = 0;
  vtkShapeComposite::ForEach(input, output, vtkShapeComposite::Points::Moved,
    [&](vtkDataSet* from, vtkDataSet* to)
    {
      vtkShapeComposite::Move(from, moved[next], to);
      to->GetPointData()->AddArray(vtkShapeConvert::ToArray(blocks[next].Points, "SourcePosition"));
      ++next;
      writing(static_cast<double>(next) / static_cast<double>(blocks.size()));
    });
  output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), requested);
}
