#include "Hex/Voxels/Private/LabelRepair.h"

#include "Hex/Voxels/Private/CornerPattern.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>

namespace shape
{
namespace
{

/// Changes cells, one after another.
class RegionRepair
{
public:
  RegionRepair(const SampledGrid& grid, const RegionMeetings& meetings, std::vector<int>& regionOf)
    : Grid(grid)
    , Meetings(meetings)
    , RegionOf(regionOf)
    , Changed(regionOf.size(), 0)
    , Strides{ 1, grid.Counts(0), grid.Counts(0) * grid.Counts(1) }
  {
    for (int k = 0; k < 8; ++k)
    {
      this->Around[k] = (k & 1) + (k >> 1 & 1) * this->Strides[1] + (k >> 2) * this->Strides[2];
    }
  }

  /// Changes cells until nothing helps. Returns the number of corners that stay faulty.
  int Run()
  {
    int faulty = 0;
    constexpr int sweeps = 30;
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
      int changes = 0;
      faulty = 0;
      this->ForEachCorner(
        [&](int corner)
        {
          if (this->IsUniform(corner))
          {
            return;
          }
          const int before = this->CornerFaults(corner);
          if (before > 0 || this->HasForeignFace(corner))
          {
            changes += this->ChangeACell(corner) ? 1 : 0;
          }
          faulty += this->CornerFaults(corner) > 0 ? 1 : 0;
        });
      if (changes == 0)
      {
        break;
      }
    }
    return faulty;
  }

private:
  /// Visits the first of the eight cells around each corner inside the grid.
  template <typename Visit>
  void ForEachCorner(const Visit& visit) const
  {
    for (int z = 0; z + 1 < this->Grid.Counts(2); ++z)
    {
      for (int y = 0; y + 1 < this->Grid.Counts(1); ++y)
      {
        for (int x = 0; x + 1 < this->Grid.Counts(0); ++x)
        {
          visit(this->Grid.Index(x, y, z));
        }
      }
    }
  }

  bool IsUniform(int corner) const
  {
    return std::all_of(this->Around.begin(), this->Around.end(),
      [&](int step) { return this->RegionOf[corner + step] == this->RegionOf[corner]; });
  }

  /// The number of regions that are not well-composed at a corner.
  int CornerFaults(int corner) const
  {
    int faults = 0;
    unsigned int done = 0;
    for (int k = 0; k < 8; ++k)
    {
      if (done >> k & 1U)
      {
        continue;
      }
      unsigned int pattern = 0;
      for (int l = k; l < 8; ++l)
      {
        pattern |= static_cast<unsigned int>(this->RegionOf[corner + this->Around[l]] ==
                     this->RegionOf[corner + this->Around[k]])
          << l;
      }
      done |= pattern;
      faults += IsWellComposed(pattern) ? 0 : 1;
    }
    return faults;
  }

  /// Whether two regions that do not meet share a face at a corner.
  bool HasForeignFace(int corner) const
  {
    for (int k = 0; k < 8; ++k)
    {
      for (int axis = 0; axis < 3; ++axis)
      {
        if ((k >> axis & 1) == 0 &&
          this->IsForeign(corner + this->Around[k], corner + this->Around[k | 1 << axis]))
        {
          return true;
        }
      }
    }
    return false;
  }

  bool IsForeign(int one, int other) const
  {
    const int a = this->RegionOf[one], b = this->RegionOf[other];
    return a != b && !this->Meetings.Touch(a, b);
  }

  /// Whether the regions around an edge, from the first of its four cells, do not meet at an edge.
  bool IsForeignEdge(int cell, int along) const
  {
    const int u = this->Strides[(along + 1) % 3], v = this->Strides[(along + 2) % 3];
    std::array<int, 4> regions = { this->RegionOf[cell], this->RegionOf[cell + u],
      this->RegionOf[cell + v], this->RegionOf[cell + u + v] };
    std::sort(regions.begin(), regions.end());
    const auto end = std::unique(regions.begin(), regions.end());
    return end - regions.begin() > 2 &&
      this->Meetings.Around.count(std::vector<int>(regions.begin(), end)) == 0;
  }

  /// The faults at the corners, faces and edges of a cell, with their weights.
  long long FaultsAround(int cell) const
  {
    // A region that is no manifold outweighs regions that should not touch at a face, and these
    // outweigh edges.
    constexpr long long atCorner = 10000, atFace = 20;
    long long faults = 0;
    for (const int step : this->Around)
    {
      faults += atCorner * this->CornerFaults(cell - step);
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      const int stride = this->Strides[axis];
      faults += atFace *
        (int(this->IsForeign(cell, cell - stride)) + int(this->IsForeign(cell, cell + stride)));
      const int u = this->Strides[(axis + 1) % 3], v = this->Strides[(axis + 2) % 3];
      for (const int first : { cell, cell - u, cell - v, cell - u - v })
      {
        faults += this->IsForeignEdge(first, axis) ? 1 : 0;
      }
    }
    return faults;
  }

  bool IsOutermost(int cell) const
  {
    const int x = cell % this->Strides[1], y = cell / this->Strides[1] % this->Grid.Counts(1),
              z = cell / this->Strides[2];
    return x == 0 || y == 0 || z == 0 || x + 1 == this->Grid.Counts(0) ||
      y + 1 == this->Grid.Counts(1) || z + 1 == this->Grid.Counts(2);
  }

  /// The regions that a cell at a corner may get: those at the corner, and those that meet two that
  /// should not touch.
  std::vector<int> CandidatesAt(int corner) const
  {
    std::vector<int> regions;
    for (const int step : this->Around)
    {
      regions.push_back(this->RegionOf[corner + step]);
    }
    std::sort(regions.begin(), regions.end());
    regions.erase(std::unique(regions.begin(), regions.end()), regions.end());
    const std::vector<int> own = regions;
    for (int between = 0; between < this->Meetings.Count; ++between)
    {
      for (std::size_t i = 0; i < own.size(); ++i)
      {
        for (std::size_t j = i + 1; j < own.size(); ++j)
        {
          if (!this->Meetings.Touch(own[i], own[j]) && this->Meetings.Touch(own[i], between) &&
            this->Meetings.Touch(own[j], between))
          {
            regions.push_back(between);
          }
        }
      }
    }
    std::sort(regions.begin() + static_cast<std::ptrdiff_t>(own.size()), regions.end());
    regions.erase(
      std::unique(regions.begin() + static_cast<std::ptrdiff_t>(own.size()), regions.end()),
      regions.end());
    return regions;
  }

  /// Makes the best change of a cell at a corner. Returns whether there is one.
  bool ChangeACell(int corner)
  {
    long long best = 1; // the change of the number of faults
    double nearest = std::numeric_limits<double>::infinity();
    int cell = -1, region = -1;
    const std::vector<int> candidates = this->CandidatesAt(corner);
    for (const int step : this->Around)
    {
      const int tried = corner + step;
      if (this->IsOutermost(tried))
      {
        continue;
      }
      const int own = this->RegionOf[tried];
      const long long before = this->FaultsAround(tried);
      for (const int other : candidates)
      {
        if (other == own)
        {
          continue;
        }
        this->RegionOf[tried] = other;
        const long long gain = this->FaultsAround(tried) - before;
        const double distance = this->Grid.Values(tried);
        // A cell may change once without a gain: this leaves dead ends.
        if ((gain < 0 || (gain == 0 && !this->Changed[tried])) &&
          (gain < best || (gain == best && distance < nearest)))
        {
          best = gain;
          nearest = distance;
          cell = tried;
          region = other;
        }
        this->RegionOf[tried] = own;
      }
    }
    if (cell < 0)
    {
      return false;
    }
    this->RegionOf[cell] = region;
    this->Changed[cell] = 1;
    return true;
  }

  const SampledGrid& Grid;
  const RegionMeetings& Meetings;
  std::vector<int>& RegionOf;
  std::vector<char> Changed;
  const std::array<int, 3> Strides;
  std::array<int, 8> Around{}; ///< from the first of eight cells around a corner to each of them
};

} // namespace

int RepairRegions(
  const SampledGrid& grid, const RegionMeetings& meetings, std::vector<int>& regionOf)
{
  return RegionRepair(grid, meetings, regionOf).Run();
}

int DissolveParts(
  const SampledGrid& grid, const std::vector<int>& wanted, std::vector<int>& regionOf)
{
  const int strides[] = { 1, grid.Counts(0), grid.Counts(0) * grid.Counts(1) };
  const auto count = static_cast<int>(regionOf.size());
  // Calls with the cells beside a cell, also those on the other side of the grid's border, which
  // are all outside.
  const auto forEachBeside = [&](int cell, const auto& call)
  {
    for (const int stride : strides)
    {
      for (const int next : { cell - stride, cell + stride })
      {
        if (next >= 0 && next < count)
        {
          call(next);
        }
      }
    }
  };
  std::vector<char> seen(regionOf.size(), 0);
  std::vector<std::vector<std::vector<int>>> parts(wanted.size());
  for (int first = 0; first < count; ++first)
  {
    if (seen[first])
    {
      continue;
    }
    std::vector<int> cells = { first };
    seen[first] = 1;
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      forEachBeside(cells[i],
        [&](int next)
        {
          if (!seen[next] && regionOf[next] == regionOf[first])
          {
            seen[next] = 1;
            cells.push_back(next);
          }
        });
    }
    parts[regionOf[first]].push_back(std::move(cells));
  }
  int dissolved = 0;
  for (std::size_t region = 0; region < parts.size(); ++region)
  {
    auto& own = parts[region];
    std::stable_sort(own.begin(), own.end(),
      [](const auto& one, const auto& other) { return one.size() > other.size(); });
    for (std::size_t i = std::max(wanted[region], 0); i < own.size(); ++i)
    {
      std::map<int, int> faces;
      for (const int cell : own[i])
      {
        forEachBeside(cell,
          [&](int next) { faces[regionOf[next]] += regionOf[next] != static_cast<int>(region); });
      }
      faces.erase(static_cast<int>(region));
      const auto most = std::max_element(faces.begin(), faces.end(),
        [](const auto& one, const auto& other) { return one.second < other.second; });
      if (most != faces.end())
      {
        for (const int cell : own[i])
        {
          regionOf[cell] = most->first;
        }
        ++dissolved;
      }
    }
  }
  return dissolved;
}

} // namespace shape
