#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace shape
{

/// A value for each point in a row.
struct ChoicePath
{
  double Cost = std::numeric_limits<double>::infinity();
  std::vector<double> Values;
};

/// Returns the values with the smallest sum of costs, one of the choices of each point; its Cost is
/// infinite if there are none. cost: of an edge, which has the number of its first point, by the
/// values of its ends.
template <typename EdgeCost>
ChoicePath FindShortestPath(const std::vector<std::vector<double>>& choices, const EdgeCost& cost)
{
  // The cheapest path to each choice of a point extends one to a choice of the point before.
  std::vector<ChoicePath> paths;
  for (const double value : choices.front())
  {
    paths.push_back({ 0.0, { value } });
  }
  for (std::size_t i = 1; i < choices.size(); ++i)
  {
    std::vector<ChoicePath> longer;
    for (const double value : choices[i])
    {
      ChoicePath cheapest;
      const ChoicePath* before = nullptr;
      for (const ChoicePath& path : paths)
      {
        const double sum = path.Cost + cost(i - 1, path.Values.back(), value);
        if (sum < cheapest.Cost)
        {
          cheapest.Cost = sum;
          before = &path;
        }
      }
      cheapest.Values = before ? before->Values : paths.front().Values;
      cheapest.Values.push_back(value);
      longer.push_back(std::move(cheapest));
    }
    paths = std::move(longer);
  }
  return *std::min_element(paths.begin(), paths.end(),
    [](const ChoicePath& a, const ChoicePath& b) { return a.Cost < b.Cost; });
}

} // namespace shape
