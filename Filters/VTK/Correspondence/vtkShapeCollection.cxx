#include "vtkShapeCollection.h"

#include "vtkShapeBlocks.h"
#include "vtkShapeConvert.h"
#include "vtkShapePreciseMap.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIntArray.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkStringArray.h"
#include "vtkTable.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeCollection);

namespace
{

/// The outputs that are tables.
constexpr int ShapesPort = 1, DistancesPort = 2, OperatorsPort = 3;

/// Reads the map of a shape onto the template.
shape::SurfacePoints ReadImages(vtkPolyData* data, const std::string& name,
  vtkPolyData* templateData, const shape::Surface& base, const shape::Progress& progress)
{
  if (vtkShapePreciseMap::Has(data, vtkShapePreciseMap::Position))
  {
    return vtkShapePreciseMap::Read(
      data, name, vtkShapePreciseMap::ToSurface(templateData, "Template"), "Template");
  }
  const Eigen::MatrixXd images =
    vtkShapeConvert::ToPointArray(data, vtkShapePreciseMap::Position, 3, name,
      "make it with Shape Correspondence, from this shape to "
      "the Template");
  shape::RequireFinite(images, "TargetPosition of " + name);
  return shape::SurfaceLocator(base).Find(images, progress);
}

vtkSmartPointer<vtkIntArray> Numbers(const std::vector<int>& values, const std::string& name)
{
  return vtkShapeConvert::ToIntegers(
    Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size())),
    name);
}

} // namespace

vtkShapeCollection::vtkShapeCollection()
{
  this->DeclareInput("Shapes", PortData::Pieces, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Template", PortData::WholePolygons, PortUse::Optional, { "vtkPolyData" });
  this->DeclareOutput("vtkPolyData");
  this->DeclareOutput("vtkTable");
  this->DeclareOutput("vtkTable");
  this->DeclareOutput("vtkTable");
  this->DeclareFacts();
  this->DeclareMeasures({ "AreaDeviation", "ConformalDeviation", "AreaVariationFunctions",
    "ConformalVariationFunctions", "PositionDeviation" });
  this->DeclareShown(0, { "AreaDeviation" });
  this->DeclareMemoryRemedy("lower Basis Size");
}

void vtkShapeCollection::WriteTables(
  const shape::CollectionResult& result, const std::vector<std::string>& names)
{
  const auto table = [&](int port)
  { return vtkTable::SafeDownCast(this->GetOutputDataObject(port)); };
  const auto addColumns =
    [](const Eigen::MatrixXd& matrix, const std::string& name, vtkTable* output)
  {
    for (Eigen::Index column = 0; column < matrix.cols(); ++column)
    {
      output->AddColumn(
        vtkShapeConvert::ToArray(matrix.col(column), name + std::to_string(column)));
    }
  };
  const int count = static_cast<int>(names.size());
  std::vector<int> numbers(count), ranks(count);
  vtkNew<vtkStringArray> words;
  words->SetName("Name");
  for (int i = 0; i < count; ++i)
  {
    numbers[i] = i;
    ranks[result.Order[i]] = i;
    words->InsertNextValue(names[i].c_str());
  }
  vtkTable* shapes = table(ShapesPort);
  shapes->AddColumn(Numbers(numbers, "Shape"));
  shapes->AddColumn(words);
  shapes->AddColumn(vtkShapeConvert::ToArray(result.Dissimilarities, "Dissimilarity"));
  shapes->AddColumn(Numbers(ranks, "Rank"));
  addColumns(result.Embedding, "Embedding", shapes);
  addColumns(result.Distances, "Distance", table(DistancesPort));

  const Eigen::Index size = result.Area.Operators[0].rows();
  Eigen::MatrixXd areas(count * size, size), angles(count * size, size);
  std::vector<int> owners;
  for (int i = 0; i < count; ++i)
  {
    areas.middleRows(i * size, size) = result.Area.Operators[i];
    angles.middleRows(i * size, size) = result.Conformal.Operators[i];
    owners.insert(owners.end(), size, i);
  }
  vtkTable* operators = table(OperatorsPort);
  operators->AddColumn(Numbers(owners, "Shape"));
  addColumns(areas, "Area", operators);
  addColumns(angles, "Conformal", operators);
}

// 1. The surface of each block, and its map onto the template.
// 2. The template, if it is not given.
// 3. Every process computes the same. The first one writes it.
void vtkShapeCollection::Execute(const shape::Progress& progress)
{
  const std::vector<vtkShapeBlocks::Block> blocks =
    vtkShapeBlocks::Gather(this->GetInputDataObject(0, 0), this->GetController());
  const bool given = this->GetNumberOfInputConnections(1) > 0,
             mapped = this->Correspondence == CorrespondenceType::Maps;
  if (mapped && !given)
  {
    throw shape::InvalidInput("with Correspondence Maps, the shapes are mapped onto the Template; "
                              "connect it");
  }
  vtkSmartPointer<vtkPolyData> templateData;
  shape::Surface base;
  if (given)
  {
    templateData = this->GetGatheredInput(1).Data;
    base = vtkShapeConvert::ToMesh(templateData, "Template");
  }
  std::vector<shape::CollectionShape> shapes;
  std::vector<std::string> names;
  const shape::Progress reading = progress.Part(0.0, 0.1, "reading the shapes");
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    reading(static_cast<double>(i) / static_cast<double>(blocks.size()));
    const std::string name = "shape " + std::to_string(i);
    shapes.push_back({ vtkShapeConvert::ToMesh(blocks[i].Data, name), {} });
    shape::RequireFinite(shapes[i].Shape.Points(), name);
    if (mapped)
    {
      shape::RequireManifold(base, "the Template");
      shapes[i].Images = ReadImages(blocks[i].Data, name, templateData, base, {});
    }
    names.push_back(blocks[i].Name);
  }
  if (shapes.size() == 1)
  {
    this->Warn("Shapes has only one surface; put two or more together with Group Datasets");
  }
  int nearest = -1;
  if (!given)
  {
    nearest = shape::FindNearestToAll(shapes, this->Options, progress.Part(0.1, 0.5));
    templateData = blocks[nearest].Data;
    base = shapes[nearest].Shape;
  }
  const shape::CollectionResult result =
    shape::CompareCollection(base, shapes, this->Options, progress.Part(given ? 0.1 : 0.5, 1.0));

  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(0));
  output->ShallowCopy(templateData);
  const auto add = [&](const Eigen::MatrixXd& values, const std::string& name)
  { output->GetPointData()->AddArray(vtkShapeConvert::ToArray(values, name)); };
  add(result.Area.Deviation, "AreaDeviation");
  add(result.Conformal.Deviation, "ConformalDeviation");
  add(result.Area.Functions, "AreaVariationFunctions");
  add(result.Conformal.Functions, "ConformalVariationFunctions");
  if (result.PositionDeviation.size() > 0)
  {
    add(result.PositionDeviation, "PositionDeviation");
  }
  this->WriteTables(result, names);
  vtkFieldData* facts = output->GetFieldData();
  vtkShapeConvert::AddFact(output, "Collection.Shapes", static_cast<double>(shapes.size()));
  vtkShapeConvert::AddFact(output, "Collection.Template", nearest);
  vtkShapeConvert::AddFact(output, "Collection.Outlier", result.Order.front());
  vtkShapeConvert::AddFact(output, "Collection.LargestDistance", result.Distances.maxCoeff());
  facts->AddArray(vtkShapeConvert::ToArray(result.Shares, "Collection.EmbeddingShares"));
  facts->AddArray(vtkShapeConvert::ToArray(result.Area.Variances, "Collection.AreaVariances"));
  facts->AddArray(
    vtkShapeConvert::ToArray(result.Conformal.Variances, "Collection.ConformalVariances"));
}
