#pragma once

#include <array>
#include <cstdint>

namespace shape
{

/// A cube of a surface net, whose corners are neighbouring samples of an image (SurfaceNet).
namespace net_cube
{

// Axis a of a cube is followed by axes (a + 1) % 3 and (a + 2) % 3. Corner bits are x, y, z. Edge
// 4 a + u + 2 v is parallel to axis a, at positions u and v of the axes that follow.
constexpr int CubeEdges = 12;

constexpr int Following(int axis, int steps)
{
  return (axis + steps) % 3;
}

constexpr int EdgeOf(int axis, int u, int v)
{
  return 4 * axis + u + 2 * v;
}

/// The corners and edges of a cube's face, in cyclic order; edge i joins corners i and i + 1.
struct CubeFace
{
  std::array<int, 4> Corners, Edges;
};

constexpr CubeFace MakeFace(int axis, int side)
{
  const int b = Following(axis, 1), c = Following(axis, 2);
  const int base = side << axis;
  // The axes after b are c and `axis`; those after c are `axis` and b.
  return { { base, base | 1 << b, base | 1 << b | 1 << c, base | 1 << c },
    { EdgeOf(b, 0, side), EdgeOf(c, side, 1), EdgeOf(b, 1, side), EdgeOf(c, side, 0) } };
}

constexpr std::array<CubeFace, 6> Faces = { MakeFace(0, 0), MakeFace(0, 1), MakeFace(1, 0),
  MakeFace(1, 1), MakeFace(2, 0), MakeFace(2, 1) };

/// The two corners of a cube's edge.
constexpr std::array<int, 2> CornersOf(int edge)
{
  const int axis = edge / 4, u = edge & 1, v = (edge >> 1) & 1;
  const int first = u << Following(axis, 1) | v << Following(axis, 2);
  return { first, first | 1 << axis };
}

/// How the interfaces that cross a face's edges continue through the face.
enum class Sheets
{
  Joined,        ///< all meet, or there are at most two
  AroundCorner1, ///< edges 0 and 1, and edges 2 and 3
  AroundCorner2  ///< edges 1 and 2, and edges 3 and 0
};

/// A cube with more than one label.
struct Cube
{
  std::array<int, 8> Labels;
  std::array<std::int8_t, CubeEdges> SheetOf; ///< -1: both corners have one label
  int FirstPoint = 0;
  int Count = 0; ///< of sheets, each of which has a point
};

/// labels: of the face's corners, in cyclic order.
Sheets FindSheets(const std::array<int, 4>& labels);

/// Returns the labels of the face's corners, in cyclic order.
std::array<int, 4> LabelsOf(const Cube& cube, const CubeFace& face);

/// Numbers the sheets of interfaces in a cube: two crossed edges belong to one sheet if interfaces
/// run from one to the other through faces.
void NumberSheets(Cube& cube);

} // namespace net_cube
} // namespace shape
