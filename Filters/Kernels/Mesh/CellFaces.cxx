#include "Mesh/CellFaces.h"

#include "Mesh/HexMesh.h"

#include <algorithm>
#include <iterator>
#include <tuple>

namespace shape
{

using namespace cell_kind;

int GetCornerCount(int kind)
{
  switch (kind)
  {
    case Vertex:
      return 1;
    case Line:
      return 2;
    case Triangle:
      return 3;
    case Quadrilateral:
    case Tetrahedron:
      return 4;
    case Pyramid:
      return 5;
    case Wedge:
      return 6;
    case Hexahedron:
      return 8;
    default:
      return 0;
  }
}

const std::vector<std::vector<int>>& GetFaces(int kind)
{
  using Faces = std::vector<std::vector<int>>;
  static const Faces tetrahedron = { { 0, 1, 3 }, { 1, 2, 3 }, { 2, 0, 3 }, { 0, 2, 1 } };
  static const Faces pyramid = { { 0, 3, 2, 1 }, { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 },
    { 3, 0, 4 } };
  static const Faces wedge = { { 0, 2, 1 }, { 3, 4, 5 }, { 0, 1, 4, 3 }, { 1, 2, 5, 4 },
    { 2, 0, 3, 5 } };
  static const Faces hexahedron = []
  {
    Faces faces;
    for (const auto& face : HexFaces)
    {
      faces.emplace_back(std::begin(face), std::end(face));
    }
    return faces;
  }();
  static const Faces none;
  return kind == Tetrahedron ? tetrahedron
    : kind == Pyramid        ? pyramid
    : kind == Wedge          ? wedge
    : kind == Hexahedron     ? hexahedron
                             : none;
}

std::vector<CellFace> SortFaces(const Cells& cells)
{
  std::vector<CellFace> all;
  for (int cell = 0; cell < cells.Kinds.size(); ++cell)
  {
    const auto& faces = GetFaces(cells.Kinds(cell));
    for (std::size_t i = 0; i < faces.size(); ++i)
    {
      CellFace face{ { -1, -1, -1, -1 }, cell, static_cast<int>(i) };
      std::transform(faces[i].begin(), faces[i].end(), face.Points.begin(),
        [&](int corner) { return cells.Corners(cells.Offsets(cell) + corner); });
      // Sorted corners: both cells of a face give the same key. A triangle has the entry -1, too.
      std::sort(face.Points.begin(), face.Points.end());
      all.push_back(face);
    }
  }
  std::sort(all.begin(), all.end(),
    [](const CellFace& a, const CellFace& b)
    { return std::tie(a.Points, a.Cell, a.Face) < std::tie(b.Points, b.Cell, b.Face); });
  return all;
}

bool IsBoundaryFace(const std::vector<CellFace>& faces, std::size_t i)
{
  return (i == 0 || faces[i].Points != faces[i - 1].Points) &&
    (i + 1 == faces.size() || faces[i].Points != faces[i + 1].Points);
}

} // namespace shape
