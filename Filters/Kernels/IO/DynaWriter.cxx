#include "IO/DynaWriter.h"

#include "Base/Errors.h"
#include "IO/Private/ColumnText.h"
#include "IO/Private/ElementBlocks.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace shape
{
namespace
{

using namespace cell_kind;

constexpr int IdColumns = 8, SetColumns = 10, NumberColumns = 16;

/// Returns the eight nodes of a solid element, as indices into the corners of the cell. The nodes
/// of degenerate hexahedra are repeated as the manual says.
const std::vector<int>& SolidNodes(int kind)
{
  static const std::vector<int> hexahedron = { 0, 1, 2, 3, 4, 5, 6, 7 },
                                tetrahedron = { 0, 1, 2, 3, 3, 3, 3, 3 },
                                pyramid = { 0, 1, 2, 3, 4, 4, 4, 4 },
                                wedge = { 3, 4, 1, 0, 5, 5, 2, 2 };
  return kind == Hexahedron ? hexahedron
    : kind == Tetrahedron   ? tetrahedron
    : kind == Pyramid       ? pyramid
                            : wedge;
}

/// Returns the four nodes of a shell or segment.
std::vector<int> ShellNodes(const Eigen::RowVectorXi& corners)
{
  return { corners(0), corners(1), corners(2), corners(corners.size() - 1) };
}

void WriteDynaNodes(std::ostream& file, const Eigen::MatrixXd& points, const Progress& progress)
{
  file << "*NODE\n";
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    file << std::setw(IdColumns) << i + 1;
    for (int k = 0; k < 3; ++k)
    {
      file << std::setw(NumberColumns) << ToColumnText(points(i, k), NumberColumns);
    }
    file << '\n';
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(points.rows()));
    }
  }
}

void WriteDynaElements(std::ostream& file, const ElementBlock& block, const Progress& progress)
{
  const int dimension = GetDimension(block.Kind);
  file << (dimension == 3 ? "*ELEMENT_SOLID\n"
      : dimension == 2    ? "*ELEMENT_SHELL\n"
                          : "*ELEMENT_BEAM\n");
  for (Eigen::Index i = 0; i < block.Corners.rows(); ++i)
  {
    file << std::setw(IdColumns) << block.Numbers[i] << std::setw(IdColumns) << block.SetNumber;
    const Eigen::RowVectorXi corners = block.Corners.row(i);
    std::vector<int> nodes;
    if (dimension == 3)
    {
      for (const int k : SolidNodes(block.Kind))
      {
        nodes.push_back(corners(k));
      }
    }
    else
    {
      nodes = dimension == 2 ? ShellNodes(corners) : std::vector<int>{ corners(0), corners(1) };
    }
    for (const int node : nodes)
    {
      file << std::setw(IdColumns) << node + 1;
    }
    file << '\n';
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(block.Corners.rows()));
    }
  }
}

/// A set of elements, of one or several kinds.
struct Part
{
  std::string Title;
  int Material = -1;
};

/// Writes the parts and, if there are materials, a section of solids that they share.
void WriteDynaParts(
  std::ostream& file, const std::map<int, Part>& parts, const MeshMaterials& materials)
{
  for (const auto& [number, part] : parts)
  {
    file << "*PART\n" << part.Title << '\n' << std::setw(SetColumns) << number;
    if (part.Material >= 0)
    {
      file << std::setw(SetColumns) << 1 << std::setw(SetColumns) << part.Material + 1;
    }
    file << '\n';
  }
  if (!materials.ByNumber.empty())
  {
    file << "*SECTION_SOLID\n" << std::setw(SetColumns) << 1 << std::setw(SetColumns) << 1 << '\n';
  }
  for (const auto& [number, material] : materials.ByNumber)
  {
    // A number of SetColumns columns would touch the next one.
    const auto text = [](double value) { return ToColumnText(value, SetColumns - 1); };
    file << "*MAT_ELASTIC\n"
         << std::setw(SetColumns) << number + 1 << std::setw(SetColumns) << text(material.Density)
         << std::setw(SetColumns) << text(material.Modulus) << std::setw(SetColumns)
         << text(material.PoissonRatio) << '\n';
  }
}

void WriteDynaNodeSet(
  std::ostream& file, const std::string& title, int number, const std::set<int>& points)
{
  file << "*SET_NODE_LIST_TITLE\n" << title << '\n' << std::setw(SetColumns) << number << '\n';
  int column = 0;
  for (const int point : points)
  {
    constexpr int perLine = 8;
    file << std::setw(SetColumns) << point + 1 << (++column % perLine == 0 ? "\n" : "");
    column %= perLine;
  }
  file << (column > 0 ? "\n" : "");
}

/// The faces of a set, of one or two kinds.
struct FaceSet
{
  std::string Title;
  std::vector<std::vector<int>> Segments;
  std::set<int> Points;
};

void WriteDynaFaceSets(std::ostream& file, const std::map<int, FaceSet>& faceSets)
{
  for (const auto& [number, faces] : faceSets)
  {
    WriteDynaNodeSet(file, faces.Title, number, faces.Points);
    file << "*SET_SEGMENT_TITLE\n"
         << faces.Title << '\n'
         << std::setw(SetColumns) << number << '\n';
    for (const std::vector<int>& segment : faces.Segments)
    {
      for (const int point : segment)
      {
        file << std::setw(SetColumns) << point + 1;
      }
      file << '\n';
    }
  }
}

} // namespace

void WriteDyna(std::ostream& file, const MeshSets& sets, const Progress& progress)
{
  const std::vector<ElementBlock> blocks = GroupElements(sets);
  const Eigen::Index largest = std::max(sets.Mesh.Points.rows(), sets.Mesh.Kinds.size());
  if (largest > 99999999)
  {
    throw InvalidInput("the mesh has " + std::to_string(largest) +
      " points or cells, but the format has room for 99,999,999; write another format");
  }
  file << "*KEYWORD\n$ Written by ShapeMap: node = point + 1, element = cell + 1\n";
  WriteDynaNodes(file, sets.Mesh.Points, progress.Part(0.1, 0.5));
  std::map<int, Part> parts;
  std::map<int, FaceSet> faceSets;
  std::set<int> vertices;
  for (const ElementBlock& block : blocks)
  {
    const auto points = block.Corners.reshaped();
    if (block.Kind == Vertex)
    {
      vertices.insert(points.begin(), points.end());
    }
    else if (block.Numbers.front() > sets.Mesh.Kinds.size())
    {
      FaceSet& faces = faceSets[block.SetNumber];
      faces.Title = block.Set;
      faces.Points.insert(points.begin(), points.end());
      for (Eigen::Index i = 0; i < block.Corners.rows(); ++i)
      {
        faces.Segments.push_back(ShellNodes(block.Corners.row(i)));
      }
    }
    else
    {
      parts[block.SetNumber] = { block.Set, block.Material };
      WriteDynaElements(file, block, progress.Part(0.5, 0.9));
    }
  }
  WriteDynaParts(file, parts, sets.Materials);
  WriteDynaFaceSets(file, faceSets);
  if (!vertices.empty())
  {
    WriteDynaNodeSet(file, "Points", faceSets.empty() ? 1 : faceSets.rbegin()->first + 1, vertices);
  }
  file << "*END\n";
  progress(1.0);
}

} // namespace shape
