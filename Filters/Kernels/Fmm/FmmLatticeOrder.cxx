#include "Fmm/FmmLatticeOrder.h"

#include "Base/Parallel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace shape
{

namespace
{

/// Spreads up to 21 bits, with two zero bits after each.
std::uint64_t Spread(std::uint64_t bits)
{
  bits = (bits | bits << 32) & 0x1f00000000ffffULL;
  bits = (bits | bits << 16) & 0x1f0000ff0000ffULL;
  bits = (bits | bits << 8) & 0x100f00f00f00f00fULL;
  bits = (bits | bits << 4) & 0x10c30c30c30c30c3ULL;
  return (bits | bits << 2) & 0x1249249249249249ULL;
}

struct Keyed
{
  std::uint64_t Key = 0;
  int Id = 0;
};

/// Sorts by key; equal keys keep the order of their indices. A radix sort: four passes over the 48
/// bits of a key, each stable.
void SortByKey(std::vector<Keyed>& items)
{
  constexpr int bits = 12;
  std::vector<Keyed> sorted(items.size());
  for (int shift = 0; shift < 3 * FmmLatticeOrder::Halvings; shift += bits)
  {
    std::array<int, (1 << bits) + 1> start{};
    for (const Keyed& item : items)
    {
      ++start[(item.Key >> shift & ((1 << bits) - 1)) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    for (const Keyed& item : items)
    {
      sorted[start[item.Key >> shift & ((1 << bits) - 1)]++] = item;
    }
    items.swap(sorted);
  }
}

} // namespace

FmmLatticeOrder OrderOnLattice(const Eigen::MatrixXd& positions, const Lattice& lattice)
{
  const auto count = static_cast<int>(positions.rows());
  std::vector<Keyed> items(count);
  std::vector<signed char> roots(count);
  ParallelFor(count, 4096,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        items[i].Id = i;
        int root = 0;
        for (int c = 0; c < 3; ++c)
        {
          // Coordinate in units of the cube: its integer part is the cube, its fraction gives the
          // key.
          const double at = (positions(i, c) - lattice.Origin[c]) / lattice.Side;
          const double cell = std::abs(at - 0.5) < 0.5 + 1e-9 ? 0.0 : std::floor(at);
          // The number of the last cell that a key can store.
          constexpr double maximum = (1 << FmmLatticeOrder::Halvings) - 1;
          // Only the root and the cubes that touch it have a number.
          root = std::abs(cell) <= 1.0 && root >= 0 ? 3 * root + 1 + static_cast<int>(cell) : -1;
          const double inside =
            std::clamp(std::ldexp(at - cell, FmmLatticeOrder::Halvings), 0.0, maximum);
          // The bits of x, y and z alternate: three bits for each subdivision.
          items[i].Key |= Spread(static_cast<std::uint64_t>(inside)) << c;
        }
        roots[i] = static_cast<signed char>(root);
      }
    });
  SortByKey(items);

  // A counting sort by cube keeps the order of the keys in each cube. Positions in none of the
  // cubes come first.
  FmmLatticeOrder order;
  std::vector<int> start(FmmLatticeOrder::Roots + 2, 0);
  for (const Keyed& item : items)
  {
    ++start[roots[item.Id] + 2];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  order.RootStart.assign(start.begin() + 1, start.end());
  order.Keys.resize(count);
  order.Ids.resize(count);
  for (const Keyed& item : items)
  {
    const int to = start[roots[item.Id] + 1]++;
    order.Ids[to] = item.Id;
    order.Keys[to] = item.Key;
  }
  return order;
}

} // namespace shape
