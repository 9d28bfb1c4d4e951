#include "Mesh/DiskGrowth.h"

#include "Mesh/HalfEdges.h"

#include <functional>
#include <queue>

namespace shape
{

std::vector<int> GrowDisk(const Eigen::MatrixXi& triangles, Eigen::Index points)
{
  const std::vector<int> twins = FindTwins(triangles, points);
  const auto count = static_cast<int>(triangles.rows());
  std::vector<bool> isIn(count, false), isMet(points, false);
  const auto joins = [&](int triangle)
  {
    int shared = 0, sharedSide = -1;
    for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
    {
      if (twins[side] >= 0 && isIn[twins[side] / 3])
      {
        ++shared;
        sharedSide = side;
      }
    }
    // With one shared edge, the opposite corner must be new, or the disk would touch itself there.
    // With two, the corner between them becomes an inner point. With three, a sphere would result.
    return shared == 2 ||
      (shared == 1 && !isMet[triangles(triangle, PreviousHalfEdge(sharedSide) % 3)]);
  };
  // Triangles next to the disk; one that cannot join is queued again by its next neighbour.
  std::priority_queue<int, std::vector<int>, std::greater<>> front;
  const auto add = [&](int triangle)
  {
    isIn[triangle] = true;
    for (int corner = 0; corner < 3; ++corner)
    {
      isMet[triangles(triangle, corner)] = true;
      const int twin = twins[3 * triangle + corner];
      if (twin >= 0 && !isIn[twin / 3])
      {
        front.push(twin / 3);
      }
    }
  };
  if (count > 0)
  {
    add(0);
  }
  while (!front.empty())
  {
    const int triangle = front.top();
    front.pop();
    if (!isIn[triangle] && joins(triangle))
    {
      add(triangle);
    }
  }
  std::vector<int> rows;
  for (int triangle = 0; triangle < count; ++triangle)
  {
    if (isIn[triangle])
    {
      rows.push_back(triangle);
    }
  }
  return rows;
}

} // namespace shape
