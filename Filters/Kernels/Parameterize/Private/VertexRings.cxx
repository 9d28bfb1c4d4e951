#include "Parameterize/Private/VertexRings.h"

#include <algorithm>

namespace shape
{
namespace
{

void StartWith(std::vector<int>& ring, int first)
{
  std::rotate(ring.begin(), std::find(ring.begin(), ring.end(), first), ring.end());
}

} // namespace

VertexRings::VertexRings(const Eigen::MatrixXi& triangles, int points)
  : Rings(points)
  , Count(points)
{
  // Each triangle at a point gives one step (from, to) of its ring; chain them.
  std::vector<std::vector<std::pair<int, int>>> steps(points);
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      steps[triangles(t, corner)].emplace_back(
        triangles(t, (corner + 1) % 3), triangles(t, (corner + 2) % 3));
    }
  }
  for (int i = 0; i < points; ++i)
  {
    std::sort(steps[i].begin(), steps[i].end());
    int next = steps[i].front().first;
    for (std::size_t k = 0; k < steps[i].size(); ++k)
    {
      this->Rings[i].push_back(next);
      next =
        std::lower_bound(steps[i].begin(), steps[i].end(), std::pair<int, int>(next, -1))->second;
    }
  }
}

std::vector<int> VertexRings::RingFrom(int point, int first) const
{
  std::vector<int> ring = this->Rings[point];
  StartWith(ring, first);
  return ring;
}

bool VertexRings::CanMerge(int point, int into) const
{
  const std::vector<int>& other = this->Rings[into];
  const auto shared = [&](int i)
  { return std::find(other.begin(), other.end(), i) != other.end(); };
  return this->Count > 4 &&
    std::count_if(this->Rings[point].begin(), this->Rings[point].end(), shared) == 2;
}

std::vector<int> VertexRings::Merge(int point, int into)
{
  std::vector<int> ring = this->RingFrom(point, into);
  std::vector<int>& target = this->Rings[into];
  StartWith(target, point);
  std::vector<int> merged(ring.begin() + 2, ring.end() - 1);
  merged.insert(merged.end(), target.begin() + 1, target.end());
  target = std::move(merged);
  for (std::size_t k = 1; k < ring.size(); ++k)
  {
    std::vector<int>& around = this->Rings[ring[k]];
    const auto position = std::find(around.begin(), around.end(), point);
    if (k == 1 || k + 1 == ring.size())
    {
      around.erase(position);
    }
    else
    {
      *position = into;
    }
  }
  this->Rings[point].clear();
  --this->Count;
  return ring;
}

void VertexRings::Restore(int point, const std::vector<int>& ring)
{
  const int into = ring[0];
  const int right = ring[1];
  const int left = ring.back();
  std::vector<int>& target = this->Rings[into];
  StartWith(target, right);
  target.erase(target.begin() + 1, target.begin() + (static_cast<int>(ring.size()) - 2));
  target.insert(target.begin() + 1, point);
  for (std::size_t k = 2; k + 1 < ring.size(); ++k)
  {
    std::vector<int>& around = this->Rings[ring[k]];
    *std::find(around.begin(), around.end(), into) = point;
  }
  std::vector<int>& atRight = this->Rings[right];
  atRight.insert(std::find(atRight.begin(), atRight.end(), into), point);
  std::vector<int>& atLeft = this->Rings[left];
  atLeft.insert(std::find(atLeft.begin(), atLeft.end(), into) + 1, point);
  this->Rings[point] = ring;
  ++this->Count;
}

} // namespace shape
