#include "IO/Private/ElementBlocks.h"

#include <map>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

using namespace cell_kind;

/// The blocks in their order: by dimension, highest first, number of the set, and kind.
class BlockList
{
public:
  void Add(int kind, const std::string& set, int setNumber, int number, std::vector<int> corners,
    int material = -1)
  {
    Growing& block = this->Blocks[{ -GetDimension(kind), setNumber, kind }];
    block.Set = set;
    block.Material = material;
    block.Numbers.push_back(number);
    block.Corners.insert(block.Corners.end(), corners.begin(), corners.end());
  }

  std::vector<ElementBlock> Finish()
  {
    std::vector<ElementBlock> blocks;
    for (auto& [key, growing] : this->Blocks)
    {
      const auto count = static_cast<Eigen::Index>(growing.Numbers.size());
      ElementBlock block;
      block.Kind = std::get<2>(key);
      block.Set = growing.Set;
      block.SetNumber = std::get<1>(key);
      block.Material = growing.Material;
      block.Corners =
        Eigen::Map<const Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>(
          growing.Corners.data(), count, static_cast<Eigen::Index>(growing.Corners.size()) / count);
      block.Numbers = std::move(growing.Numbers);
      blocks.push_back(std::move(block));
    }
    return blocks;
  }

private:
  struct Growing
  {
    std::string Set;
    int Material;
    std::vector<int> Numbers, Corners;
  };
  std::map<std::tuple<int, int, int>, Growing> Blocks;
};

/// The set of cells: a region and, if there are materials, a material.
struct CellSet
{
  int Region;
  int Material;
  int Number; ///< from 1
};

/// Returns the set of each cell.
std::vector<CellSet> FindCellSets(const MeshSets& sets)
{
  const bool hasMaterials = sets.Materials.OfCell.size() > 0;
  std::vector<CellSet> found;
  std::map<std::pair<int, int>, int> numbers;
  for (int cell = 0; cell < static_cast<int>(sets.Mesh.Kinds.size()); ++cell)
  {
    const bool isSolid = GetDimension(sets.Mesh.Kinds(cell)) == 3;
    const int material = hasMaterials && isSolid ? sets.Materials.OfCell(cell) : -1;
    found.push_back({ sets.Regions(cell), material, sets.Regions(cell) + 1 });
    numbers[{ sets.Regions(cell), material }];
  }
  int next = 1;
  for (auto& [pair, number] : numbers)
  {
    number = next++;
  }
  for (std::size_t cell = 0; cell < found.size() && hasMaterials; ++cell)
  {
    found[cell].Number = numbers.at({ found[cell].Region, found[cell].Material });
  }
  return found;
}

std::string NameOf(const CellSet& set)
{
  const std::string region = "Region" + std::to_string(set.Region);
  return set.Material < 0 ? region : region + "_Material" + std::to_string(set.Material);
}

} // namespace

std::vector<ElementBlock> GroupElements(const MeshSets& sets)
{
  const Cells& mesh = sets.Mesh;
  const std::vector<CellSet> cellSets = FindCellSets(sets);
  BlockList blocks;
  bool hasSurfaceCells = false;
  for (int cell = 0; cell < static_cast<int>(mesh.Kinds.size()); ++cell)
  {
    const auto corners =
      mesh.Corners.segment(mesh.Offsets(cell), mesh.Offsets(cell + 1) - mesh.Offsets(cell));
    const CellSet& set = cellSets[cell];
    blocks.Add(mesh.Kinds(cell), NameOf(set), set.Number, cell + 1,
      { corners.begin(), corners.end() }, set.Material);
    hasSurfaceCells = hasSurfaceCells || GetDimension(mesh.Kinds(cell)) == 2;
  }
  if (!hasSurfaceCells)
  {
    int number = static_cast<int>(mesh.Kinds.size());
    const auto add =
      [&](const SolidFaces& faces, Eigen::Index face, const std::string& set, int setNumber)
    {
      std::vector<int> corners;
      for (int k = 0; k < 4 && faces.Corners(face, k) >= 0; ++k)
      {
        corners.push_back(faces.Corners(face, k));
      }
      const int kind = corners.size() == 3 ? Triangle : Quadrilateral;
      blocks.Add(kind, set, setNumber, ++number, std::move(corners));
    };
    for (Eigen::Index face = 0; face < sets.Patches.size(); ++face)
    {
      const int patch = sets.Patches(face);
      add(sets.Boundary, face, "Patch" + std::to_string(patch), patch + 1);
    }
    int setNumber = sets.PatchCount;
    for (const RegionInterface& between : sets.Interfaces)
    {
      const std::string set =
        "Interface" + std::to_string(between.Lower) + "_" + std::to_string(between.Upper);
      ++setNumber;
      for (Eigen::Index face = 0; face < between.Faces.Cell.size(); ++face)
      {
        add(between.Faces, face, set, setNumber);
      }
    }
  }
  return blocks.Finish();
}

} // namespace shape
