#include "Fill/RimCorners.h"

#include "Mesh/SamePlaces.h"

#include <algorithm>

namespace shape
{

RimCorners CornersOfRim(const std::vector<int>& rim, const Eigen::MatrixXd& points)
{
  const std::size_t count = rim.size();
  const auto isSame = [&](int a, int b) { return points.row(a) == points.row(b); };
  const auto point = [&](std::size_t i) { return rim[i % count]; };
  std::size_t first = 0;
  while (first + 1 < count && isSame(point(first), point(first + count - 1)))
  {
    ++first;
  }
  RimCorners corners;
  std::vector<Eigen::RowVector3i> slivers;
  const bool isOnePlace =
    std::all_of(rim.begin(), rim.end(), [&](int point) { return isSame(point, rim.front()); });
  if (isOnePlace)
  {
    corners.Points = { rim.front() };
    for (std::size_t i = 1; i + 1 < count; ++i)
    {
      slivers.emplace_back(point(0), point(i), point(i + 1));
    }
  }
  for (std::size_t i = first; !isOnePlace && i < first + count; ++i)
  {
    if (i == first || !isSame(point(i), point(i - 1)))
    {
      corners.Points.push_back(point(i));
      continue;
    }
    // The fill's side to the next place begins at the first of the doubled points.
    std::size_t next = i + 1;
    while (isSame(point(next), point(i)) && next < i + count)
    {
      ++next;
    }
    slivers.emplace_back(point(i - 1), point(i), point(next));
  }
  corners.Slivers.resize(static_cast<Eigen::Index>(slivers.size()), 3);
  for (std::size_t i = 0; i < slivers.size(); ++i)
  {
    corners.Slivers.row(static_cast<Eigen::Index>(i)) = slivers[i];
  }
  return corners;
}

TakenEdges::TakenEdges(const Mesh& surface, const std::vector<std::vector<int>>& rims)
  : Place(FirstAtPlace(surface.Points))
  , RimsOf(surface.Points.rows())
  , Joined(surface.Points.rows())
{
  for (int rim = 0; rim < static_cast<int>(rims.size()); ++rim)
  {
    for (const int point : rims[rim])
    {
      std::vector<int>& there = this->RimsOf[this->Place[point]];
      if (there.empty() || there.back() != rim)
      {
        there.push_back(rim);
      }
    }
  }
  for (const auto& triangle : surface.Triangles.rowwise())
  {
    for (int k = 0; k < 3; ++k)
    {
      const int a = this->Place[triangle(k)], b = this->Place[triangle((k + 1) % 3)];
      if (!this->RimsOf[a].empty() && !this->RimsOf[b].empty())
      {
        this->Joined[a].push_back(b);
        this->Joined[b].push_back(a);
      }
    }
  }
  for (std::vector<int>& others : this->Joined)
  {
    std::sort(others.begin(), others.end());
  }
}

std::function<bool(int, int)> TakenEdges::Of(int rim, const std::vector<int>& corners) const
{
  const auto isOnBoth = [this, rim](int a, int b)
  {
    return std::any_of(this->RimsOf[a].begin(), this->RimsOf[a].end(),
      [&](int other)
      {
        return other != rim &&
          std::binary_search(this->RimsOf[b].begin(), this->RimsOf[b].end(), other);
      });
  };
  std::vector<int> places;
  for (const int corner : corners)
  {
    places.push_back(this->Place[corner]);
  }
  return [this, isOnBoth, places](int i, int j)
  {
    const std::vector<int>& others = this->Joined[places[i]];
    return std::binary_search(others.begin(), others.end(), places[j]) ||
      isOnBoth(places[i], places[j]);
  };
}

} // namespace shape
