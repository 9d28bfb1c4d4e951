#include "vtkShapeAtlasInput.h"

#include "vtkShapeConvert.h"
#include "vtkShapePreciseMap.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"

#include <algorithm>

namespace
{

/// Moves the points of each shape to its map's images.
std::vector<shape::Mesh> ReadMapped(
  const std::vector<vtkShapeBlocks::Block>& blocks, const std::vector<shape::Mesh>& meshes)
{
  std::vector<shape::Mesh> mapped;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const std::string name = "shape " + std::to_string(i);
    mapped.push_back({ vtkShapeConvert::ToPointArray(blocks[i].Data, vtkShapePreciseMap::Position,
                         3, name, "map it onto a template with Shape Correspondence"),
      meshes[i].Triangles });
    shape::RequireFinite(mapped[i].Points, "TargetPosition of " + name);
  }
  return mapped;
}

/// Returns the number of the shape that is mapped to itself.
int FindTemplate(const std::vector<shape::Mesh>& meshes, const std::vector<shape::Mesh>& mapped)
{
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    const double size = shape::ComputeLongestBoxEdge(meshes[i].Points);
    if ((meshes[i].Points - mapped[i].Points).cwiseAbs().maxCoeff() <= 1e-6 * size)
    {
      return static_cast<int>(i);
    }
  }
  throw shape::InvalidInput("no shape is mapped to itself; connect the Template onto which "
                            "TargetPosition maps the shapes");
}

bool HaveMaps(const std::vector<vtkShapeBlocks::Block>& blocks)
{
  return std::all_of(blocks.begin(), blocks.end(),
    [](const vtkShapeBlocks::Block& block)
    { return block.Data->GetPointData()->HasArray(vtkShapePreciseMap::Position.c_str()); });
}

bool HaveCellsOf(const shape::Mesh& base, const std::vector<shape::Mesh>& meshes)
{
  return std::all_of(meshes.begin(), meshes.end(),
    [&](const shape::Mesh& mesh)
    {
      return mesh.Points.rows() == base.Points.rows() &&
        mesh.Triangles.rows() == base.Triangles.rows() && mesh.Triangles == base.Triangles;
    });
}

void RequireTemplateCells(const shape::Mesh& base, const std::vector<shape::Mesh>& meshes)
{
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    const std::string name = "shape " + std::to_string(i);
    if (meshes[i].Points.rows() != base.Points.rows())
    {
      throw shape::InvalidInput(name + " has " + std::to_string(meshes[i].Points.rows()) +
        " points, but the template has " + std::to_string(base.Points.rows()) +
        "; map the shapes onto a template, and set Correspondence to Maps");
    }
    if (meshes[i].Triangles.rows() != base.Triangles.rows() ||
      meshes[i].Triangles != base.Triangles)
    {
      throw shape::InvalidInput(name +
        " has other triangles than the template; map the shapes "
        "onto a template, and set Correspondence to Maps");
    }
  }
}

} // namespace

vtkShapeAtlasInput::Population vtkShapeAtlasInput::Read(
  const std::vector<vtkShapeBlocks::Block>& blocks, vtkPolyData* templateData,
  vtkShapeAtlas::CorrespondenceType correspondence, const shape::Progress& progress)
{
  Population population;
  std::vector<shape::Mesh> meshes;
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const std::string name = "shape " + std::to_string(i);
    meshes.push_back(vtkShapeConvert::ToMesh(blocks[i].Data, name));
    shape::RequireFinite(meshes[i].Points, name);
  }
  if (templateData)
  {
    population.TemplateData = templateData;
    population.Template = vtkShapeConvert::ToMesh(population.TemplateData, "the Template");
    shape::RequireFinite(population.Template.Points, "the Template");
  }
  using Type = vtkShapeAtlas::CorrespondenceType;
  const bool mapped = correspondence == Type::Maps ||
    (correspondence == Type::Automatic && HaveMaps(blocks) &&
      !HaveCellsOf(templateData ? population.Template : meshes.front(), meshes));
  const std::vector<shape::Mesh> images =
    mapped ? ReadMapped(blocks, meshes) : std::vector<shape::Mesh>();
  if (!templateData)
  {
    population.TemplateNumber = mapped ? FindTemplate(meshes, images) : 0;
    population.TemplateData = blocks[population.TemplateNumber].Data;
    population.Template = meshes[population.TemplateNumber];
  }
  const Eigen::MatrixXd& places = population.Template.Points;
  if (!mapped)
  {
    RequireTemplateCells(population.Template, meshes);
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    const double share = 1.0 / static_cast<double>(meshes.size());
    if (!mapped)
    {
      population.Shapes.push_back(meshes[i].Points);
      continue;
    }
    // The inverse map: the nearest point of the shape's triangles where the map sends them.
    const shape::Progress own =
      progress.Part(static_cast<double>(i) * share, (static_cast<double>(i) + 1.0) * share);
    const shape::ClosestPoints found = shape::SurfaceLocator(images[i]).Find(places, own);
    population.Shapes.push_back(shape::PullBack(found, meshes[i].Triangles, meshes[i].Points));
    population.LargestGap = std::max(
      population.LargestGap, found.Distances.maxCoeff() / shape::ComputeLongestBoxEdge(places));
    population.Samples.push_back(found);
    population.Triangles.push_back(meshes[i].Triangles);
  }
  progress(1.0);
  return population;
}

std::vector<std::string> vtkShapeAtlasInput::ListQuantities(
  const std::vector<vtkShapeBlocks::Block>& blocks)
{
  std::vector<std::string> names;
  vtkPointData* first = blocks.front().Data->GetPointData();
  for (int k = 0; k < first->GetNumberOfArrays(); ++k)
  {
    const char* name = first->GetArrayName(k);
    const auto isQuantity = [&](const vtkShapeBlocks::Block& block)
    {
      vtkDataArray* array = block.Data->GetPointData()->GetArray(name);
      return array && array->GetNumberOfComponents() == 1 &&
        (array->GetDataType() == VTK_DOUBLE || array->GetDataType() == VTK_FLOAT);
    };
    if (name && std::all_of(blocks.begin(), blocks.end(), isQuantity))
    {
      names.emplace_back(name);
    }
  }
  return names;
}

Eigen::MatrixXd vtkShapeAtlasInput::ReadQuantity(const std::string& name,
  const std::vector<vtkShapeBlocks::Block>& blocks, const Population& population)
{
  Eigen::MatrixXd values(
    population.Template.Points.rows(), static_cast<Eigen::Index>(blocks.size()));
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const Eigen::MatrixXd own =
      vtkShapeConvert::ToPointArray(blocks[i].Data, name, 1, "shape " + std::to_string(i));
    values.col(static_cast<Eigen::Index>(i)) = population.Samples.empty()
      ? own
      : shape::PullBack(population.Samples[i], population.Triangles[i], own);
  }
  return values;
}
