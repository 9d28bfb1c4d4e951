#include "IO/MeditWriter.h"

#include "IO/Private/ExactText.h"

#include <map>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using namespace cell_kind;

/// The integers of an element: its vertices, numbered from 1, and its reference.
using Element = std::vector<int>;

/// Writes the elements of each kind.
std::map<int, std::vector<Element>> Elements(const MeshSets& sets)
{
  const Cells& mesh = sets.Mesh;
  std::map<int, std::vector<Element>> elements;
  for (Eigen::Index cell = 0; cell < mesh.Kinds.size(); ++cell)
  {
    Element element;
    for (int k = mesh.Offsets(cell); k < mesh.Offsets(cell + 1); ++k)
    {
      element.push_back(mesh.Corners(k) + 1);
    }
    if (mesh.Kinds(cell) != Vertex) // for a vertex the file has only the number, no reference
    {
      element.push_back(sets.Regions(cell) + 1);
    }
    elements[mesh.Kinds(cell)].push_back(std::move(element));
  }
  if (elements.count(Quadrilateral) + elements.count(Triangle) > 0)
  {
    return elements;
  }
  const auto add = [&](const SolidFaces& faces, Eigen::Index face, int reference)
  {
    Element element;
    for (int k = 0; k < 4 && faces.Corners(face, k) >= 0; ++k)
    {
      element.push_back(faces.Corners(face, k) + 1);
    }
    const int kind = element.size() == 3 ? Triangle : Quadrilateral;
    element.push_back(reference);
    elements[kind].push_back(std::move(element));
  };
  for (Eigen::Index face = 0; face < sets.Patches.size(); ++face)
  {
    add(sets.Boundary, face, sets.Patches(face) + 1);
  }
  int reference = sets.PatchCount;
  for (const RegionInterface& between : sets.Interfaces)
  {
    ++reference;
    for (Eigen::Index face = 0; face < between.Faces.Cell.size(); ++face)
    {
      add(between.Faces, face, reference);
    }
  }
  return elements;
}

} // namespace

void WriteMedit(std::ostream& file, const MeshSets& sets, const Progress& progress)
{
  const Eigen::MatrixXd& points = sets.Mesh.Points;
  file << "MeshVersionFormatted 2\nDimension 3\nVertices\n" << points.rows() << '\n';
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    file << ToExactText(points(i, 0)) << ' ' << ToExactText(points(i, 1)) << ' '
         << ToExactText(points(i, 2)) << " 0\n";
    if (i % 65536 == 0)
    {
      progress(0.5 * static_cast<double>(i) / static_cast<double>(points.rows()));
    }
  }
  const auto elements = Elements(sets);
  progress(0.6);
  for (const auto& [kind, keyword] : { std::pair{ Vertex, "Corners" }, std::pair{ Line, "Edges" },
         std::pair{ Triangle, "Triangles" }, std::pair{ Quadrilateral, "Quadrilaterals" },
         std::pair{ Tetrahedron, "Tetrahedra" }, std::pair{ Pyramid, "Pyramids" },
         std::pair{ Wedge, "Prisms" }, std::pair{ Hexahedron, "Hexahedra" } })
  {
    const auto found = elements.find(kind);
    if (found == elements.end())
    {
      continue;
    }
    file << keyword << '\n' << found->second.size() << '\n';
    for (const Element& element : found->second)
    {
      for (std::size_t k = 0; k < element.size(); ++k)
      {
        file << element[k] << (k + 1 < element.size() ? ' ' : '\n');
      }
    }
    progress(0.9);
  }
  file << "End\n";
  progress(1.0);
}

} // namespace shape
