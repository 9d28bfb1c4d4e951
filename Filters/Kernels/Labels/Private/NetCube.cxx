#include "Labels/Private/NetCube.h"

#include <numeric>

namespace shape::net_cube
{

Sheets FindSheets(const std::array<int, 4>& labels)
{
  const auto [a, b, c, d] = labels;
  const bool isCrossedFourTimes = a != b && b != c && c != d && d != a;
  if (!isCrossedFourTimes || (a != c && b != d))
  {
    return Sheets::Joined;
  }
  const bool isFirstConnected = b != d || (a == c && (b == 0 || (a != 0 && a < b)));
  return isFirstConnected ? Sheets::AroundCorner1 : Sheets::AroundCorner2;
}

std::array<int, 4> LabelsOf(const Cube& cube, const CubeFace& face)
{
  return { cube.Labels[face.Corners[0]], cube.Labels[face.Corners[1]], cube.Labels[face.Corners[2]],
    cube.Labels[face.Corners[3]] };
}

void NumberSheets(Cube& cube)
{
  // Not DisjointSets, which would allocate memory for each cube.
  std::array<int, CubeEdges> parent;
  std::iota(parent.begin(), parent.end(), 0);
  const auto find = [&](int edge)
  {
    while (parent[edge] != edge)
    {
      edge = parent[edge];
    }
    return edge;
  };
  const auto isCrossed = [&](int edge)
  {
    const std::array<int, 2> corners = CornersOf(edge);
    return cube.Labels[corners[0]] != cube.Labels[corners[1]];
  };
  for (const CubeFace& face : Faces)
  {
    const Sheets sheets = FindSheets(LabelsOf(cube, face));
    const auto join = [&](int i, int j) { parent[find(face.Edges[i])] = find(face.Edges[j]); };
    if (sheets == Sheets::AroundCorner1)
    {
      join(0, 1);
      join(2, 3);
    }
    else if (sheets == Sheets::AroundCorner2)
    {
      join(1, 2);
      join(3, 0);
    }
    else
    {
      int previous = -1;
      for (int i = 0; i < 4; ++i)
      {
        if (isCrossed(face.Edges[i]))
        {
          if (previous != -1)
          {
            join(previous, i);
          }
          previous = i;
        }
      }
    }
  }
  cube.SheetOf.fill(-1);
  for (int edge = 0; edge < CubeEdges; ++edge)
  {
    const int root = find(edge);
    if (isCrossed(edge))
    {
      if (cube.SheetOf[root] == -1)
      {
        cube.SheetOf[root] = static_cast<std::int8_t>(cube.Count++);
      }
      cube.SheetOf[edge] = cube.SheetOf[root];
    }
  }
}

} // namespace shape::net_cube
