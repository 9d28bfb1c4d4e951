#include "vtkShapeCoupling.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeHandle.h"
#include "vtkShapeMapColors.h"

#include "Base/Errors.h"
#include "Search/PointTree.h"

#include "vtkDataSet.h"
#include "vtkIdTypeArray.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkShapeCoupling);

namespace
{

constexpr int TablePort = 3; // of the outputs

/// The points that samples are, as a column of ids.
vtkSmartPointer<vtkIdTypeArray> PointIds(
  const std::string& name, const std::vector<int>& samples, const std::vector<int>& indices)
{
  auto ids = vtkSmartPointer<vtkIdTypeArray>::New();
  ids->SetName(name.c_str());
  ids->SetNumberOfTuples(static_cast<vtkIdType>(indices.size()));
  std::transform(
    indices.begin(), indices.end(), ids->GetPointer(0), [&](int index) { return samples[index]; });
  return ids;
}

} // namespace

vtkShapeCoupling::vtkShapeCoupling()
{
  this->DeclareInput("ShapeA", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("ShapeB", PortData::WholeGrid, PortUse::Required, { "vtkDataSet" });
  this->DeclareInput("Landmarks", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareInput("TargetLandmarks", PortData::WholeGrid, PortUse::Optional, { "vtkDataSet" });
  this->DeclareOutputLikeInput(0);
  this->DeclareOutputLikeInput(1);
  this->DeclareFacts();
  this->DeclareOutput("vtkTable"); // TablePort
  this->DeclareShown(0, { "MapColors" });
  this->DeclareShown(1, { "MapColors" });
  this->DeclareMemoryRemedy("lower Samples");
}

shape::Landmarks vtkShapeCoupling::ReadLandmarks(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b)
{
  const bool hasTargets = this->GetNumberOfInputConnections(3) > 0;
  if (this->GetNumberOfInputConnections(2) == 0)
  {
    if (hasTargets)
    {
      throw shape::InvalidInput("there are TargetLandmarks without Landmarks; connect both");
    }
    return {};
  }
  vtkUnstructuredGrid* grid = this->GetGatheredInput(2).Grid;
  const Eigen::MatrixXd onA = vtkShapeConvert::ToPoints(grid),
                        onB = hasTargets ? vtkShapeConvert::ToPoints(this->GetGatheredInput(3).Grid)
                                         : vtkShapeConvert::ToPointArray(grid, "TargetPosition", 3,
                                             "the input Landmarks", "make it with Shape Landmarks");
  if (onA.rows() != onB.rows())
  {
    throw shape::InvalidInput("Landmarks has " + std::to_string(onA.rows()) +
      " points, and TargetLandmarks has " + std::to_string(onB.rows()) +
      "; connect equally many, because they are paired by order");
  }
  const shape::PointTree nearA(a), nearB(b);
  shape::Landmarks landmarks;
  for (Eigen::Index i = 0; i < onA.rows(); ++i)
  {
    landmarks.push_back(
      { nearA.Nearest(onA.row(i), 1).front(), nearB.Nearest(onB.row(i), 1).front() });
  }
  return landmarks;
}

void vtkShapeCoupling::WriteImages(int port, const Eigen::VectorXi& images,
  const Eigen::MatrixXd& targets, const std::vector<int>& samples, const Eigen::VectorXd& weights)
{
  // The gathered shape has each point of this process at the same position.
  const shape::PointTree whole(vtkShapeConvert::ToPoints(this->GetGatheredInput(port).Grid));
  std::vector<int> own;
  for (vtkDataSet* leaf : vtkShapeComposite::Of(this->GetInputDataObject(port, 0)))
  {
    const Eigen::MatrixXd points = vtkShapeConvert::ToPoints(leaf);
    for (const auto& position : points.rowwise())
    {
      own.push_back(whole.Nearest(position, 1).front());
    }
  }
  Eigen::VectorXd weightOf = Eigen::VectorXd::Zero(images.size());
  weightOf(samples) = weights;
  vtkShapeComposite::AddPointFields(this->GetInputDataObject(port, 0),
    this->GetOutputDataObject(port),
    { { "TargetPosition", vtkShapeConvert::Rows(targets(images, Eigen::all), own) },
      { "TargetPointId", vtkShapeConvert::Rows(images.cast<double>(), own), true },
      { "SampleWeight", vtkShapeConvert::Rows(weightOf, own) } });
}

/// Every process computes the same coupling from the gathered shapes, and writes the rows of its
/// own points.
void vtkShapeCoupling::Execute(const shape::Progress& progress)
{
  shape::RequireOption(this->SmallestMass >= 0.0 && this->SmallestMass <= 1.0, "SmallestMass",
    this->SmallestMass, "between 0 and 1");
  const shape::ShapeElements a = vtkShapeHandle::ToElements(
                               this->GetGatheredInput(0).Grid, "ShapeA", progress.Part(0.0, 0.02)),
                             b = vtkShapeHandle::ToElements(
                               this->GetGatheredInput(1).Grid, "ShapeB", progress.Part(0.02, 0.04));
  const shape::Landmarks landmarks = this->ReadLandmarks(a.Points, b.Points);
  const shape::ShapeCouplingResult result =
    shape::CoupleShapes(a, b, landmarks, this->Options, progress.Part(0.04, 1.0));
  const shape::SampledCoupling& coupling = result.Coupling;
  this->WriteImages(0, result.ImagesOfA, b.Points, coupling.SamplesOfA, coupling.WeightsOfA);
  this->WriteImages(1, result.ImagesOfB, a.Points, coupling.SamplesOfB, coupling.WeightsOfB);
  const shape::Mesh targets{ b.Points, Eigen::MatrixXi(0, 3) };
  vtkShapeMapColors::Add(this->GetOutputDataObject(0), "TargetPosition", targets);
  vtkShapeMapColors::Add(this->GetOutputDataObject(1), "", targets);
  const shape::CouplingEntries entries = shape::ListEntries(coupling.Masses, this->SmallestMass);
  if (!this->GetController() || this->GetController()->GetLocalProcessId() == 0)
  {
    auto* table = vtkTable::SafeDownCast(this->GetOutputDataObject(TablePort));
    table->AddColumn(PointIds("SampleOfA", coupling.SamplesOfA, entries.OfA));
    table->AddColumn(PointIds("SampleOfB", coupling.SamplesOfB, entries.OfB));
    table->AddColumn(vtkShapeConvert::ToArray(entries.Masses, "Mass"));
  }
  for (const int port : { 0, 1 })
  {
    const auto add = [&](const std::string& fact, double value)
    { vtkShapeConvert::AddFact(this->GetOutputDataObject(port), "Coupling." + fact, value); };
    add("Distortion", result.Distortion);
    add("Error", result.Error);
    add("Omitted", entries.Omitted);
    add("Landmarks", static_cast<double>(landmarks.size()));
  }
}
