#include "Mesh/VertexFans.h"

#include <algorithm>

namespace shape
{

VertexFans::VertexFans(const Eigen::MatrixXi& triangles, int nodes)
  : First(1, 0)
{
  std::vector<std::vector<FanTriangle>> fans(nodes);
  for (int t = 0; t < triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      std::vector<FanTriangle>& fan = fans[triangles(t, k)];
      if (fan.empty() || fan.back().Triangle != t)
      {
        fan.push_back({ triangles(t, (k + 1) % 3), triangles(t, (k + 2) % 3), t, k });
      }
    }
  }
  std::vector<int> next;
  for (int i = 0; i < nodes; ++i)
  {
    next.clear();
    for (const FanTriangle& triangle : fans[i])
    {
      next.push_back(triangle.Next);
    }
    std::sort(next.begin(), next.end());
    // On the boundary and at inconsistent triangles, a neighbour is only a Previous.
    for (std::size_t k = 0, count = fans[i].size(); k < count; ++k)
    {
      const int previous = fans[i][k].Previous;
      if (!std::binary_search(next.begin(), next.end(), previous))
      {
        fans[i].push_back({ previous, i, -1, 0 });
      }
    }
    this->Triangles.insert(this->Triangles.end(), fans[i].begin(), fans[i].end());
    this->First.push_back(static_cast<int>(this->Triangles.size()));
    this->Largest = std::max(this->Largest, static_cast<int>(fans[i].size()));
  }
}

} // namespace shape
