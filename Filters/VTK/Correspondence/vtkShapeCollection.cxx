#include "vtkShapeCollection.h"

#include "vtkShapeBlocks.h"
#include "vtkShapeCarry.h"
#include "vtkShapeConvert.h"
#include "vtkShapeGather.h"
#include "vtkShapePreciseMap.h"

#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
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

#include "Base/Errors.h"
#include "Correspondence/Evaluate/InvertMap.h"
#include "Correspondence/Landmarks/LandmarkPairs.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Mesh/Provenance.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <functional>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkShapeCollection);

namespace
{

constexpr int ShapesPort = 0, TemplatePort = 1, DistancesPort = 2, ShapesTablePort = 3,
              OperatorsPort = 4,
              ResampledPort = 6; // after the facts

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

/// The landmarks of a surface: the nearest points, by `Number`, or by their order, from 1.
shape::NumberedPoints ReadNumbered(
  vtkPolyData* landmarks, const shape::Surface& surface, const std::string& name)
{
  const Eigen::VectorXi nearest =
    shape::FindNearestPoints(surface, vtkShapeConvert::ToPoints(landmarks), name);
  vtkDataArray* numbers = landmarks->GetPointData()->GetArray("Number");
  shape::NumberedPoints points;
  for (int i = 0; i < static_cast<int>(nearest.size()); ++i)
  {
    const int number = numbers ? static_cast<int>(numbers->GetTuple1(i)) : i + 1;
    if (!points.emplace(number, nearest(i)).second)
    {
      throw shape::InvalidInput("Landmarks has number " + std::to_string(number) + " twice for " +
        name + "; give each landmark of a shape its own number");
    }
  }
  return points;
}

/// What a shape is called in messages.
std::string NameOf(const vtkShapeBlocks::Block& block)
{
  return "shape " + std::to_string(block.Number) +
    (block.Name.empty() ? "" : " (" + block.Name + ")");
}

vtkSmartPointer<vtkIntArray> Numbers(const std::vector<int>& values, const std::string& name)
{
  return vtkShapeConvert::ToIntegers(
    Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size())),
    name);
}

/// Writes the map of a shape, in place of any that it has.
void WriteTarget(const shape::SurfacePoints& images, vtkPolyData* templateData,
  const shape::Mesh& base, vtkPolyData* output)
{
  vtkPointData* data = output->GetPointData();
  data->RemoveArray(vtkShapePreciseMap::Cell.c_str());
  data->RemoveArray(vtkShapePreciseMap::Barycentric.c_str());
  if (images.Triangles.size() == 0)
  {
    data->AddArray(vtkShapeConvert::ToArray(base.Points, vtkShapePreciseMap::Position));
    return;
  }
  data->AddArray(vtkShapeConvert::ToArray(
    shape::PullBack(images, base.Triangles, base.Points), vtkShapePreciseMap::Position));
  data->AddArray(vtkShapeConvert::ToArray(images.Barycentrics, vtkShapePreciseMap::Barycentric));
  // Cell ids of polygons follow those of vertices and lines.
  const vtkIdType before = templateData->GetNumberOfVerts() + templateData->GetNumberOfLines();
  vtkNew<vtkIdTypeArray> cells;
  cells->SetName(vtkShapePreciseMap::Cell.c_str());
  cells->SetNumberOfValues(images.Triangles.size());
  for (Eigen::Index i = 0; i < images.Triangles.size(); ++i)
  {
    cells->SetValue(i, before + images.Triangles(i));
  }
  data->AddArray(cells);
}

/// A shape with the points and cells of the template.
vtkSmartPointer<vtkPolyData> Resample(vtkPolyData* data, const shape::Mesh& mesh,
  const shape::SurfacePoints& positions, vtkPolyData* templateData, const shape::Mesh& base)
{
  const auto output = vtkSmartPointer<vtkPolyData>::New();
  output->CopyStructure(templateData);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetData(
    vtkShapeConvert::ToArray(shape::PullBack(positions, mesh.Triangles, mesh.Points), "Points"));
  output->SetPoints(points);
  shape::ProvenanceWriter from(mesh.Points.rows());
  for (Eigen::Index i = 0; i < positions.Triangles.size(); ++i)
  {
    from.AddOnTriangle(mesh.Triangles.row(positions.Triangles(i)), positions.Barycentrics.row(i));
  }
  const shape::Provenance origin =
    from.Finish(Eigen::VectorXi::Constant(output->GetNumberOfCells(), -1));
  vtkShapeCarry::Carry({ { data, origin } }, output);
  WriteTarget({}, templateData, base, output);
  return output;
}

} // namespace

vtkShapeCollection::vtkShapeCollection()
{
  this->DeclareInput("Shapes", PortData::Pieces, PortUse::Required, { "vtkPolyData" });
  this->DeclareInput("Template", PortData::WholePolygons, PortUse::Optional, { "vtkPolyData" });
  this->DeclareInput("Landmarks", PortData::Pieces, PortUse::Optional, { "vtkPolyData" });
  this->DeclareOutput("vtkMultiBlockDataSet"); // Shapes
  this->DeclareOutput("vtkPolyData");          // Template
  this->DeclareOutput("vtkTable");             // Distances
  this->DeclareOutput("vtkTable");             // Table
  this->DeclareOutput("vtkTable");             // Operators
  this->DeclareFacts();
  this->DeclareOutput("vtkMultiBlockDataSet"); // Resampled
  this->DeclareMeasures({ "AreaDeviation", "ConformalDeviation", "AreaVariationFunctions",
    "ConformalVariationFunctions", "AreaModes", "ConformalModes", "PositionDeviation" });
  this->DeclareShown(TemplatePort, { "AreaDeviation" });
  this->DeclareMemoryRemedy("lower Basis Size");
}

void vtkShapeCollection::WriteTables(const shape::CollectionResult& result,
  const std::vector<vtkShapeBlocks::Block>& blocks, const Eigen::VectorXd& disagreements)
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
  const int count = static_cast<int>(blocks.size());
  std::vector<int> numbers(count), ranks(count), leaves(count);
  vtkNew<vtkStringArray> words;
  words->SetName("Name");
  for (int i = 0; i < count; ++i)
  {
    numbers[i] = blocks[i].Number;
    ranks[result.Order[i]] = i;
    leaves[result.Leaves[i]] = i;
    words->InsertNextValue(blocks[i].Name.c_str());
  }
  vtkTable* shapes = table(ShapesTablePort);
  shapes->AddColumn(Numbers(numbers, "Shape"));
  shapes->AddColumn(words);
  shapes->AddColumn(vtkShapeConvert::ToArray(result.Dissimilarities, "Dissimilarity"));
  shapes->AddColumn(Numbers(ranks, "Rank"));
  shapes->AddColumn(Numbers(leaves, "Leaf"));
  if (disagreements.size() > 0)
  {
    shapes->AddColumn(vtkShapeConvert::ToArray(disagreements, "Disagreement"));
  }
  addColumns(result.Embedding, "Embedding", shapes);
  addColumns(result.Distances, "Distance", table(DistancesPort));

  const Eigen::Index size = result.Area.Operators[0].rows();
  Eigen::MatrixXd areas(count * size, size), angles(count * size, size);
  std::vector<int> owners;
  for (int i = 0; i < count; ++i)
  {
    areas.middleRows(i * size, size) = result.Area.Operators[i];
    angles.middleRows(i * size, size) = result.Conformal.Operators[i];
    owners.insert(owners.end(), size, blocks[i].Number);
  }
  vtkTable* operators = table(OperatorsPort);
  operators->AddColumn(Numbers(owners, "Shape"));
  addColumns(areas, "Area", operators);
  addColumns(angles, "Conformal", operators);
}

void vtkShapeCollection::WriteShapes(const std::vector<shape::CollectionShape>& shapes,
  const std::vector<vtkShapeBlocks::Block>& blocks,
  const std::vector<shape::SurfacePoints>& inverses, vtkPolyData* templateData,
  const shape::Mesh& base)
{
  auto* mapped = vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(ShapesPort));
  auto* resampled = vtkMultiBlockDataSet::SafeDownCast(this->GetOutputDataObject(ResampledPort));
  for (std::size_t i = 0; i < shapes.size(); ++i)
  {
    vtkNew<vtkPolyData> block;
    block->ShallowCopy(blocks[i].Data);
    WriteTarget(shapes[i].Images, templateData, base, block);
    const auto add = [&](vtkMultiBlockDataSet* output, vtkPolyData* shape)
    {
      const auto number = static_cast<unsigned int>(blocks[i].Number);
      output->SetBlock(number, shape);
      if (!blocks[i].Name.empty())
      {
        output->GetMetaData(number)->Set(vtkCompositeDataSet::NAME(), blocks[i].Name.c_str());
      }
    };
    add(mapped, block);
    add(resampled,
      inverses.empty()
        ? block.Get()
        : Resample(blocks[i].Data, shapes[i].Shape, inverses[i], templateData, base).Get());
  }
}

void vtkShapeCollection::WriteFacts(const shape::ConsistentMaps& maps, vtkPolyData* output)
{
  double exchanged = 0.0, dropped = 0.0;
  for (const shape::ConsistentPair& pair : maps.Pairs)
  {
    exchanged += pair.Rank > 0 && !pair.Dropped ? 1.0 : 0.0;
    dropped += pair.Dropped ? 1.0 : 0.0;
  }
  const auto add = [&](const std::string& name, double value)
  { vtkShapeConvert::AddFact(output, "Collection." + name, value); };
  add("Pairs", static_cast<double>(maps.Pairs.size()));
  add("ExchangedPairs", exchanged);
  add("DroppedPairs", dropped);
  add("CycleError", maps.CycleError);
  add("PairwiseCycleError", maps.PairwiseCycleError);
  add("Triples", maps.Triples);
}

std::vector<shape::NumberedPoints> vtkShapeCollection::ReadLandmarks(
  const std::vector<shape::Surface>& surfaces, const std::vector<vtkShapeBlocks::Block>& blocks,
  int count, const shape::Surface* base)
{
  if (this->GetNumberOfInputConnections(2) == 0)
  {
    return {};
  }
  if (this->Correspondence != CorrespondenceType::Computed)
  {
    this->Warn("Landmarks are used with Correspondence Computed alone; they are ignored");
    return {};
  }
  std::vector<shape::NumberedPoints> numbered(surfaces.size() + (base ? 1 : 0));
  for (const vtkShapeBlocks::Block& given : vtkShapeBlocks::Gather(
         this->GetInputDataObject(2, 0), this->GetController(), nullptr, "Landmarks"))
  {
    if (given.Number == count && base)
    {
      numbered.back() = ReadNumbered(given.Data, *base, "the Template");
      continue;
    }
    if (given.Number >= count)
    {
      throw shape::InvalidInput("Landmarks has a block " + std::to_string(given.Number) +
        ", and Shapes has only " + std::to_string(count) +
        "; give block k the landmarks of shape k");
    }
    for (std::size_t i = 0; i < blocks.size(); ++i)
    {
      if (blocks[i].Number == given.Number)
      {
        numbered[i] = ReadNumbered(given.Data, surfaces[i], NameOf(blocks[i]));
      }
    }
  }
  return numbered;
}

// 1. The surface of each block, and its map onto the template, which is given or computed.
// 2. The template, if it is not given.
// 3. The inverse maps, and the comparison.
// 4. Every process has the same. The first one writes it.
void vtkShapeCollection::Execute(const shape::Progress& progress)
{
  shape::RequireOptions(this->MapOptions);
  std::vector<vtkShapeBlocks::Block> empty;
  const std::vector<vtkShapeBlocks::Block> gathered =
    vtkShapeBlocks::Gather(this->GetInputDataObject(0, 0), this->GetController(), &empty);
  std::vector<std::string> leftOut;
  for (const vtkShapeBlocks::Block& block : empty)
  {
    leftOut.push_back(NameOf(block) + " is empty");
  }
  const bool given = this->GetNumberOfInputConnections(1) > 0,
             mapped = this->Correspondence == CorrespondenceType::Maps,
             computed = this->Correspondence == CorrespondenceType::Computed;
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
  std::vector<shape::Surface> surfaces;
  const shape::Progress reading = progress.Part(0.0, 0.05, "reading the shapes");
  const auto read = [&](const vtkShapeBlocks::Block& block)
  {
    const std::string name = NameOf(block);
    shape::CollectionShape made{ vtkShapeConvert::ToMesh(block.Data, name), {}, {} };
    shape::RequireFinite(made.Shape.Points(), name);
    if (mapped)
    {
      shape::RequireManifold(base, "the Template");
      made.Images = ReadImages(block.Data, name, templateData, base, {});
    }
    if (computed)
    {
      shape::RequireConnected(made.Shape, name);
    }
    return made;
  };
  std::vector<vtkShapeBlocks::Block> blocks;
  for (const vtkShapeBlocks::Block& block : gathered)
  {
    reading(static_cast<double>(block.Number) / (gathered.back().Number + 1.0));
    try
    {
      shapes.push_back(read(block));
    }
    catch (const shape::InvalidInput& error)
    {
      // Maps of the others do not depend on it.
      if (!computed)
      {
        throw;
      }
      leftOut.push_back(error.what());
      continue;
    }
    surfaces.push_back(shapes.back().Shape);
    blocks.push_back(block);
  }
  for (const std::string& reason : leftOut)
  {
    this->Warn("left out: " + reason);
  }
  if (shapes.empty())
  {
    throw shape::InvalidInput("no shape can be mapped; " + leftOut.front());
  }
  if (shapes.size() == 1)
  {
    this->Warn("Shapes has only one surface; put two or more together with Group Datasets");
  }
  this->MapOptions.Numbered = this->ReadLandmarks(
    surfaces, blocks, static_cast<int>(gathered.size() + empty.size()), given ? &base : nullptr);
  int nearest = -1;
  shape::ConsistentMaps maps;
  if (computed)
  {
    shape::PairSharing sharing;
    if (vtkMultiProcessController* controller = this->GetController())
    {
      sharing = { controller->GetLocalProcessId(), controller->GetNumberOfProcesses(),
        [=](const std::function<void()>& work)
        { vtkShapeGather::RunOnAllOrFail(controller, work); },
        [=](double* values, int count)
        { vtkShapeGather::Reduce(controller, values, count, vtkShapeGather::Reduction::Sum); } };
    }
    maps = shape::ComputeConsistentMaps(
      surfaces, given ? &base : nullptr, this->MapOptions, sharing, progress.Part(0.05, 0.8));
    for (std::size_t i = 0; i < shapes.size(); ++i)
    {
      shapes[i].Images = maps.SmoothImages[i]; // operators need derivatives
    }
    nearest = maps.Template;
  }
  else if (!given)
  {
    nearest = shape::FindNearestToAll(shapes, this->Options, progress.Part(0.05, 0.5));
  }
  int number = -1; // of the block
  if (nearest >= 0)
  {
    templateData = blocks[nearest].Data;
    base = shapes[nearest].Shape;
    number = blocks[nearest].Number;
  }
  std::vector<shape::SurfacePoints> inverses;
  for (std::size_t i = 0; (mapped || computed) && i < shapes.size(); ++i)
  {
    inverses.push_back(
      computed ? maps.Maps[i].BToA : shape::InvertMap(shapes[i].Shape, shapes[i].Images, base));
    shapes[i].OnShape =
      shape::PullBack(inverses[i], shapes[i].Shape.Triangles(), shapes[i].Shape.Points());
  }
  const shape::CollectionResult result = shape::CompareCollection(base, shapes, this->Options,
    progress.Part(computed ? 0.8
        : given            ? 0.05
                           : 0.5,
      1.0));
  for (std::size_t i = 0; computed && i < shapes.size(); ++i)
  {
    shapes[i].Images = maps.Maps[i].AToB;
  }

  if (this->GetController() && this->GetController()->GetLocalProcessId() != 0)
  {
    return;
  }
  auto* output = vtkPolyData::SafeDownCast(this->GetOutputDataObject(TemplatePort));
  output->ShallowCopy(templateData);
  const auto add = [&](const Eigen::MatrixXd& values, const std::string& name)
  { output->GetPointData()->AddArray(vtkShapeConvert::ToArray(values, name)); };
  add(result.Area.Deviation, "AreaDeviation");
  add(result.Conformal.Deviation, "ConformalDeviation");
  add(result.Area.Functions, "AreaVariationFunctions");
  add(result.Conformal.Functions, "ConformalVariationFunctions");
  add(result.Area.Modes, "AreaModes");
  add(result.Conformal.Modes, "ConformalModes");
  if (result.PositionDeviation.size() > 0)
  {
    add(result.PositionDeviation, "PositionDeviation");
  }
  this->WriteShapes(shapes, blocks, inverses, templateData, base);
  this->WriteTables(result, blocks, maps.Disagreements);
  vtkFieldData* facts = output->GetFieldData();
  vtkShapeConvert::AddFact(output, "Collection.Shapes", static_cast<double>(shapes.size()));
  vtkShapeConvert::AddFact(output, "Collection.Template", number);
  vtkShapeConvert::AddFact(output, "Collection.LeftOut", static_cast<double>(leftOut.size()));
  vtkShapeConvert::AddFact(output, "Collection.Outlier", blocks[result.Order.front()].Number);
  vtkShapeConvert::AddFact(output, "Collection.LargestDistance", result.Distances.maxCoeff());
  facts->AddArray(vtkShapeConvert::ToArray(result.Shares, "Collection.EmbeddingShares"));
  facts->AddArray(vtkShapeConvert::ToArray(result.Area.Variances, "Collection.AreaVariances"));
  facts->AddArray(
    vtkShapeConvert::ToArray(result.Conformal.Variances, "Collection.ConformalVariances"));
  if (!maps.Pairs.empty())
  {
    this->WriteFacts(maps, output);
  }
}
