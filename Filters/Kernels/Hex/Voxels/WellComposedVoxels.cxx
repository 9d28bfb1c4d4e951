#include "Hex/Voxels/WellComposedVoxels.h"

#include "Hex/Voxels/Private/CornerPattern.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>

namespace shape
{
namespace
{

/// Returns the eight cells around the corner of cell (x, y, z) that is closest to the origin.
std::array<int, 8> CellsAround(const SampledGrid& grid, int x, int y, int z)
{
  std::array<int, 8> cells{};
  for (int k = 0; k < 8; ++k)
  {
    cells[k] = grid.Index(x - 1 + (k & 1), y - 1 + (k >> 1 & 1), z - 1 + (k >> 2));
  }
  return cells;
}

/// The eight cells around a corner as bits: bit k is 1 if cell k is inside.
unsigned int PatternOf(const std::array<int, 8>& cells, const std::vector<char>& inside)
{
  unsigned int pattern = 0;
  for (int k = 0; k < 8; ++k)
  {
    pattern |= static_cast<unsigned int>(inside[cells[k]]) << k;
  }
  return pattern;
}

/// Returns which of eight cells around a pinched corner should change sides, preferably one that
/// repairs the corner; -1 if all have changed before. Each cell changes once, so this terminates.
int CellToChange(unsigned int pattern, const std::array<int, 8>& cells,
  const Eigen::VectorXd& levels, const std::vector<char>& changed)
{
  int best = -1;
  for (const bool mending : { true, false })
  {
    double minimum = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 8; ++k)
    {
      if (!changed[cells[k]] && (!mending || IsWellComposed(pattern ^ (1U << k))) &&
        std::abs(levels(cells[k])) < minimum)
      {
        minimum = std::abs(levels(cells[k]));
        best = cells[k];
      }
    }
    if (best >= 0)
    {
      break;
    }
  }
  return best;
}

/// Changes single cells of a solid, whose boundary is a manifold, without changing its topology.
class CellFlipper
{
public:
  CellFlipper(const SampledGrid& grid, std::vector<char>& inside)
    : Grid(grid)
    , Inside(inside)
    , Changed(inside.size(), 0)
  {
  }

  int Count() const { return this->Flips; }

  /// Changes a cell if the topology allows it.
  bool Flip(const Eigen::RowVector3i& cell)
  {
    const int index = this->Grid.Index(cell(0), cell(1), cell(2));
    if (this->Changed[index] || !this->SharesADisk(cell))
    {
      return false;
    }
    this->Inside[index] ^= 1;
    for (int corner = 0; corner < 8; ++corner)
    {
      const std::array<int, 8> cells = CellsAround(
        this->Grid, cell(0) + (corner & 1), cell(1) + (corner >> 1 & 1), cell(2) + (corner >> 2));
      // The disk preserves the topology; the eight corners of the cell must also stay
      // well-composed.
      if (!IsWellComposed(PatternOf(cells, this->Inside)))
      {
        this->Inside[index] ^= 1;
        return false;
      }
    }
    this->Changed[index] = 1;
    ++this->Flips;
    return true;
  }

private:
  /// Whether the faces that a cell shares with the solid form a disk.
  bool SharesADisk(const Eigen::RowVector3i& cell) const
  {
    std::array<int, 3> shared{}; // of the two faces across each axis
    for (int axis = 0; axis < 3; ++axis)
    {
      if (cell(axis) < 1 || cell(axis) + 2 > this->Grid.Counts(axis) - 1)
      {
        return false; // the outermost cells stay outside
      }
      for (const int step : { -1, 1 })
      {
        Eigen::RowVector3i next = cell;
        next(axis) += step;
        shared[axis] += this->Inside[this->Grid.Index(next(0), next(1), next(2))];
      }
    }
    // Not a disk: no face, all six, two opposite faces (two disks), or four around an axis (a
    // ring).
    const int faces = shared[0] + shared[1] + shared[2];
    const bool pair = std::find(shared.begin(), shared.end(), 2) != shared.end();
    const bool gap = std::find(shared.begin(), shared.end(), 0) != shared.end();
    return faces > 0 && faces < 6 && !(faces == 2 && pair) && !(faces == 4 && gap);
  }

  const SampledGrid& Grid;
  std::vector<char>& Inside;
  std::vector<char> Changed;
  int Flips = 0;
};

/// The cells around one cell, by their steps from it, that are on the other side.
class OtherSide
{
public:
  OtherSide(
    const SampledGrid& grid, const std::vector<char>& inside, const Eigen::RowVector3i& cell)
  {
    const int centre = grid.Index(cell(0), cell(1), cell(2));
    const int strideY = grid.Counts(0), strideZ = grid.Counts(0) * grid.Counts(1);
    for (int z = -1; z <= 1; ++z)
    {
      for (int y = -1; y <= 1; ++y)
      {
        for (int x = -1; x <= 1; ++x)
        {
          if (inside[centre + x + strideY * y + strideZ * z] != inside[centre])
          {
            this->Steps[this->Count++] = { x, y, z };
          }
        }
      }
    }
  }

  /// Returns the distance of the nearest of these cells from a position in the cell's coordinates,
  /// in [0, 1]; 2 if there are none.
  double DistanceTo(const Eigen::Array3d& position) const
  {
    return this->DistanceTo(position, position);
  }

  /// Returns an upper bound on this distance for all positions of a box, which is exact if the box
  /// is one position.
  double DistanceTo(const Eigen::Array3d& low, const Eigen::Array3d& high) const
  {
    double minimum = 4.0;
    for (int i = 0; i < this->Count; ++i)
    {
      double square = 0.0;
      for (int axis = 0; axis < 3; ++axis)
      {
        const int step = this->Steps[i][axis];
        const double gap = step > 0 ? 1.0 - low(axis) : step < 0 ? high(axis) : 0.0;
        square += gap * gap;
      }
      minimum = std::min(minimum, square);
    }
    return std::sqrt(minimum);
  }

private:
  std::array<std::array<int, 3>, 26> Steps;
  int Count = 0;
};

/// The positions in one cell, in its coordinates, and the box around them.
struct PositionsInCell
{
  Eigen::RowVector3i Cell;
  int Begin, End; ///< indices into CellPositions::Within
  Eigen::Array3d Low, High;
};

/// Positions sorted by their cells. Cells without positions are not listed.
struct CellPositions
{
  CellPositions(const SampledGrid& grid, const Eigen::MatrixXd& positions)
    : Within(positions.rows())
  {
    const Eigen::MatrixXd scaled =
      ((positions.rowwise() - grid.Origin) / grid.Spacing).array() + 0.5;
    const Eigen::MatrixXi cells = scaled.array().floor().cast<int>();
    const auto indexOf = [&](Eigen::Index i)
    { return grid.Index(cells(i, 0), cells(i, 1), cells(i, 2)); };
    std::vector<int> next(grid.Values.size() + 1, 0); // where each cell's next position is put
    for (Eigen::Index i = 0; i < cells.rows(); ++i)
    {
      ++next[indexOf(i) + 1];
    }
    std::partial_sum(next.begin(), next.end(), next.begin());
    for (Eigen::Index i = 0; i < cells.rows(); ++i)
    {
      this->Within[next[indexOf(i)]++] =
        (scaled.row(i) - cells.row(i).cast<double>()).transpose().array();
    }
    const int width = grid.Counts(0), height = grid.Counts(1);
    for (int cell = 0, begin = 0; cell < static_cast<int>(grid.Values.size()); ++cell)
    {
      const int end = next[cell];
      if (begin < end)
      {
        PositionsInCell own{ { cell % width, cell / width % height, cell / width / height }, begin,
          end, this->Within[begin], this->Within[begin] };
        for (int i = begin + 1; i < end; ++i)
        {
          own.Low = own.Low.min(this->Within[i]);
          own.High = own.High.max(this->Within[i]);
        }
        this->Cells.push_back(own);
      }
      begin = end;
    }
  }

  std::vector<Eigen::Array3d> Within;
  std::vector<PositionsInCell> Cells;
};

/// Marks the outermost cells of the grid.
std::vector<char> OnSides(const SampledGrid& grid)
{
  std::vector<char> marked(grid.Values.size(), 0);
  for (int z = 0; z < grid.Counts(2); ++z)
  {
    for (int y = 0; y < grid.Counts(1); ++y)
    {
      for (int x = 0; x < grid.Counts(0); ++x)
      {
        const Eigen::Array3i cell(x, y, z);
        marked[grid.Index(x, y, z)] =
          (cell == 0 || cell == grid.Counts.transpose().array() - 1).any();
      }
    }
  }
  return marked;
}

} // namespace

WellComposedVoxels FindVoxelSolid(const SampledGrid& grid)
{
  WellComposedVoxels solid;
  std::vector<char> changed = OnSides(grid); // these stay outside
  solid.Inside.resize(grid.Values.size());
  std::transform(grid.Values.begin(), grid.Values.end(), changed.begin(), solid.Inside.begin(),
    [](double level, char side) { return static_cast<char>(level < 0.0 && !side); });
  // A change may pinch a corner that was well-composed before: sweeps until nothing changes.
  for (int before = -1; before < solid.Changed;)
  {
    before = solid.Changed;
    solid.Pinched = 0;
    for (int z = 1; z < grid.Counts(2); ++z)
    {
      for (int y = 1; y < grid.Counts(1); ++y)
      {
        for (int x = 1; x < grid.Counts(0); ++x)
        {
          const std::array<int, 8> cells = CellsAround(grid, x, y, z);
          const unsigned int pattern = PatternOf(cells, solid.Inside);
          if (!IsWellComposed(pattern))
          {
            ++solid.Pinched;
            const int cell = CellToChange(pattern, cells, grid.Values, changed);
            if (cell >= 0)
            {
              solid.Inside[cell] ^= 1;
              changed[cell] = 1;
              ++solid.Changed;
            }
          }
        }
      }
    }
  }
  return solid;
}

int CoverSurface(const SampledGrid& grid, const Eigen::MatrixXd& positions, double reach,
  std::vector<char>& inside)
{
  const CellPositions sorted(grid, positions);
  CellFlipper flipper(grid, inside);
  const auto flipNeighbour = [&](const Eigen::RowVector3i& cell)
  {
    std::array<Eigen::RowVector3i, 6> around;
    for (int k = 0; k < 6; ++k)
    {
      around[k] = cell;
      around[k](k / 2) += k % 2 == 0 ? -1 : 1;
    }
    const char here = inside[grid.Index(cell(0), cell(1), cell(2))];
    const auto levelOf = [&](const Eigen::RowVector3i& at)
    { return std::abs(grid.Values(grid.Index(at(0), at(1), at(2)))); };
    std::stable_sort(around.begin(), around.end(),
      [&](const Eigen::RowVector3i& a, const Eigen::RowVector3i& b)
      { return levelOf(a) < levelOf(b); });
    return std::any_of(around.begin(), around.end(),
      [&](const Eigen::RowVector3i& at)
      { return inside[grid.Index(at(0), at(1), at(2))] == here && flipper.Flip(at); });
  };
  for (int before = -1; before < flipper.Count();)
  {
    before = flipper.Count();
    for (const PositionsInCell& own : sorted.Cells)
    {
      const OtherSide other(grid, inside, own.Cell);
      const bool isFar = other.DistanceTo(own.Low, own.High) > reach &&
        std::any_of(sorted.Within.begin() + own.Begin, sorted.Within.begin() + own.End,
          [&](const Eigen::Array3d& position) { return other.DistanceTo(position) > reach; });
      // If the cell itself cannot change, the adjacent cell closest to the boundary may.
      if (isFar && !flipper.Flip(own.Cell))
      {
        flipNeighbour(own.Cell);
      }
    }
  }
  return flipper.Count();
}

void KeepLargestParts(const SampledGrid& grid, int count, std::vector<char>& inside)
{
  const int strides[] = { 1, grid.Counts(0), grid.Counts(0) * grid.Counts(1) };
  std::vector<int> part(inside.size(), -1);
  std::vector<std::size_t> sizes;
  for (std::size_t first = 0; first < inside.size(); ++first)
  {
    if (!inside[first] || part[first] >= 0)
    {
      continue;
    }
    std::vector<int> cells = { static_cast<int>(first) };
    part[first] = static_cast<int>(sizes.size());
    for (std::size_t i = 0; i < cells.size(); ++i)
    {
      for (const int stride : strides)
      {
        // The outermost cells are outside, so a cell inside has all its neighbours.
        for (const int next : { cells[i] - stride, cells[i] + stride })
        {
          if (inside[next] && part[next] < 0)
          {
            part[next] = static_cast<int>(sizes.size());
            cells.push_back(next);
          }
        }
      }
    }
    sizes.push_back(cells.size());
  }
  std::vector<int> order(sizes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return sizes[a] > sizes[b]; });
  std::vector<char> kept(sizes.size(), 0);
  for (int i = 0; i < std::min(count, static_cast<int>(order.size())); ++i)
  {
    kept[order[i]] = 1;
  }
  std::transform(part.begin(), part.end(), inside.begin(),
    [&](int id) { return static_cast<char>(id >= 0 && kept[id]); });
}

HexMesh BuildVoxelHexahedra(const SampledGrid& grid, const std::vector<char>& inside)
{
  constexpr int corners[8][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 },
    { 1, 0, 1 }, { 1, 1, 1 }, { 0, 1, 1 } };
  const Eigen::RowVector3i counts = grid.Counts.array() + 1;
  std::vector<int> pointOf(static_cast<std::size_t>(counts.prod()), -1);
  std::vector<Eigen::RowVector3d> points;
  HexMesh mesh;
  mesh.Hexahedra.resize(std::count(inside.begin(), inside.end(), 1), 8);
  Eigen::Index hex = 0;
  for (int z = 0; z < grid.Counts(2); ++z)
  {
    for (int y = 0; y < grid.Counts(1); ++y)
    {
      for (int x = 0; x < grid.Counts(0); ++x)
      {
        if (!inside[grid.Index(x, y, z)])
        {
          continue;
        }
        for (int k = 0; k < 8; ++k)
        {
          const int i = x + corners[k][0], j = y + corners[k][1], l = z + corners[k][2];
          // Corners of cells are numbered as they are met.
          int& point = pointOf[i + static_cast<std::size_t>(counts(0)) * (j + counts(1) * l)];
          if (point < 0)
          {
            point = static_cast<int>(points.size());
            points.push_back(grid.Point(i, j, l).array() - 0.5 * grid.Spacing);
          }
          mesh.Hexahedra(hex, k) = point;
        }
        ++hex;
      }
    }
  }
  mesh.Points.resize(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    mesh.Points.row(static_cast<Eigen::Index>(i)) = points[i];
  }
  return mesh;
}

} // namespace shape
