#include "Materials/BoundaryVoxels.h"

#include "Base/Errors.h"
#include "Materials/Private/CellSampling.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <optional>

namespace shape
{
namespace
{

/// The share of a voxel whose box a plane touches from outside: the integral of its hat function.
constexpr double TouchedShare = 0.875;
/// Shares are sums of multiples of this. Sums of integers do not depend on the order.
constexpr double Unit = 1.0 / (1LL << 40);

using Grid = std::array<int, 3>;

/// Calls visit(sample, position along each axis) for all samples of an image.
template <typename Visit>
void ForEachVoxel(const VoxelImage& image, Visit&& visit)
{
  std::size_t sample = 0;
  for (int k = 0; k < image.Size[2]; ++k)
  {
    for (int j = 0; j < image.Size[1]; ++j)
    {
      for (int i = 0; i < image.Size[0]; ++i)
      {
        visit(sample++, Grid{ i, j, k });
      }
    }
  }
}

/// Returns the sample at a position plus `steps` times a direction; none beyond the image.
std::optional<std::size_t> FindNeighbour(
  const VoxelImage& image, const Grid& position, const Grid& direction, int steps)
{
  Grid moved;
  for (int axis = 0; axis < 3; ++axis)
  {
    moved[axis] = position[axis] + steps * direction[axis];
    if (moved[axis] < 0 || moved[axis] >= image.Size[axis])
    {
      return {};
    }
  }
  return image.IndexOf(moved[0], moved[1], moved[2]);
}

/// The directions to the neighbours, those along the axes first.
const std::vector<Grid>& GetDirections()
{
  static const std::vector<Grid> directions = []
  {
    std::vector<Grid> all;
    for (int length = 1; length <= 3; ++length)
    {
      for (int code = 0; code < 27; ++code)
      {
        const Grid direction = { code % 3 - 1, code / 3 % 3 - 1, code / 9 - 1 };
        if (std::abs(direction[0]) + std::abs(direction[1]) + std::abs(direction[2]) == length)
        {
          all.push_back(direction);
        }
      }
    }
    return all;
  }();
  return directions;
}

constexpr int AxisDirections = 6;

/// Marks the voxels whose values are free of what is outside.
std::vector<char> FindInnerVoxels(
  const VoxelImage& image, const std::vector<double>& shares, int layers)
{
  std::vector<char> inner(shares.size());
  std::transform(shares.begin(), shares.end(), inner.begin(),
    [](double share) { return static_cast<char>(share >= TouchedShare); });
  for (int layer = 1; layer < layers; ++layer)
  {
    const std::vector<char> before = inner;
    ForEachVoxel(image,
      [&](std::size_t sample, const Grid& position)
      {
        for (int d = 0; d < AxisDirections && inner[sample] != 0; ++d)
        {
          const auto neighbour = FindNeighbour(image, position, GetDirections()[d], 1);
          inner[sample] = static_cast<char>(!neighbour || before[*neighbour] != 0);
        }
      });
  }
  return inner;
}

/// Returns the value that the known neighbours suggest; none without such neighbours.
std::optional<double> Extrapolate(const VoxelImage& image, const Grid& position,
  const std::vector<char>& known, const std::vector<double>& values)
{
  double linear = 0.0, constant = 0.0;
  int linears = 0, constants = 0;
  for (const Grid& direction : GetDirections())
  {
    const auto first = FindNeighbour(image, position, direction, 1);
    if (!first || known[*first] == 0)
    {
      continue;
    }
    constant += values[*first];
    ++constants;
    const auto second = FindNeighbour(image, position, direction, 2);
    if (second && known[*second] != 0)
    {
      linear += 2.0 * values[*first] - values[*second];
      ++linears;
    }
  }
  return linears > 0 ? std::optional<double>(linear / linears)
    : constants > 0  ? std::optional<double>(constant / constants)
                     : std::nullopt;
}

} // namespace

void AddVoxelShares(const Cells& cells, const Eigen::VectorXi& own, const VoxelImage& image,
  std::vector<double>& shares, const Progress& progress)
{
  const CellSampling sampling(cells, image, 1.0, 1.0);
  std::vector<std::atomic<std::int64_t>> sums(image.Count());
  sampling.Run(
    [&](int task)
    {
      if (own.size() > 0 && own(sampling.GetCell(task)) == 0)
      {
        return;
      }
      sampling.ForEachSample(task,
        [&](const Eigen::RowVector3d& index, double volume, bool isInside)
        {
          if (!isInside)
          {
            return;
          }
          const Grid base = { static_cast<int>(std::floor(index(0))),
            static_cast<int>(std::floor(index(1))), static_cast<int>(std::floor(index(2))) };
          for (int corner = 0; corner < 8; ++corner)
          {
            const Grid offset = { corner & 1, corner >> 1 & 1, corner >> 2 };
            if (const auto sample = FindNeighbour(image, base, offset, 1))
            {
              double weight = volume;
              for (int axis = 0; axis < 3; ++axis)
              {
                weight *= 1.0 - std::abs(index(axis) - base[axis] - offset[axis]);
              }
              sums[*sample].fetch_add(std::llround(weight / Unit), std::memory_order_relaxed);
            }
          }
        });
    },
    progress);
  shares.resize(image.Count(), 0.0);
  for (std::size_t i = 0; i < shares.size(); ++i)
  {
    shares[i] += static_cast<double>(sums[i].load()) * Unit;
  }
}

BoundaryVoxels ExtrapolateToBoundary(const VoxelImage& image, const std::vector<double>& shares,
  int layers, std::vector<double>& values, const Progress& progress)
{
  RequireOption(layers >= 0, "BoundaryLayers", layers, "0 or more");
  BoundaryVoxels result;
  if (layers == 0)
  {
    return result;
  }
  std::vector<char> known = FindInnerVoxels(image, shares, layers);
  std::vector<std::pair<std::size_t, Grid>> open;
  ForEachVoxel(image,
    [&](std::size_t sample, const Grid& position)
    {
      if (shares[sample] > 0.0 && known[sample] == 0)
      {
        open.emplace_back(sample, position);
      }
    });
  result.Boundary = static_cast<int>(open.size());
  bool isGrowing = true;
  while (isGrowing && !open.empty())
  {
    progress(1.0 - static_cast<double>(open.size()) / result.Boundary);
    std::vector<std::pair<std::size_t, double>> found;
    std::vector<std::pair<std::size_t, Grid>> left;
    for (const auto& [sample, position] : open)
    {
      if (const auto value = Extrapolate(image, position, known, values))
      {
        found.emplace_back(sample, *value);
      }
      else
      {
        left.emplace_back(sample, position);
      }
    }
    for (const auto& [sample, value] : found)
    {
      known[sample] = 1;
      result.Raised += value > values[sample];
      values[sample] = std::max(value, values[sample]);
    }
    isGrowing = !found.empty();
    open = std::move(left);
  }
  result.Unresolved = static_cast<int>(open.size());
  return result;
}

} // namespace shape
