#include "vtkShapeAtlas.h"

#include "vtkShapeAtlasInput.h"
#include "vtkShapeBlocks.h"
#include "vtkShapeComposite.h"
#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"
#include "vtkShapePreciseMap.h"

#include "vtkCompositeDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"
#include "vtkVariant.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <numeric>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkShapeAtlas);

namespace
{

constexpr int ScoresPort = 1, StatisticsPort = 2, AlignedPort = 3;

/// The rows of a table for the shapes.
struct AtlasRows
{
  std::vector<vtkIdType> Of; ///< for each shape
  std::string Found = "by order";
};

std::string ListColumns(vtkTable* table)
{
  std::string names;
  for (vtkIdType k = 0; k < table->GetNumberOfColumns(); ++k)
  {
    names += (k > 0 ? ", " : "") + std::string(table->GetColumnName(k));
  }
  return names;
}

/// By the first column of words that has the names of all shapes, or else by order.
AtlasRows FindRows(vtkTable* table, const std::vector<vtkShapeBlocks::Block>& blocks)
{
  AtlasRows rows;
  for (vtkIdType k = 0; k < table->GetNumberOfColumns(); ++k)
  {
    auto* words = vtkStringArray::SafeDownCast(table->GetColumn(k));
    std::map<std::string, vtkIdType> row;
    for (vtkIdType i = 0; words && i < words->GetNumberOfValues(); ++i)
    {
      row.emplace(words->GetValue(i), i);
    }
    rows.Of.clear();
    for (const vtkShapeBlocks::Block& block : blocks)
    {
      const auto found = row.find(block.Name);
      if (found != row.end() && !block.Name.empty())
      {
        rows.Of.push_back(found->second);
      }
    }
    if (rows.Of.size() == blocks.size())
    {
      rows.Found = table->GetColumnName(k);
      return rows;
    }
  }
  if (table->GetNumberOfRows() != static_cast<vtkIdType>(blocks.size()))
  {
    throw shape::InvalidInput("the Table has " + std::to_string(table->GetNumberOfRows()) +
      " rows for " + std::to_string(blocks.size()) +
      " shapes, and no column has the names of all blocks; give one row for each shape");
  }
  rows.Of.resize(blocks.size());
  std::iota(rows.Of.begin(), rows.Of.end(), 0);
  return rows;
}

vtkAbstractArray* FindColumn(vtkTable* table, const std::string& name, const std::string& property)
{
  if (!table)
  {
    throw shape::InvalidInput(
      property + " is the column '" + name + "', but there is no Table; connect it");
  }
  vtkAbstractArray* column = table->GetColumnByName(name.c_str());
  if (!column)
  {
    throw shape::InvalidInput("the Table has no column '" + name + "' for " + property +
      "; its columns are " + ListColumns(table));
  }
  return column;
}

/// Returns 0 or 1 for each shape. values: become the two values, ascending.
Eigen::VectorXd ReadGroups(
  vtkAbstractArray* column, const std::vector<vtkIdType>& rows, std::vector<std::string>& values)
{
  std::map<std::string, int> numbers;
  for (const vtkIdType row : rows)
  {
    numbers[column->GetVariantValue(row).ToString()] = 0;
  }
  if (numbers.size() != 2)
  {
    throw shape::InvalidInput("the Groups column '" + std::string(column->GetName()) + "' has " +
      std::to_string(numbers.size()) + " different values; two groups are compared");
  }
  numbers.rbegin()->second = 1;
  values = { numbers.begin()->first, numbers.rbegin()->first };
  Eigen::VectorXd groups(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    groups(static_cast<Eigen::Index>(i)) = numbers[column->GetVariantValue(rows[i]).ToString()];
  }
  return groups;
}

Eigen::VectorXd ReadNumbers(vtkAbstractArray* column, const std::vector<vtkIdType>& rows)
{
  Eigen::VectorXd values(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i)
  {
    bool valid = false;
    values(static_cast<Eigen::Index>(i)) = column->GetVariantValue(rows[i]).ToDouble(&valid);
    if (!valid)
    {
      throw shape::InvalidInput("the Regression column '" + std::string(column->GetName()) +
        "' has no number in row " + std::to_string(rows[i]) + "; choose a column of numbers");
    }
  }
  return values;
}

vtkSmartPointer<vtkIntArray> Numbered(const std::vector<int>& values, const std::string& name)
{
  return vtkShapeConvert::ToIntegers(
    Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size())),
    name);
}

/// The cells of the template with points at other positions.
void MoveTemplate(vtkPolyData* base, const Eigen::MatrixXd& positions, vtkPolyData* output)
{
  output->CopyStructure(base);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(vtkShapeConvert::ToArray(positions, "Points"));
  output->SetPoints(points);
}

void WriteScores(const shape::AtlasResult& result, const std::vector<vtkShapeBlocks::Block>& blocks,
  vtkTable* given, const AtlasRows& rows, vtkTable* output)
{
  std::vector<int> numbers(blocks.size());
  std::iota(numbers.begin(), numbers.end(), 0);
  output->AddColumn(Numbered(numbers, "Shape"));
  vtkNew<vtkStringArray> names;
  names->SetName("Name");
  for (const vtkShapeBlocks::Block& block : blocks)
  {
    names->InsertNextValue(block.Name);
  }
  output->AddColumn(names);
  const auto add = [&](const Eigen::VectorXd& values, const std::string& name)
  { output->AddColumn(vtkShapeConvert::ToArray(values, name)); };
  for (int k = 0; k < result.NumberOfModes; ++k)
  {
    add(result.Scores.col(k), "Score" + std::to_string(k));
  }
  add(result.Distances, "ProcrustesDistance");
  add(result.Sizes, "Size");
  add(result.Scales, "Scale");
  add(result.ReconstructionErrors, "ReconstructionError");
  add(result.MahalanobisDistances, "MahalanobisDistance");
  add(result.OutlierDistances, "OutlierDistance");
  output->AddColumn(Numbered(result.OutlierRanks, "OutlierRank"));
  for (vtkIdType k = 0; given && k < given->GetNumberOfColumns(); ++k)
  {
    vtkAbstractArray* column = given->GetColumn(k);
    if (output->GetColumnByName(column->GetName()))
    {
      continue;
    }
    const auto own = vtkSmartPointer<vtkAbstractArray>::Take(column->NewInstance());
    own->SetName(column->GetName());
    own->SetNumberOfComponents(column->GetNumberOfComponents());
    for (const vtkIdType row : rows.Of)
    {
      own->InsertNextTuple(row, column);
    }
    output->AddColumn(own);
  }
}

void WriteStatistics(const shape::AtlasResult& result, vtkTable* output)
{
  std::vector<int> modes(result.Variances.size());
  std::iota(modes.begin(), modes.end(), 1);
  output->AddColumn(Numbered(modes, "Modes"));
  output->AddColumn(vtkShapeConvert::ToArray(result.Variances, "Variance"));
  output->AddColumn(vtkShapeConvert::ToArray(result.Explained, "Explained"));
  output->AddColumn(vtkShapeConvert::ToArray(result.Generalisation, "Generalisation"));
  output->AddColumn(vtkShapeConvert::ToArray(result.Specificity, "Specificity"));
}

} // namespace

vtkShapeAtlas::vtkShapeAtlas()
{
  this->DeclareInput("Shapes", PortData::Pieces, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Template", PortData::WholePolygons, PortUse::Optional, { "vtkPolyData" });
  this->DeclareInput("Table", PortData::Table, PortUse::Optional, { "vtkTable" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkTable");
  this->DeclareOutput("vtkTable");
  this->DeclareOutput("vtkMultiBlockDataSet");
  this->DeclareFacts();
  this->DeclareMeasures({ "PositionDeviation" });
  this->DeclareShown(0, { "PositionDeviation" });
}

// 1. The surface of each block, and the template.
// 2. The shapes with the template's points.
// 3. Every process computes the same. The first one writes it.
void vtkShapeAtlas::Execute(const shape::Progress& progress)
{
  vtkMultiProcessController* controller = this->GetController();
  const std::vector<vtkShapeBlocks::Block> blocks =
    vtkShapeBlocks::Gather(this->GetInputDataObject(0, 0), controller);
  const vtkShapeAtlasInput::Population population = vtkShapeAtlasInput::Read(blocks,
    this->GetNumberOfInputConnections(1) > 0 ? this->GetGatheredInput(1).Data : nullptr,
    this->Correspondence, progress.Part(0.0, 0.2, "reading the shapes"));
  const Eigen::MatrixXd& places = population.Template.Points;

  // Only some processes may have the table.
  vtkSmartPointer<vtkTable> table;
  if (this->GetNumberOfInputConnections(2) > 0)
  {
    table = vtkSmartPointer<vtkTable>::New();
    if (auto* given = vtkTable::SafeDownCast(this->GetInputDataObject(2, 0)))
    {
      table->ShallowCopy(given);
    }
    vtkShapeGather::Share(controller, table);
  }
  AtlasRows rows;
  if (table)
  {
    rows = FindRows(table, blocks);
  }
  shape::AtlasVariables variables;
  std::vector<std::string> groups;
  if (vtkShapeConvert::IsChosen(this->Groups))
  {
    variables.Groups = ReadGroups(FindColumn(table, this->Groups, "Groups"), rows.Of, groups);
  }
  if (vtkShapeConvert::IsChosen(this->Regression))
  {
    variables.Covariate = ReadNumbers(FindColumn(table, this->Regression, "Regression"), rows.Of);
  }
  const shape::AtlasResult result = shape::BuildAtlas(population.Shapes,
    population.Template.Triangles, variables, this->Options, progress.Part(0.2, 1.0));
  if (result.NumberOfModes < this->Options.NumberOfModes)
  {
    this->Warn("Number Of Modes is " + std::to_string(this->Options.NumberOfModes) + ", but the " +
      std::to_string(blocks.size()) + " shapes have only " + std::to_string(result.NumberOfModes) +
      " modes; add shapes, or lower it");
  }
  if (population.LargestGap > 0.05)
  {
    this->Warn("the maps leave a part of the template uncovered: a point is " +
      std::to_string(population.LargestGap) +
      " of the longest side away from a mapped shape; map whole shapes");
  }
  if (controller && controller->GetLocalProcessId() != 0)
  {
    return;
  }

  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  // In the place of the template: a point that no triangle uses does not count.
  const Eigen::VectorXd areas = shape::ComputePointAreas(population.Template);
  const Eigen::RowVector3d centre = areas.transpose() * (places - result.Mean) / areas.sum();
  const auto place = [&](const Eigen::MatrixXd& points) -> Eigen::MatrixXd
  { return points.rowwise() + centre; };
  vtkShapeComposite::Move(population.TemplateData, place(result.Mean), output);
  const auto add = [&](const Eigen::MatrixXd& values, const std::string& name)
  { output->GetPointData()->AddArray(vtkShapeConvert::ToArray(values, name)); };
  add(places, "SourcePosition");
  for (int k = 0; k < result.NumberOfModes; ++k)
  {
    add(result.Modes.middleCols(3 * k, 3), "Mode" + std::to_string(k));
  }
  add(result.Deviations, "PositionDeviation");
  for (const std::string& name : vtkShapeAtlasInput::ListQuantities(blocks))
  {
    const shape::AtlasField field =
      shape::BuildAtlasField(result, vtkShapeAtlasInput::ReadQuantity(name, blocks, population));
    add(field.Mean, name + "Mean");
    add(field.Deviations, name + "Deviation");
    for (int k = 0; k < result.NumberOfModes; ++k)
    {
      add(field.Modes.col(k), name + "Mode" + std::to_string(k));
    }
  }
  const auto fact = [&](const std::string& name, const auto& value)
  { vtkShapeConvert::AddFact(output, "Atlas." + name, value); };
  fact("Shapes", static_cast<double>(blocks.size()));
  fact("NumberOfModes", result.NumberOfModes);
  fact("Template", population.TemplateNumber);
  fact("Explained", result.NumberOfModes > 0 ? result.Explained(result.NumberOfModes - 1) : 0.0);
  fact("Outlier",
    static_cast<double>(std::distance(result.OutlierRanks.begin(),
      std::find(result.OutlierRanks.begin(), result.OutlierRanks.end(), 0))));
  if (!population.Samples.empty())
  {
    fact("LargestGap", population.LargestGap);
  }
  if (table)
  {
    fact("TableRows", rows.Found);
  }
  const auto addTest = [&](const shape::PermutationTestResult& test, const std::string& prefix,
                         const std::string& slope, const std::string& arrays)
  {
    add(test.Slope, slope);
    add(test.PValues, arrays + "PValue");
    add(test.QValues, arrays + "QValue");
    fact(prefix + "PValue", test.PValue);
    fact(prefix + "RSquared", test.RSquared);
    fact(prefix + "Permutations", test.Permutations);
  };
  if (!groups.empty())
  {
    fact("FirstGroup", groups[0]);
    fact("SecondGroup", groups[1]);
    addTest(result.OfGroups, "Group", "GroupDifference", "");
  }
  if (variables.Covariate.size() > 0)
  {
    addTest(result.OfCovariate, "Regression", "Slope", "Slope");
    fact("RegressionMean", variables.Covariate.mean());
  }
  WriteScores(
    result, blocks, table, rows, vtkTable::SafeDownCast(this->GetOutputDataObject(ScoresPort)));
  WriteStatistics(result, vtkTable::SafeDownCast(this->GetOutputDataObject(StatisticsPort)));
  auto* aligned = vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(AlignedPort));
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    vtkNew<vtkPolyData> each;
    MoveTemplate(population.TemplateData, place(result.Aligned[i]), each);
    const auto number = static_cast<unsigned int>(i);
    aligned->SetBlock(number, each);
    aligned->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), blocks[i].Name.c_str());
  }
}
