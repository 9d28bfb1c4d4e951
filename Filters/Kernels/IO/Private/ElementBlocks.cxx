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
  void Add(int kind, const std::string& set, int setNumber, int number, std::vector<int> corners)
  {
    Growing& block = this->Blocks[{ -GetDimension(kind), setNumber, kind }];
    block.Set = set;
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
    std::vector<int> Numbers, Corners;
  };
  std::map<std::tuple<int, int, int>, Growing> Blocks;
};

} // namespace

std::vector<ElementBlock> GroupElements(const MeshSets& sets)
{
  const Cells& mesh = sets.Mesh;
  BlockList blocks;
  bool hasSurfaceCells = false;
  for (int cell = 0; cell < static_cast<int>(mesh.Kinds.size()); ++cell)
  {
    const auto corners =
      mesh.Corners.segment(mesh.Offsets(cell), mesh.Offsets(cell + 1) - mesh.Offsets(cell));
    const int region = sets.Regions(cell);
    blocks.Add(mesh.Kinds(cell), "Region" + std::to_string(region), region + 1, cell + 1,
      { corners.begin(), corners.end() });
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
