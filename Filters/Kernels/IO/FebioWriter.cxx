#include "IO/FebioWriter.h"

#include "IO/Private/ElementBlocks.h"
#include "IO/Private/ExactText.h"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace shape
{
namespace
{

using namespace cell_kind;

/// FEBio's name of a kind of element.
const char* FebioType(int kind)
{
  switch (kind)
  {
    case Line:
      return "line2";
    case Triangle:
      return "tri3";
    case Quadrilateral:
      return "quad4";
    case Tetrahedron:
      return "tet4";
    case Pyramid:
      return "pyra5";
    case Wedge:
      return "penta6";
    default:
      return "hex8";
  }
}

/// Whether the block consists of faces of solid cells, not of cells of the mesh.
bool AreFaces(const ElementBlock& block, const MeshSets& sets)
{
  return block.Numbers.front() > sets.Mesh.Kinds.size();
}

void WriteFebioElement(
  std::ostream& file, const char* tag, int number, const Eigen::RowVectorXi& corners)
{
  file << "\t\t\t<" << tag << " id=\"" << number << "\">";
  for (Eigen::Index k = 0; k < corners.size(); ++k)
  {
    file << (k == 0 ? "" : ",") << corners(k) + 1;
  }
  file << "</" << tag << ">\n";
}

void WriteFebioNodes(std::ostream& file, const Eigen::MatrixXd& points, const Progress& progress)
{
  file << "\t\t<Nodes name=\"Nodes\">\n";
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    file << "\t\t\t<node id=\"" << i + 1 << "\">" << ToExactText(points(i, 0)) << ','
         << ToExactText(points(i, 1)) << ',' << ToExactText(points(i, 2)) << "</node>\n";
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(points.rows()));
    }
  }
  file << "\t\t</Nodes>\n";
}

void WriteFebioNodeSet(std::ostream& file, const std::string& name, const std::set<int>& points)
{
  file << "\t\t<NodeSet name=\"" << name << "\">\n\t\t\t";
  const char* separator = "";
  for (const int point : points)
  {
    file << separator << point + 1;
    separator = ",";
  }
  file << "\n\t\t</NodeSet>\n";
}

/// Returns the name of each part. The kinds of cells of a set are parts of their own.
std::vector<std::string> FindPartNames(const std::vector<ElementBlock>& blocks)
{
  std::map<std::string, int> kinds; // of each set
  for (const ElementBlock& block : blocks)
  {
    kinds[block.Set] += block.Kind != Vertex;
  }
  std::vector<std::string> names;
  for (const ElementBlock& block : blocks)
  {
    names.push_back(
      block.Set + (kinds.at(block.Set) > 1 ? std::string("_") + FebioType(block.Kind) : ""));
  }
  return names;
}

void WriteFebioMaterials(std::ostream& file, const MeshMaterials& materials)
{
  file << "\t<Material>\n";
  int id = 0;
  for (const auto& [number, material] : materials.ByNumber)
  {
    file << "\t\t<material id=\"" << ++id << "\" name=\"Material" << number
         << "\" type=\"isotropic elastic\">\n\t\t\t<density>" << ToExactText(material.Density)
         << "</density>\n\t\t\t<E>" << ToExactText(material.Modulus) << "</E>\n\t\t\t<v>"
         << ToExactText(material.PoissonRatio) << "</v>\n\t\t</material>\n";
  }
  file << "\t</Material>\n";
}

void WriteFebioDomains(std::ostream& file, const std::vector<ElementBlock>& blocks)
{
  const std::vector<std::string> names = FindPartNames(blocks);
  file << "\t<MeshDomains>\n";
  for (std::size_t i = 0; i < blocks.size(); ++i)
  {
    if (blocks[i].Material >= 0)
    {
      file << "\t\t<SolidDomain name=\"" << names[i] << "\" mat=\"Material" << blocks[i].Material
           << "\"/>\n";
    }
  }
  file << "\t</MeshDomains>\n";
}

void WriteFebioParts(std::ostream& file, const std::vector<ElementBlock>& blocks,
  const MeshSets& sets, const Progress& progress)
{
  const std::vector<std::string> names = FindPartNames(blocks);
  std::size_t done = 0;
  for (std::size_t part = 0; part < blocks.size(); ++part)
  {
    const ElementBlock& block = blocks[part];
    if (block.Kind == Vertex || AreFaces(block, sets))
    {
      continue;
    }
    file << "\t\t<Elements type=\"" << FebioType(block.Kind) << "\" name=\"" << names[part]
         << "\">\n";
    for (Eigen::Index i = 0; i < block.Corners.rows(); ++i)
    {
      WriteFebioElement(file, "elem", block.Numbers[i], block.Corners.row(i));
      if (++done % 65536 == 0)
      {
        progress(static_cast<double>(done) / static_cast<double>(sets.Mesh.Kinds.size()));
      }
    }
    file << "\t\t</Elements>\n";
  }
}

/// Writes the sets of nodes and the surfaces. A surface may have two kinds of faces.
void WriteFebioSurfaces(
  std::ostream& file, const std::vector<ElementBlock>& blocks, const MeshSets& sets)
{
  std::set<int> vertices;
  std::map<int, std::vector<const ElementBlock*>> surfaces; // by number
  for (const ElementBlock& block : blocks)
  {
    if (block.Kind == Vertex)
    {
      vertices.insert(block.Corners.reshaped().begin(), block.Corners.reshaped().end());
    }
    else if (AreFaces(block, sets))
    {
      surfaces[block.SetNumber].push_back(&block);
    }
  }
  if (!vertices.empty())
  {
    WriteFebioNodeSet(file, "Points", vertices);
  }
  for (const auto& [number, parts] : surfaces)
  {
    std::set<int> points;
    for (const ElementBlock* part : parts)
    {
      points.insert(part->Corners.reshaped().begin(), part->Corners.reshaped().end());
    }
    WriteFebioNodeSet(file, parts.front()->Set, points);
  }
  for (const auto& [number, parts] : surfaces)
  {
    file << "\t\t<Surface name=\"" << parts.front()->Set << "\">\n";
    int face = 0;
    for (const ElementBlock* part : parts)
    {
      for (Eigen::Index i = 0; i < part->Corners.rows(); ++i)
      {
        WriteFebioElement(file, FebioType(part->Kind), ++face, part->Corners.row(i));
      }
    }
    file << "\t\t</Surface>\n";
  }
}

} // namespace

void WriteFebio(std::ostream& file, const MeshSets& sets, const Progress& progress)
{
  const std::vector<ElementBlock> blocks = GroupElements(sets);
  const bool hasMaterials = !sets.Materials.ByNumber.empty();
  file << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<febio_spec version=\"4.0\">\n";
  if (hasMaterials)
  {
    WriteFebioMaterials(file, sets.Materials);
  }
  file << "\t<Mesh>\n";
  WriteFebioNodes(file, sets.Mesh.Points, progress.Part(0.1, 0.5));
  WriteFebioParts(file, blocks, sets, progress.Part(0.5, 0.9));
  WriteFebioSurfaces(file, blocks, sets);
  file << "\t</Mesh>\n";
  if (hasMaterials)
  {
    WriteFebioDomains(file, blocks);
  }
  file << "</febio_spec>\n";
  progress(1.0);
}

} // namespace shape
