#include "Solidify/Private/GridFlood.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace shape
{
namespace
{

/// Replaces each value f(q) of a line by the minimum over p of f(p) + (p - q)^2, the lower envelope
/// of parabolas.
class Envelope
{
public:
  explicit Envelope(int count)
    : Values(count)
    , Roots(count)
    , Starts(count + 1)
  {
  }

  void Transform(float* line, std::size_t step, int count)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    int last = -1;
    for (int q = 0; q < count; ++q)
    {
      this->Values[q] = line[q * step];
      if (std::isinf(this->Values[q]))
      {
        continue;
      }
      double start = -infinity;
      while (last >= 0)
      {
        const int p = this->Roots[last];
        start =
          (this->Values[q] + double(q) * q - this->Values[p] - double(p) * p) / (2.0 * (q - p));
        if (start > this->Starts[last])
        {
          break;
        }
        --last;
        start = -infinity;
      }
      this->Roots[++last] = q;
      this->Starts[last] = start;
    }
    for (int q = 0, k = 0; q < count && last >= 0; ++q)
    {
      while (k < last && this->Starts[k + 1] < q)
      {
        ++k;
      }
      const double away = q - this->Roots[k];
      line[q * step] = static_cast<float>(away * away + this->Values[this->Roots[k]]);
    }
  }

private:
  std::vector<double> Values;
  std::vector<int> Roots;     ///< of the parabolas in the envelope
  std::vector<double> Starts; ///< where each parabola's part begins
};

} // namespace

std::vector<char> FloodGrid(const SampledGrid& grid, const std::vector<int>& starts,
  const std::function<bool(int from, int to)>& passes, const Progress& progress)
{
  const std::array<int, 3> steps = { 1, grid.Counts(0), grid.Counts(0) * grid.Counts(1) };
  std::vector<char> isReached(grid.Counts.prod(), 0);
  std::vector<int> pending = starts;
  for (const int start : starts)
  {
    isReached[start] = 1;
  }
  for (std::size_t seen = 0; !pending.empty(); ++seen)
  {
    constexpr std::size_t rare = 4096;
    if (seen % rare == 0)
    {
      progress(static_cast<double>(seen) / static_cast<double>(isReached.size()));
    }
    const int from = pending.back();
    pending.pop_back();
    for (int axis = 0; axis < 3; ++axis)
    {
      const int at = from / steps[axis] % grid.Counts(axis);
      for (const bool up : { false, true })
      {
        if (at == (up ? grid.Counts(axis) - 1 : 0))
        {
          continue;
        }
        const int to = up ? from + steps[axis] : from - steps[axis];
        if (isReached[to] == 0 && passes(from, to))
        {
          isReached[to] = 1;
          pending.push_back(to);
        }
      }
    }
  }
  return isReached;
}

std::vector<float> ComputeGridDistances(
  const SampledGrid& grid, const std::vector<char>& isInSet, const Progress& progress)
{
  std::vector<float> squares(isInSet.size());
  std::transform(isInSet.begin(), isInSet.end(), squares.begin(),
    [](char is) { return is != 0 ? 0.0F : std::numeric_limits<float>::infinity(); });
  Envelope envelope(grid.Counts.maxCoeff());
  const std::array<int, 3> steps = { 1, grid.Counts(0), grid.Counts(0) * grid.Counts(1) };
  for (int axis = 0; axis < 3; ++axis)
  {
    const int second = (axis + 1) % 3, third = (axis + 2) % 3;
    for (int k = 0; k < grid.Counts(third); ++k)
    {
      progress((axis + static_cast<double>(k) / grid.Counts(third)) / 3.0);
      for (int j = 0; j < grid.Counts(second); ++j)
      {
        const std::size_t first =
          static_cast<std::size_t>(j) * steps[second] + static_cast<std::size_t>(k) * steps[third];
        envelope.Transform(squares.data() + first, steps[axis], grid.Counts(axis));
      }
    }
  }
  for (float& square : squares)
  {
    square = static_cast<float>(grid.Spacing) * std::sqrt(square);
  }
  return squares;
}

} // namespace shape
