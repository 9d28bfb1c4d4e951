#include "Harmonic/Private/OffsetSurface.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Solids/IsoSurface.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{

namespace
{

/// Cells along each edge of the largest and the smallest blocks that can be skipped.
constexpr int LargestBlock = 8, SmallestBlock = 2;

SampledGrid EmptyGrid(
  const Eigen::MatrixXd& points, double distance, const OffsetSurfaceOptions& options)
{
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const Eigen::RowVector3d high = points.colwise().maxCoeff();
  SampledGrid grid;
  for (grid.Spacing = distance / options.CellsPerDistance;; grid.Spacing *= 1.1)
  {
    // Two cells beyond the offset surface, so that it never meets the grid's faces; a whole number
    // of blocks.
    const Eigen::RowVector3d margin = Eigen::RowVector3d::Constant(distance + 2.0 * grid.Spacing);
    grid.Origin = low - margin;
    const Eigen::Array3d blocks =
      ((high - low + 2.0 * margin) / (LargestBlock * grid.Spacing)).array().ceil();
    if ((LargestBlock * blocks + 1.0).prod() <= options.MaximumSamples)
    {
      grid.Counts = (LargestBlock * blocks.cast<int>() + 1).matrix().transpose();
      return grid;
    }
    if (grid.Spacing > distance)
    {
      throw InvalidInput("the offset distance is too small to sample: " +
        FormatNumber(distance / ComputeLongestBoxEdge(points)) +
        " times the longest edge of the surface's bounding box; increase it");
    }
  }
}

/// Calls visit(x, y, z) for each grid point of the block with `cells` cells along each edge and
/// first point `first`.
template <typename Visit>
void ForBlock(const Eigen::RowVector3i& first, int cells, const Visit& visit)
{
  for (int z = first(2); z <= first(2) + cells; ++z)
  {
    for (int y = first(1); y <= first(1) + cells; ++y)
    {
      for (int x = first(0); x <= first(0) + cells; ++x)
      {
        visit(x, y, z);
      }
    }
  }
}

/// Returns the first grid point of every block with `cells` cells along each edge.
std::vector<Eigen::RowVector3i> AllBlocks(const SampledGrid& grid, int cells)
{
  std::vector<Eigen::RowVector3i> blocks;
  for (int z = 0; z + 1 < grid.Counts(2); z += cells)
  {
    for (int y = 0; y + 1 < grid.Counts(1); y += cells)
    {
      for (int x = 0; x + 1 < grid.Counts(0); x += cells)
      {
        blocks.emplace_back(x, y, z);
      }
    }
  }
  return blocks;
}

std::vector<Eigen::RowVector3i> Halved(const std::vector<Eigen::RowVector3i>& blocks, int cells)
{
  std::vector<Eigen::RowVector3i> halved;
  halved.reserve(8 * blocks.size());
  for (const Eigen::RowVector3i& block : blocks)
  {
    ForBlock(Eigen::RowVector3i::Zero(), 1,
      [&](int x, int y, int z)
      { halved.emplace_back(block + cells / 2 * Eigen::RowVector3i(x, y, z)); });
  }
  return halved;
}

/// Returns the blocks that may intersect the level. The grid points of the others get the distance
/// of their block's centre: these blocks lie completely on one side of the level.
std::vector<Eigen::RowVector3i> NearBlocks(SampledGrid& grid,
  const std::vector<Eigen::RowVector3i>& blocks, int cells, const SignedDistance& field,
  double distance, const Progress& progress)
{
  Eigen::MatrixXd centres(blocks.size(), 3);
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    centres.row(b) =
      grid.Origin + grid.Spacing * (blocks[b].cast<double>().array() + 0.5 * cells).matrix();
  }
  const Eigen::VectorXd atCentre = field.Evaluate(centres, progress).Distances;
  // Half the diagonal of a block, and a little for rounding.
  const double reach = 1.001 * std::sqrt(0.75) * cells * grid.Spacing;
  std::vector<Eigen::RowVector3i> nearBlocks;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    if (std::abs(atCentre(b) - distance) <= reach)
    {
      nearBlocks.push_back(blocks[b]);
      continue;
    }
    ForBlock(blocks[b], cells,
      [&](int x, int y, int z) { grid.Values(grid.Index(x, y, z)) = atCentre(b); });
  }
  return nearBlocks;
}

void Sample(
  SampledGrid& grid, const SignedDistance& field, double distance, const Progress& progress)
{
  // Blocks far from the level are skipped; the others are halved until they have the smallest size.
  // Then the distance is computed at each of their grid points, once.
  grid.Values.resize(grid.Counts.prod());
  std::vector<Eigen::RowVector3i> blocks = AllBlocks(grid, LargestBlock);
  int cells = LargestBlock;
  double done = 0.0;
  for (;; cells /= 2)
  {
    blocks = NearBlocks(grid, blocks, cells, field, distance, progress.Part(done, done + 0.2));
    done += 0.2;
    if (cells == SmallestBlock)
    {
      break;
    }
    blocks = Halved(blocks, cells);
  }
  // This comes last, because points shared with a skipped block need their exact distance.
  std::vector<char> isNear(grid.Values.size(), 0);
  std::vector<Eigen::RowVector3i> positions;
  for (const Eigen::RowVector3i& block : blocks)
  {
    ForBlock(block, cells,
      [&](int x, int y, int z)
      {
        char& seen = isNear[grid.Index(x, y, z)];
        if (!seen)
        {
          seen = 1;
          positions.emplace_back(x, y, z);
        }
      });
  }
  Eigen::MatrixXd points(positions.size(), 3);
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    points.row(i) = grid.Point(positions[i](0), positions[i](1), positions[i](2));
  }
  const Eigen::VectorXd exact = field.Evaluate(points, progress.Part(done, 1.0)).Distances;
  for (std::size_t i = 0; i < positions.size(); ++i)
  {
    grid.Values(grid.Index(positions[i](0), positions[i](1), positions[i](2))) = exact(i);
  }
}

} // namespace

Mesh BuildOffsetSurface(const SignedDistance& field, double distance,
  const OffsetSurfaceOptions& options, const Progress& progress)
{
  if (!(distance > 0.0) || !std::isfinite(distance))
  {
    throw InvalidInput("the offset distance must be greater than 0");
  }
  // The offset surface is a level set of the distance field, as in Li et al. 2010, section 3.2.
  SampledGrid grid = EmptyGrid(field.GetSurface().Points(), distance, options);
  Sample(grid, field, distance, progress);
  return ExtractIsoSurface(grid, distance);
}

void MoveToDistance(Eigen::MatrixXd& points, const SignedDistance& field,
  const Eigen::VectorXd& distances, const Progress& progress)
{
  // Where the surface is concave, a move changes the closest point; a few rounds converge.
  constexpr int rounds = 3;
  for (int round = 0; round < rounds && points.rows() > 0; ++round)
  {
    const SignedDistance::Result at = field.Evaluate(
      points, progress.Part(static_cast<double>(round) / rounds, (round + 1.0) / rounds));
    if (((at.Distances - distances).array().abs() < 1e-9 * distances.array()).all())
    {
      return;
    }
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      if (at.Distances(i) != 0.0)
      {
        // Along the ray from the closest position through the point.
        points.row(i) = at.Closest.Positions.row(i) +
          distances(i) / at.Distances(i) * (points.row(i) - at.Closest.Positions.row(i));
      }
    }
  }
}

} // namespace shape
