#pragma once

#include "Mesh/Cells.h"
#include "Mesh/HexMesh.h"

#include <array>
#include <functional>
#include <vector>

// Meshes shared by the tests of the writers.
namespace shapetest
{

/// Builds cells one at a time.
class CellList
{
public:
  void Add(int kind, const std::vector<int>& corners)
  {
    this->Kinds.push_back(kind);
    this->Corners.insert(this->Corners.end(), corners.begin(), corners.end());
    this->Offsets.push_back(static_cast<int>(this->Corners.size()));
  }

  shape::Cells Over(const Eigen::MatrixXd& points) const
  {
    const auto map = [](const std::vector<int>& values)
    {
      return Eigen::Map<const Eigen::VectorXi>(
        values.data(), static_cast<Eigen::Index>(values.size()));
    };
    return { points, map(this->Kinds), map(this->Offsets), map(this->Corners) };
  }

private:
  std::vector<int> Kinds, Offsets = { 0 }, Corners;
};

/// Returns, as hexahedra, the unit cubes for which `inside` is true in a block of counts cells. The
/// points are those of the complete lattice.
inline shape::Cells Cubes(
  const std::array<int, 3>& counts, const std::function<bool(int, int, int)>& inside)
{
  const auto index = [&](int x, int y, int z)
  { return x + (counts[0] + 1) * (y + (counts[1] + 1) * z); };
  Eigen::MatrixXd points(index(0, 0, counts[2] + 1), 3);
  CellList cells;
  for (int z = 0; z <= counts[2]; ++z)
  {
    for (int y = 0; y <= counts[1]; ++y)
    {
      for (int x = 0; x <= counts[0]; ++x)
      {
        points.row(index(x, y, z)) << x, y, z;
        if (x < counts[0] && y < counts[1] && z < counts[2] && inside(x, y, z))
        {
          cells.Add(shape::cell_kind::Hexahedron,
            { index(x, y, z), index(x + 1, y, z), index(x + 1, y + 1, z), index(x, y + 1, z),
              index(x, y, z + 1), index(x + 1, y, z + 1), index(x + 1, y + 1, z + 1),
              index(x, y + 1, z + 1) });
        }
      }
    }
  }
  return cells.Over(points);
}

inline bool Everywhere(int, int, int)
{
  return true;
}

/// Returns a hexahedron with a pyramid and a wedge on its faces, and a tetrahedron on the pyramid.
/// Their volumes are 1, 1/3, 1/2 and 1/6. Points 0, 1, 2 of the wedge are counter-clockwise seen
/// from 3, 4, 5.
inline shape::Cells OneOfEach()
{
  Eigen::MatrixXd points(13, 3);
  points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, // the cube
    0, 0, 2,                                                                        // its apex
    2, 0, 0, 2, 1, 0, // the wedge's far edge
    1, 0, 2,          // the tetrahedron's apex
    5, 5, 5;          // a point that no cell uses
  CellList cells;
  cells.Add(shape::cell_kind::Hexahedron, { 0, 1, 2, 3, 4, 5, 6, 7 });
  cells.Add(shape::cell_kind::Pyramid, { 4, 5, 6, 7, 8 });
  cells.Add(shape::cell_kind::Wedge, { 1, 5, 9, 2, 6, 10 });
  cells.Add(shape::cell_kind::Tetrahedron, { 5, 6, 8, 11 });
  return cells.Over(points);
}

} // namespace shapetest
