#include "IO/GmshWriter.h"

#include "IO/Private/ElementBlocks.h"
#include "IO/Private/ExactText.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using namespace cell_kind;

/// Gmsh's number of a kind of element.
int GmshType(int kind)
{
  switch (kind)
  {
    case Line:
      return 1;
    case Triangle:
      return 2;
    case Quadrilateral:
      return 3;
    case Tetrahedron:
      return 4;
    case Hexahedron:
      return 5;
    case Wedge:
      return 6;
    case Pyramid:
      return 7;
    default:
      return 15; // a point
  }
}

/// The sets of each dimension, by number. Each is an entity and a physical group of this number.
using EntityLists = std::array<std::map<int, std::string>, 4>;

EntityLists FindEntities(const std::vector<ElementBlock>& blocks)
{
  EntityLists entities;
  for (const ElementBlock& block : blocks)
  {
    entities[GetDimension(block.Kind)][block.SetNumber] = block.Set;
  }
  return entities;
}

void WritePhysicalNames(std::ostream& file, const EntityLists& entities)
{
  std::size_t count = 0;
  for (const auto& sets : entities)
  {
    count += sets.size();
  }
  file << "$PhysicalNames\n" << count << '\n';
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    for (const auto& [number, name] : entities[dimension])
    {
      file << dimension << ' ' << number << " \"" << name << "\"\n";
    }
  }
  file << "$EndPhysicalNames\n";
}

void WriteEntities(std::ostream& file, const EntityLists& entities, const Eigen::MatrixXd& points)
{
  // The format asks for a box; that of the mesh bounds each entity. A point entity has a position.
  std::string box, corner;
  for (const Eigen::RowVector3d& extreme : { Eigen::RowVector3d(points.colwise().minCoeff()),
         Eigen::RowVector3d(points.colwise().maxCoeff()) })
  {
    for (const double coordinate : extreme)
    {
      box += ToExactText(coordinate) + ' ';
    }
    corner = corner.empty() ? box : corner;
  }
  file << "$Entities\n";
  for (const auto& sets : entities)
  {
    file << sets.size() << (&sets == &entities.back() ? '\n' : ' ');
  }
  for (int dimension = 0; dimension < 4; ++dimension)
  {
    for (const auto& [number, name] : entities[dimension])
    {
      // Number, box, one physical group, and no bounding entities, which points do not have.
      file << number << ' ' << (dimension == 0 ? corner : box) << "1 " << number
           << (dimension == 0 ? "\n" : " 0\n");
    }
  }
  file << "$EndEntities\n";
}

void WriteGmshNodes(std::ostream& file, const Eigen::MatrixXd& points, int dimension, int entity,
  const Progress& progress)
{
  // All nodes belong to one entity: the format does not require more.
  const Eigen::Index count = points.rows();
  file << "$Nodes\n1 " << count << " 1 " << count << '\n'
       << dimension << ' ' << entity << " 0 " << count << '\n';
  for (Eigen::Index i = 0; i < count; ++i)
  {
    file << i + 1 << '\n';
  }
  for (Eigen::Index i = 0; i < count; ++i)
  {
    file << ToExactText(points(i, 0)) << ' ' << ToExactText(points(i, 1)) << ' '
         << ToExactText(points(i, 2)) << '\n';
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(count));
    }
  }
  file << "$EndNodes\n";
}

void WriteGmshElements(
  std::ostream& file, const std::vector<ElementBlock>& blocks, const Progress& progress)
{
  std::size_t count = 0;
  int last = 0;
  for (const ElementBlock& block : blocks)
  {
    count += block.Numbers.size();
    last = std::max(last, block.Numbers.back());
  }
  file << "$Elements\n" << blocks.size() << ' ' << count << " 1 " << last << '\n';
  std::size_t done = 0;
  for (const ElementBlock& block : blocks)
  {
    file << GetDimension(block.Kind) << ' ' << block.SetNumber << ' ' << GmshType(block.Kind) << ' '
         << block.Numbers.size() << '\n';
    for (Eigen::Index i = 0; i < block.Corners.rows(); ++i)
    {
      file << block.Numbers[i];
      for (const int corner : block.Corners.row(i))
      {
        file << ' ' << corner + 1;
      }
      file << '\n';
      if (++done % 65536 == 0)
      {
        progress(static_cast<double>(done) / static_cast<double>(count));
      }
    }
  }
  file << "$EndElements\n";
}

} // namespace

void WriteGmsh(std::ostream& file, const MeshSets& sets, const Progress& progress)
{
  const std::vector<ElementBlock> blocks = GroupElements(sets);
  const EntityLists entities = FindEntities(blocks);
  file << "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";
  WritePhysicalNames(file, entities);
  WriteEntities(file, entities, sets.Mesh.Points);
  WriteGmshNodes(file, sets.Mesh.Points, GetDimension(blocks.front().Kind),
    blocks.front().SetNumber, progress.Part(0.1, 0.5));
  WriteGmshElements(file, blocks, progress.Part(0.5, 1.0));
  progress(1.0);
}

} // namespace shape
