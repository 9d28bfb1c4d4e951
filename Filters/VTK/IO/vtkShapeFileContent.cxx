#include "vtkShapeFileContent.h"

#include "vtkShapeConvert.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include "Base/Errors.h"
#include "IO/CADReader.h"
#include "IO/DeckReader.h"
#include "IO/MeditReader.h"
#include "IO/OFFReader.h"

#include <algorithm>
#include <cerrno>
#include <filesystem>
#include <fstream>
#include <map>
#include <numeric>
#include <system_error>
#include <utility>
#include <vector>

namespace
{

vtkSmartPointer<vtkPoints> ToPoints(const Eigen::MatrixXd& points)
{
  vtkNew<vtkPoints> result;
  result->SetDataType(VTK_DOUBLE);
  result->SetData(vtkShapeConvert::ToArray(points, "Points"));
  return result;
}

void RequireName(const std::string& path)
{
  if (path.empty())
  {
    throw shape::InvalidInput("there is no file name; set one");
  }
}

/// Returns the chosen cells in their order.
vtkSmartPointer<vtkCellArray> ToCellArray(const shape::Cells& cells, const std::vector<int>& chosen)
{
  vtkNew<vtkCellArray> result;
  result->AllocateExact(
    static_cast<vtkIdType>(chosen.size()), static_cast<vtkIdType>(cells.Corners.size()));
  for (const int cell : chosen)
  {
    const int first = cells.Offsets(cell), end = cells.Offsets(cell + 1);
    result->InsertNextCell(end - first);
    for (int k = first; k < end; ++k)
    {
      result->InsertCellPoint(cells.Corners(k));
    }
  }
  return result;
}

/// Adds colours as the array RGB or RGBA. order: the item of each tuple.
void AddColors(const shape::OFFSurface::Colors& colors, const std::vector<int>& order,
  vtkDataSetAttributes* data)
{
  if (colors.Components == 0)
  {
    return;
  }
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName(colors.Components == 3 ? "RGB" : "RGBA");
  array->SetNumberOfComponents(colors.Components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(order.size()));
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    array->SetTypedTuple(static_cast<vtkIdType>(i),
      colors.Values.data() + static_cast<std::size_t>(colors.Components) * order[i]);
  }
  data->AddArray(array);
}

vtkSmartPointer<vtkFloatArray> ToFloats(const Eigen::MatrixXd& values, const char* name)
{
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->DeepCopy(vtkShapeConvert::ToArray(values, name));
  array->SetName(name);
  return array;
}

/// Adds the cells, of any kinds.
void SetGridCells(const shape::Cells& cells, vtkUnstructuredGrid* output)
{
  output->SetPoints(ToPoints(cells.Points));
  std::vector<int> all(cells.Kinds.size()), kinds(cells.Kinds.begin(), cells.Kinds.end());
  std::iota(all.begin(), all.end(), 0);
  output->SetCells(kinds.data(), ToCellArray(cells, all));
}

/// Returns numberOf(0), ..., numberOf(count - 1) as an array of ids.
template <typename Number>
vtkSmartPointer<vtkIdTypeArray> ToIds(const char* name, std::size_t count, const Number& numberOf)
{
  vtkNew<vtkIdTypeArray> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(count));
  for (std::size_t i = 0; i < count; ++i)
  {
    array->SetValue(static_cast<vtkIdType>(i), static_cast<vtkIdType>(numberOf(i)));
  }
  return array;
}

/// Adds names to the field data, unless all are empty.
void AddNames(const std::vector<std::string>& names, const char* array, vtkDataObject* output)
{
  if (std::all_of(names.begin(), names.end(), [](const std::string& name) { return name.empty(); }))
  {
    return;
  }
  vtkNew<vtkStringArray> strings;
  strings->SetName(array);
  for (const std::string& name : names)
  {
    strings->InsertNextValue(name);
  }
  output->GetFieldData()->AddArray(strings);
}

} // namespace

void vtkShapeFileContent::CallWithName(
  const std::string& path, const std::function<void()>& function)
{
  RequireName(path);
  try
  {
    function();
  }
  catch (const shape::InvalidInput& error)
  {
    throw shape::InvalidInput(path.substr(path.find_last_of('/') + 1) + ": " + error.what());
  }
}

std::string vtkShapeFileContent::Read(const std::string& path)
{
  RequireName(path);
  const auto refuse = [&](const std::string& why) {
    throw shape::InvalidInput("cannot read the file '" + path + "' (" + why + "); choose another");
  };
  std::error_code error;
  const auto size = std::filesystem::file_size(path, error);
  if (error)
  {
    refuse(error.message());
  }
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  std::string content(size, '\0');
  if (!file || !file.read(content.data(), static_cast<std::streamsize>(size)))
  {
    refuse(std::generic_category().message(errno));
  }
  return content;
}

void vtkShapeFileContent::ToPolyData(const shape::OFFSurface& surface, vtkPolyData* output)
{
  const shape::Cells& faces = surface.Faces;
  // A vtkPolyData numbers vertices first, then lines, then polygons.
  std::vector<int> order, ofKind;
  for (const int kind :
    { shape::cell_kind::Vertex, shape::cell_kind::Line, shape::OFFSurface::PolygonKind })
  {
    ofKind.clear();
    for (int face = 0; face < faces.Kinds.size(); ++face)
    {
      if (faces.Kinds(face) == kind)
      {
        ofKind.push_back(face);
      }
    }
    if (ofKind.empty())
    {
      continue;
    }
    order.insert(order.end(), ofKind.begin(), ofKind.end());
    const auto cells = ToCellArray(faces, ofKind);
    kind == shape::cell_kind::Vertex   ? output->SetVerts(cells)
      : kind == shape::cell_kind::Line ? output->SetLines(cells)
                                       : output->SetPolys(cells);
  }
  output->SetPoints(ToPoints(faces.Points));
  std::vector<int> points(faces.Points.rows());
  std::iota(points.begin(), points.end(), 0);
  AddColors(surface.PointColors, points, output->GetPointData());
  AddColors(surface.FaceColors, order, output->GetCellData());
  if (!surface.FaceColorIndices.empty())
  {
    Eigen::VectorXi indices(static_cast<Eigen::Index>(order.size()));
    std::transform(order.begin(), order.end(), indices.begin(),
      [&](int face) { return surface.FaceColorIndices[face]; });
    output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(indices, "ColorIndex"));
  }
  if (surface.Normals.rows() > 0)
  {
    output->GetPointData()->SetNormals(ToFloats(surface.Normals, "Normals"));
  }
  if (surface.TextureCoordinates.rows() > 0)
  {
    output->GetPointData()->SetTCoords(ToFloats(surface.TextureCoordinates, "TCoords"));
  }
}

void vtkShapeFileContent::ToPolyData(
  const shape::CADModel& model, vtkPolyData* surface, vtkPolyData* edges)
{
  vtkShapeConvert::FromMesh(model.Surface, surface);
  surface->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(model.Patches, "Patch"));
  surface->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(model.Regions, "RegionId"));
  AddNames(model.PatchNames, "CADReader.PatchNames", surface);
  AddNames(model.RegionNames, "CADReader.RegionNames", surface);
  std::map<int, vtkIdType> points; // of the edges, by the point of the surface
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkIntArray> numbers;
  numbers->SetName("Edge");
  for (const shape::CADEdge& edge : model.Edges)
  {
    lines->InsertNextCell(static_cast<vtkIdType>(edge.Points.size()));
    numbers->InsertNextValue(edge.Number);
    for (const int point : edge.Points)
    {
      const auto [known, isNew] = points.emplace(point, positions->GetNumberOfPoints());
      if (isNew)
      {
        positions->InsertNextPoint(surface->GetPoint(point));
      }
      lines->InsertCellPoint(known->second);
    }
  }
  edges->SetPoints(positions);
  edges->SetLines(lines);
  edges->GetCellData()->AddArray(numbers);
}

void vtkShapeFileContent::ToGrid(const shape::MeditMesh& mesh, vtkUnstructuredGrid* output)
{
  SetGridCells(mesh.Mesh, output);
  output->GetPointData()->AddArray(vtkShapeConvert::ToIntegers(mesh.PointReferences, "Reference"));
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(mesh.CellReferences, "Reference"));
}

std::string vtkShapeFileContent::FindBeside(const std::string& path, const std::string& name)
{
  return (std::filesystem::path(path).parent_path() / name).string();
}

shape::Deck vtkShapeFileContent::ReadDeck(const std::string& path, std::string content,
  const shape::Progress& progress, shape::DeckContent wanted)
{
  const auto read = [&](const std::string& name) { return Read(FindBeside(path, name)); };
  return shape::ReadDeck(path, std::move(content), read, progress, wanted);
}

void vtkShapeFileContent::ToGrid(
  const shape::Deck& deck, const std::string& path, vtkUnstructuredGrid* output)
{
  SetGridCells(deck.Mesh, output);
  output->GetPointData()->AddArray(
    ToIds("NodeId", deck.Nodes.size(), [&](std::size_t i) { return deck.Nodes[i].Number; }));
  if (deck.HasParts)
  {
    Eigen::VectorXi parts(static_cast<Eigen::Index>(deck.Nodes.size()));
    std::transform(deck.Nodes.begin(), deck.Nodes.end(), parts.begin(),
      [](const shape::DeckNode& node) { return node.Part; });
    output->GetPointData()->AddArray(vtkShapeConvert::ToIntegers(parts, "NodePart"));
  }
  output->GetCellData()->AddArray(ToIds("ElementId", deck.ElementNumbers.size(),
    [&](std::size_t i) { return deck.ElementNumbers[i]; }));
  output->GetCellData()->AddArray(vtkShapeConvert::ToIntegers(deck.Regions, "RegionId"));
  AddNames(deck.RegionNames, "RegionName", output);
  AddNames({ std::filesystem::absolute(path).string() }, "Deck", output);
  int count = 0;
  std::string types;
  for (const auto& [type, elements] : deck.Skipped)
  {
    count += elements;
    types += (types.empty() ? "" : ", ") + std::to_string(elements) + " " + type;
  }
  vtkShapeConvert::AddFact(output, "DeckReader.SkippedElements", count);
  vtkShapeConvert::AddFact(output, "DeckReader.Skipped", types.empty() ? "none" : types);
}
