#include "Correspondence/CommonBase/Private/BaseGraph.h"

#include <algorithm>

namespace shape
{

std::vector<int> BaseGraph::Corners() const
{
  std::vector<int> corners;
  for (std::size_t node = 0; node < this->Around.size(); ++node)
  {
    if (this->Around[node].empty())
    {
      corners.push_back(-1 - static_cast<int>(node));
    }
  }
  for (int halfPath = 0; halfPath < 2 * this->PathCount(); ++halfPath)
  {
    corners.push_back(halfPath);
  }
  return corners;
}

// The region to the left of a half-path lies, at its other end, clockwise from its opposite. The
// boundary continues along the half-path there.
int BaseGraph::NextAround(int halfPath) const
{
  const int opposite = halfPath ^ 1;
  const std::vector<int>& around = this->Around[this->NodeOf(opposite)];
  const auto position = std::find(around.begin(), around.end(), opposite);
  return position == around.begin() ? around.back() : *(position - 1);
}

std::vector<int> BaseGraph::BoundaryCycles() const
{
  std::vector<int> cycles(2 * this->Paths.size(), -1);
  int count = 0;
  for (int first = 0; first < static_cast<int>(cycles.size()); ++first)
  {
    if (cycles[first] >= 0)
    {
      continue;
    }
    for (int halfPath = first; cycles[halfPath] < 0; halfPath = this->NextAround(halfPath))
    {
      cycles[halfPath] = count;
    }
    ++count;
  }
  return cycles;
}

void BaseGraph::Insert(int corner, int halfPath)
{
  std::vector<int>& around = this->Around[this->NodeOfCorner(corner)];
  const auto position = std::find(around.begin(), around.end(), corner);
  around.insert(position == around.end() ? position : position + 1, halfPath);
}

int BaseGraph::ComponentCount()
{
  int count = 0;
  for (int node = 0; node < static_cast<int>(this->Around.size()); ++node)
  {
    count += this->Sets.Find(node) == node ? 1 : 0;
  }
  return count;
}

int BaseGraph::Add(int from, int to)
{
  const int path = this->PathCount();
  this->Paths.push_back({ this->NodeOfCorner(from), this->NodeOfCorner(to) });
  this->Insert(from, 2 * path);
  this->Insert(to, 2 * path + 1);
  this->Sets.Merge(this->Paths[path][0], this->Paths[path][1]);
  return path;
}

} // namespace shape
