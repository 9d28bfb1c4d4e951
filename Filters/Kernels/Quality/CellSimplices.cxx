#include "Quality/CellSimplices.h"

#include "Mesh/HexMesh.h"

namespace shape
{
namespace
{

/// The corners of a cell, each with the ends of its three edges, and the factor from a corner's
/// determinant to its share of the volume.
struct CornerTable
{
  std::vector<std::array<int, 4>> Corners;
  double Share;
};

const CornerTable& TableOf(CellShape shape)
{
  // For affine images of the regular cells, the determinant at a corner is three times the volume
  // of a pyramid, twice the volume of a wedge, and the volume of a hexahedron. The share divides by
  // this factor and by the number of corners.
  static const CornerTable triangle{ { { 0, 1, 2, -1 } }, 1.0 / 2.0 };
  static const CornerTable tetrahedron{ { { 0, 1, 2, 3 } }, 1.0 / 6.0 };
  static const CornerTable pyramid{
    { { 0, 1, 3, 4 }, { 1, 2, 0, 4 }, { 2, 3, 1, 4 }, { 3, 0, 2, 4 } }, 1.0 / (4.0 * 3.0)
  };
  static const CornerTable wedge{ { { 0, 1, 2, 3 }, { 1, 2, 0, 4 }, { 2, 0, 1, 5 }, { 3, 5, 4, 0 },
                                    { 4, 3, 5, 1 }, { 5, 4, 3, 2 } },
    1.0 / (6.0 * 2.0) };
  static const CornerTable hexahedron = []
  {
    CornerTable table{ {}, 1.0 / 8.0 };
    for (int corner = 0; corner < 8; ++corner)
    {
      const int* ends = HexNeighbours[corner];
      table.Corners.push_back({ corner, ends[0], ends[1], ends[2] });
    }
    return table;
  }();
  switch (shape)
  {
    case CellShape::Triangle:
      return triangle;
    case CellShape::Tetrahedron:
      return tetrahedron;
    case CellShape::Pyramid:
      return pyramid;
    case CellShape::Wedge:
      return wedge;
    case CellShape::Hexahedron:
      break;
  }
  return hexahedron;
}

} // namespace

void CellSimplices::Add(CellShape shape, const int* points)
{
  const CornerTable& table = TableOf(shape);
  for (const std::array<int, 4>& corner : table.Corners)
  {
    std::array<int, 4> ids;
    for (int k = 0; k < 4; ++k)
    {
      ids[k] = corner[k] < 0 ? -1 : points[corner[k]];
    }
    this->Corners.push_back(ids);
    this->Shares.push_back(table.Share);
  }
}

void CellSimplices::EndCell()
{
  this->Offsets.push_back(static_cast<int>(this->Corners.size()));
}

} // namespace shape
