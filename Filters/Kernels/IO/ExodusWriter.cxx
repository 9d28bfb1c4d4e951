#include "IO/ExodusWriter.h"

#include "IO/Private/NetCDF.h"
#include "Mesh/CellFaces.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using namespace cell_kind;

constexpr std::size_t nameLength = 33; ///< of the format, with a zero at the end

/// Exodus' name of a kind of element. Nodes are in VTK's order.
const char* ExodusType(int kind)
{
  switch (kind)
  {
    case Vertex:
      return "SPHERE";
    case Line:
      return "BAR2";
    case Triangle:
      return "TRI3";
    case Quadrilateral:
      return "SHELL4";
    case Tetrahedron:
      return "TETRA4";
    case Pyramid:
      return "PYRAMID5";
    case Wedge:
      return "WEDGE6";
    default:
      return "HEX8";
  }
}

/// Exodus' sides of a solid cell, by their corners.
const std::vector<std::set<int>>& GetSides(int kind)
{
  using Sides = std::vector<std::set<int>>;
  static const Sides tetrahedron = { { 0, 1, 3 }, { 1, 2, 3 }, { 0, 2, 3 }, { 0, 1, 2 } };
  static const Sides pyramid = { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 0, 3, 4 },
    { 0, 1, 2, 3 } };
  static const Sides wedge = { { 0, 1, 3, 4 }, { 1, 2, 4, 5 }, { 0, 2, 3, 5 }, { 0, 1, 2 },
    { 3, 4, 5 } };
  static const Sides hexahedron = { { 0, 1, 4, 5 }, { 1, 2, 5, 6 }, { 2, 3, 6, 7 }, { 0, 3, 4, 7 },
    { 0, 1, 2, 3 }, { 4, 5, 6, 7 } };
  return kind == Tetrahedron ? tetrahedron
    : kind == Pyramid        ? pyramid
    : kind == Wedge          ? wedge
                             : hexahedron;
}

/// Returns the number of a side, from 1. face: index into GetFaces.
int FindSide(int kind, int face)
{
  const std::vector<int>& corners = GetFaces(kind)[face];
  const std::vector<std::set<int>>& sides = GetSides(kind);
  const auto found =
    std::find(sides.begin(), sides.end(), std::set<int>(corners.begin(), corners.end()));
  return static_cast<int>(found - sides.begin()) + 1;
}

/// Cells of one region and one kind.
struct ExodusBlock
{
  int Kind = 0;
  int Number = 0;
  std::string Name;
  std::vector<int> Cells;
};

std::vector<ExodusBlock> FindBlocks(const MeshSets& sets)
{
  std::map<std::pair<int, int>, std::vector<int>> cells; // by region and kind
  std::map<int, int> kinds;                              // how many a region has
  for (int cell = 0; cell < sets.Mesh.Kinds.size(); ++cell)
  {
    auto& block = cells[{ sets.Regions(cell), sets.Mesh.Kinds(cell) }];
    kinds[sets.Regions(cell)] += block.empty();
    block.push_back(cell);
  }
  int further = sets.Regions.maxCoeff() + 1;
  int last = -1;
  std::vector<ExodusBlock> blocks;
  for (auto& [key, list] : cells)
  {
    const auto [region, kind] = key;
    std::string name = "Region" + std::to_string(region);
    if (kinds.at(region) > 1)
    {
      name += std::string("_") + ExodusType(kind);
      std::transform(name.begin() + 6, name.end(), name.begin() + 6, ::tolower);
    }
    blocks.push_back({ kind, region == last ? ++further : region + 1, name, std::move(list) });
    last = region;
  }
  return blocks;
}

/// Faces with a name.
struct ExodusFaces
{
  int Number;
  std::string Name;
  std::vector<int> Cells, Sides, Points;
};

void AddFaces(const MeshSets& sets, const SolidFaces& faces, const std::vector<int>& chosen,
  int number, const std::string& name, std::vector<ExodusFaces>& all)
{
  if (chosen.empty())
  {
    return;
  }
  ExodusFaces result{ number, name, {}, {}, PointsOf(faces.Corners, chosen) };
  for (const int face : chosen)
  {
    result.Cells.push_back(faces.Cell(face));
    result.Sides.push_back(FindSide(sets.Mesh.Kinds(faces.Cell(face)), faces.Face(face)));
  }
  all.push_back(std::move(result));
}

std::vector<ExodusFaces> FindFaces(const MeshSets& sets)
{
  std::vector<ExodusFaces> all;
  const std::vector<std::vector<int>> patches = GroupFacesByPatch(sets);
  for (int patch = 0; patch < sets.PatchCount; ++patch)
  {
    AddFaces(sets, sets.Boundary, patches[patch], patch + 1, "Patch" + std::to_string(patch), all);
  }
  int number = sets.PatchCount;
  for (const RegionInterface& between : sets.Interfaces)
  {
    std::vector<int> chosen(between.Faces.Cell.size());
    for (std::size_t i = 0; i < chosen.size(); ++i)
    {
      chosen[i] = static_cast<int>(i);
    }
    AddFaces(sets, between.Faces, chosen, ++number,
      "Interface" + std::to_string(between.Lower) + "_" + std::to_string(between.Upper), all);
  }
  return all;
}

std::function<int(std::size_t)> From(std::vector<int> values, int shift = 0)
{
  return [values = std::move(values), shift](std::size_t i) { return values[i] + shift; };
}

/// Adds what describes the members of a kind of set: their status, numbers and names.
template <class Set>
void AddMembers(NetCDF& file, const std::string& prefix, const std::string& dimension,
  int lengthOfNames, const std::vector<Set>& members)
{
  std::vector<int> numbers;
  std::vector<std::string> names;
  for (const Set& member : members)
  {
    numbers.push_back(member.Number);
    names.push_back(member.Name);
  }
  const int count = file.AddDimension(dimension, members.size());
  file.AddIntegers(prefix + "_status", { count }, [](std::size_t) { return 1; });
  file.AddIntegers(prefix + "_prop1", { count }, From(numbers), { { "name", std::string("ID") } });
  file.AddTexts(prefix + "_names", { count, lengthOfNames }, names, nameLength);
}

void AddBlocks(NetCDF& file, const MeshSets& sets, const std::vector<ExodusBlock>& blocks)
{
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    const ExodusBlock& block = blocks[i];
    const std::string number = std::to_string(i + 1);
    const auto corners = static_cast<std::size_t>(GetCornerCount(block.Kind));
    const int cells = file.AddDimension("num_el_in_blk" + number, block.Cells.size());
    const int nodes = file.AddDimension("num_nod_per_el" + number, corners);
    file.AddIntegers("connect" + number, { cells, nodes },
      [&sets, &block, corners](std::size_t k)
      {
        const int cell = block.Cells[k / corners];
        return sets.Mesh.Corners(sets.Mesh.Offsets(cell) + static_cast<int>(k % corners)) + 1;
      },
      { { "elem_type", std::string(ExodusType(block.Kind)) } });
  }
}

/// order: the position of each cell in the file.
void AddSets(NetCDF& file, const std::vector<ExodusFaces>& all, const std::vector<int>& order)
{
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    const std::string number = std::to_string(i + 1);
    const int nodes = file.AddDimension("num_nod_ns" + number, all[i].Points.size());
    file.AddIntegers("node_ns" + number, { nodes }, From(all[i].Points, 1));
    std::vector<int> elements(all[i].Cells);
    std::transform(elements.begin(), elements.end(), elements.begin(),
      [&](int cell) { return order[cell] + 1; });
    const int sides = file.AddDimension("num_side_ss" + number, all[i].Sides.size());
    file.AddIntegers("elem_ss" + number, { sides }, From(elements));
    file.AddIntegers("side_ss" + number, { sides }, From(all[i].Sides));
  }
}

} // namespace

void WriteExodus(std::ostream& file, const MeshSets& sets, const Progress& progress)
{
  const std::vector<ExodusBlock> blocks = FindBlocks(sets);
  const std::vector<ExodusFaces> faces = FindFaces(sets);
  std::vector<int> cells, order(sets.Mesh.Kinds.size());
  for (const ExodusBlock& block : blocks)
  {
    for (const int cell : block.Cells)
    {
      order[cell] = static_cast<int>(cells.size());
      cells.push_back(cell);
    }
  }
  NetCDF content;
  content.AddAttribute("api_version", 5.22F);
  content.AddAttribute("version", 5.22F);
  content.AddAttribute("floating_point_word_size", 8);
  content.AddAttribute("file_size", 1); // coordinates in three variables
  content.AddAttribute("title", std::string("ShapeMap"));
  const int names = content.AddDimension("len_string", nameLength);
  content.AddDimension("len_line", 81);
  content.AddDimension("four", 4);
  const int steps = content.AddDimension("time_step", 0);
  const int dimensions = content.AddDimension("num_dim", 3);
  const int nodes = content.AddDimension("num_nodes", sets.Mesh.Points.rows());
  const int elements = content.AddDimension("num_elem", cells.size());
  content.AddTexts("coor_names", { dimensions, names }, { "x", "y", "z" }, nameLength);
  for (int k = 0; k < 3; ++k)
  {
    content.AddDoubles(
      std::string("coord") + "xyz" [k], { nodes },
      [&sets, k](std::size_t i) { return sets.Mesh.Points(static_cast<Eigen::Index>(i), k); });
  }
  content.AddIntegers("elem_num_map", { elements }, From(cells, 1));
  AddMembers(content, "eb", "num_el_blk", names, blocks);
  AddBlocks(content, sets, blocks);
  if (!faces.empty())
  {
    AddMembers(content, "ns", "num_node_sets", names, faces);
    AddMembers(content, "ss", "num_side_sets", names, faces);
    AddSets(content, faces, order);
  }
  content.AddDoubles("time_whole", { steps }, [](std::size_t) { return 0.0; });
  content.Write(file, progress.Part(0.1, 1.0));
  progress(1.0);
}

} // namespace shape
