#include "vtkShapeMapQuality.h"

#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"
#include "vtkShapeOwnCells.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"
#include "Quality/MapQuality.h"

#include <algorithm>

vtkStandardNewMacro(vtkShapeMapQuality);

vtkShapeMapQuality::vtkShapeMapQuality()
{
  this->DeclareInput("Input", PortData::Pieces, PortUse::Required, { "vtkDataSet" });
  this->DeclareOutputLikeInput();
  this->DeclareOutput("vtkTable");
  this->DeclareFacts();
  this->DeclareShown(0, { "SymmetricDirichlet" });
}

namespace
{

/// In the order of shape::MapMeasure.
const char* const MeasureNames[shape::MapMeasureCount] = { "JacobianDeterminant", "Dirichlet",
  "SymmetricDirichlet", "ConformalDistortion", "ARAP", "Hencky", "AMIPS", "AreaDistortion",
  "L2Stretch", "LinfStretch", "SmallestSingularValue", "LargestSingularValue" };

/// The map of a block, prepared for evaluation.
struct Part
{
  Eigen::MatrixXd Points;
  Eigen::MatrixXd Images;
  shape::CellSimplices Cells;
  Eigen::VectorXi Own; ///< for each cell 1, or 0 if it belongs to another process or is hidden
};

Part Prepare(vtkDataSet* data, const std::string& mapArray, const shape::Progress& progress)
{
  Part part;
  part.Points = vtkShapeConvert::ToPoints(data);
  part.Images = vtkShapeConvert::ToPointArray(data, mapArray, 3, "the Input");
  shape::RequireFinite(part.Points, "the Input");
  shape::RequireFinite(part.Images, "the map array '" + mapArray + "' of the Input");
  progress(0.3);
  part.Cells = vtkShapeConvert::ToSimplices(data, "the Input", progress.Part(0.3, 1.0));
  part.Own = vtkShapeOwnCells::Find(data);
  return part;
}

/// Computes the maximum of each over all parts and processes.
shape::MapExtent ComputeMapExtent(
  const std::vector<Part>& parts, vtkMultiProcessController* controller)
{
  double greatest[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  for (const Part& part : parts)
  {
    const shape::MapExtent e = shape::ComputeMapExtent(part.Points, part.Images, part.Cells);
    const double own[5] = { e.SourceHeight, e.SourceOffSphere, e.ImageHeight, e.ImageOffSphere,
      static_cast<double>(e.Dimension) };
    std::transform(
      own, own + 5, greatest, greatest, [](double a, double b) { return std::max(a, b); });
  }
  vtkShapeGather::Reduce(controller, greatest, 5, vtkShapeGather::Reduction::Maximum);
  return { greatest[0], greatest[1], greatest[2], greatest[3], static_cast<int>(greatest[4]) };
}

void AddOfAllProcesses(shape::MapQualitySums& sums, vtkMultiProcessController* controller)
{
  using vtkShapeGather::Reduction;
  constexpr int rows = shape::MapMeasureCount;
  vtkShapeGather::Reduce(controller, sums.Minima.data(), rows, Reduction::Minimum);
  vtkShapeGather::Reduce(controller, sums.Maxima.data(), rows, Reduction::Maximum);
  for (auto* values : { &sums.Sums, &sums.Weights, &sums.Undefined })
  {
    vtkShapeGather::Reduce(controller, values->data(), rows, Reduction::Sum);
  }
  for (double* count : { &sums.Cells, &sums.Flipped, &sums.Degenerate })
  {
    vtkShapeGather::Reduce(controller, count, 1, Reduction::Sum);
  }
}

void WriteCells(const shape::MapQualityResult& result, vtkDataSet* output)
{
  for (int measure = 0; measure < shape::MapMeasureCount; ++measure)
  {
    output->GetCellData()->AddArray(
      vtkShapeConvert::ToArray(result.Measures.col(measure), MeasureNames[measure]));
  }
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(result.Flipped, "Flipped"));
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(result.Degenerate, "Degenerate"));
}

const char* const SummaryNames[] = { "Minimum", "Mean", "Maximum", "Share" };

/// A row for each measure, a column for each of SummaryNames.
Eigen::MatrixXd Summary(const shape::MapQualitySums& sums)
{
  Eigen::MatrixXd summary(shape::MapMeasureCount, 4);
  for (int row = 0; row < shape::MapMeasureCount; ++row)
  {
    const auto measure = static_cast<shape::MapMeasure>(row);
    const double count =
      // For the determinant, this is the share of flipped cells. For other measures, it is the
      // share of undefined values.
      measure == shape::MapMeasure::JacobianDeterminant ? sums.Flipped : sums.Undefined(row);
    summary.row(row) << sums.Minima(row), sums.Mean(measure), sums.Maxima(row), count / sums.Cells;
  }
  return summary;
}

void WriteTable(const Eigen::MatrixXd& summary, vtkTable* output)
{
  vtkNew<vtkStringArray> names;
  names->SetName("Measure");
  for (const char* measure : MeasureNames)
  {
    names->InsertNextValue(measure);
  }
  output->AddColumn(names);
  for (int column = 0; column < summary.cols(); ++column)
  {
    output->AddColumn(vtkShapeConvert::ToArray(summary.col(column), SummaryNames[column]));
  }
}

void WriteFacts(
  const shape::MapQualitySums& sums, const Eigen::MatrixXd& summary, vtkDataObject* output)
{
  const auto add = [&](const std::string& fact, double value)
  { vtkShapeConvert::AddFact(output, "MapQuality." + fact, value); };
  add("Cells", sums.Cells);
  add("FlippedCells", sums.Flipped);
  add("DegenerateCells", sums.Degenerate);
  for (int row = 0; row < summary.rows(); ++row)
  {
    for (int column = 0; column < summary.cols(); ++column)
    {
      add(std::string(SummaryNames[column]) + MeasureNames[row], summary(row, column));
    }
  }
}

} // namespace

// 1. Read all blocks of this process (Prepare).
// 2. Find the extent of the whole map, on all processes together.
// 3. Measure block by block, without the ghost cells in the sums.
// 4. Add up the sums of all processes.
void vtkShapeMapQuality::Execute(const shape::Progress& progress)
{
  vtkDataObject* input = this->GetInputDataObject(0, 0);
  vtkDataObject* measured = this->GetOutputDataObject(0);
  vtkMultiProcessController* controller = this->GetController();
  std::vector<Part> parts;
  double done = 0.0;
  const double share =
    0.3 / std::max<vtkIdType>(1, input->GetNumberOfElements(vtkDataObject::POINT));
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]
    {
      vtkShapeComposite::ForEach(input, measured, vtkShapeComposite::Points::Kept,
        [&](vtkDataSet* from, vtkDataSet* to)
        {
          to->ShallowCopy(from);
          const double next = done + share * from->GetNumberOfPoints();
          parts.push_back(
            Prepare(from, this->MapArray, progress.Part(done, next, "reading the cells")));
          done = next;
        });
      progress(0.3);
    });
  // Whether the map is planar, spherical or spatial must be decided for all blocks and processes
  // together.
  const shape::MapExtent extent = ComputeMapExtent(parts, controller);
  shape::MapQualitySums sums;
  vtkShapeGather::RunOnAllOrFail(controller,
    [&]
    {
      const std::vector<vtkDataSet*> leaves = vtkShapeComposite::Of(measured);
      for (std::size_t i = 0; i < parts.size(); ++i)
      {
        const double begin = 0.3 + 0.65 * i / parts.size(), end = begin + 0.65 / parts.size();
        const Part& part = parts[i];
        const shape::MapQualityResult result = shape::EvaluateMapQuality(part.Points, part.Images,
          part.Cells, extent, progress.Part(begin, end, "measuring the distortion"));
        WriteCells(result, leaves[i]);
        sums.Add(result, part.Own);
      }
    });
  AddOfAllProcesses(sums, controller);
  if (sums.Weights(0) == 0.0)
  {
    throw shape::InvalidInput(sums.Cells == 0.0
        ? "the Input has no surface or solid cells; points and lines have no Jacobian"
        : "none of the Input's " + std::to_string(static_cast<long long>(sums.Cells)) +
          " cells has an area or volume; check the coordinates");
  }
  const Eigen::MatrixXd summary = Summary(sums);
  WriteFacts(sums, summary, measured);
  // Every process has the same sums, and one of them outputs them.
  if (!controller || controller->GetLocalProcessId() == 0)
  {
    WriteTable(summary, vtkTable::SafeDownCast(this->GetOutputDataObject(1)));
  }
}
