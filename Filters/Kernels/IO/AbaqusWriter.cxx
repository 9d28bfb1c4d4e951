#include "IO/AbaqusWriter.h"

#include "IO/Private/ColumnText.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace shape
{
namespace
{

using namespace cell_kind;

constexpr std::size_t Columns = 20; ///< columns of a number that Abaqus reads
constexpr int PerLine = 16;         ///< maximum number of entries in a line of a set

struct ElementKind
{
  int Kind;
  const char* Type;
  const char* Set;
};

std::vector<ElementKind> ElementKinds(HexahedronType hexahedra)
{
  const char* const types[] = { "C3D8", "C3D8R", "C3D8I" };
  return { { Hexahedron, types[static_cast<int>(hexahedra)], "Hexahedra" },
    { Tetrahedron, "C3D4", "Tetrahedra" }, { Wedge, "C3D6", "Wedges" },
    { Pyramid, "C3D5", "Pyramids" }, { Quadrilateral, "S4", "Quadrilaterals" },
    { Triangle, "S3", "Triangles" }, { Line, "T3D2", "Lines" } };
}

/// Returns Abaqus's number of a face of GetFaces(kind).
int AbaqusFace(int kind, int face)
{
  constexpr int hexahedron[] = { 6, 4, 3, 5, 1, 2 }, tetrahedron[] = { 2, 3, 4, 1 };
  return kind == Hexahedron ? hexahedron[face] : kind == Tetrahedron ? tetrahedron[face] : face + 1;
}

void WriteNodes(std::ostream& file, const Eigen::MatrixXd& points, const Progress& progress)
{
  file << "*NODE\n";
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    file << i + 1;
    for (int k = 0; k < 3; ++k)
    {
      file << ", " << ToColumnText(points(i, k), Columns);
    }
    file << '\n';
    if (i % 65536 == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(points.rows()));
    }
  }
}

void WriteElements(
  std::ostream& file, const Cells& mesh, HexahedronType hexahedra, const Progress& progress)
{
  for (const auto& [kind, type, set] : ElementKinds(hexahedra))
  {
    bool begun = false;
    for (Eigen::Index cell = 0; cell < mesh.Kinds.size(); ++cell)
    {
      if (mesh.Kinds(cell) != kind)
      {
        continue;
      }
      if (!begun)
      {
        file << "*ELEMENT, TYPE=" << type << ", ELSET=" << set << '\n';
        begun = true;
      }
      file << cell + 1;
      for (int k = mesh.Offsets(cell); k < mesh.Offsets(cell + 1); ++k)
      {
        file << ", " << mesh.Corners(k) + 1;
      }
      file << '\n';
      if (cell % 65536 == 0)
      {
        progress(0.0);
      }
    }
  }
}

/// Writes `keyword`, for example "*NSET, NSET=" with the set's name, and then ids + 1.
void WriteSet(std::ostream& file, const std::string& keyword, const std::vector<int>& ids)
{
  if (ids.empty())
  {
    return;
  }
  file << keyword << '\n';
  for (std::size_t i = 0; i < ids.size(); ++i)
  {
    const bool last = i + 1 == ids.size() || (i + 1) % PerLine == 0;
    file << ids[i] + 1 << (last ? "\n" : ", ");
  }
}

void WriteRegions(std::ostream& file, const MeshSets& sets)
{
  std::map<int, std::vector<int>> cells;
  std::vector<int> points;
  for (int cell = 0; cell < sets.Mesh.Kinds.size(); ++cell)
  {
    if (sets.Mesh.Kinds(cell) == Vertex)
    {
      points.push_back(sets.Mesh.Corners(sets.Mesh.Offsets(cell)));
    }
    else if (GetDimension(sets.Mesh.Kinds(cell)) == sets.Dimension)
    {
      cells[sets.Regions(cell)].push_back(cell);
    }
  }
  for (const auto& [region, members] : cells)
  {
    WriteSet(file, "*ELSET, ELSET=Region" + std::to_string(region), members);
  }
  WriteSet(file, "*NSET, NSET=Points", points);
}

void WriteMaterials(std::ostream& file, const MeshSets& sets)
{
  std::map<int, std::vector<int>> cells;
  for (int cell = 0; cell < sets.Materials.OfCell.size(); ++cell)
  {
    if (GetDimension(sets.Mesh.Kinds(cell)) == 3)
    {
      cells[sets.Materials.OfCell(cell)].push_back(cell);
    }
  }
  for (const auto& [number, members] : cells)
  {
    const std::string name = "Material" + std::to_string(number);
    const MeshMaterial& material = sets.Materials.ByNumber.at(number);
    WriteSet(file, "*ELSET, ELSET=" + name, members);
    file << "*MATERIAL, NAME=" << name << "\n*ELASTIC\n"
         << ToColumnText(material.Modulus, Columns) << ", "
         << ToColumnText(material.PoissonRatio, Columns) << '\n';
    if (material.Density > 0.0)
    {
      file << "*DENSITY\n" << ToColumnText(material.Density, Columns) << '\n';
    }
    file << "*SOLID SECTION, ELSET=" << name << ", MATERIAL=" << name << '\n';
  }
}

std::vector<int> All(const SolidFaces& faces)
{
  std::vector<int> all(faces.Cell.size());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

void WriteBoundary(std::ostream& file, const MeshSets& sets)
{
  const SolidFaces& boundary = sets.Boundary;
  WriteSet(file, "*NSET, NSET=Boundary", PointsOf(boundary.Corners, All(boundary)));
  int patch = 0;
  for (const std::vector<int>& faces : GroupFacesByPatch(sets))
  {
    const std::string number = std::to_string(patch++);
    if (faces.empty())
    {
      continue;
    }
    WriteSet(file, "*NSET, NSET=Patch" + number, PointsOf(boundary.Corners, faces));
    file << "*SURFACE, NAME=PatchSurface" << number << ", TYPE=ELEMENT\n";
    for (const int face : faces)
    {
      const int cell = boundary.Cell(face);
      file << cell + 1 << ", S" << AbaqusFace(sets.Mesh.Kinds(cell), boundary.Face(face)) << '\n';
    }
  }
  for (const RegionInterface& between : sets.Interfaces)
  {
    WriteSet(file,
      "*NSET, NSET=Interface" + std::to_string(between.Lower) + "_" + std::to_string(between.Upper),
      PointsOf(between.Faces.Corners, All(between.Faces)));
  }
}

} // namespace

void WriteAbaqus(std::ostream& file, const MeshSets& sets, const AbaqusWriterOptions& options,
  const Progress& progress)
{
  file << "** Written by ShapeMap: node = point + 1, element = cell + 1\n";
  WriteNodes(file, sets.Mesh.Points, progress.Part(0.0, 0.4));
  WriteElements(file, sets.Mesh, options.HexahedronType, progress.Part(0.4, 0.8));
  WriteRegions(file, sets);
  WriteMaterials(file, sets);
  progress(0.9);
  WriteBoundary(file, sets);
  progress(1.0);
}

} // namespace shape
