#include "Volume/OffsetSurface.h"

#include "Core/Errors.h"
#include "Geometry/IsoSurface.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{

namespace
{

/// Cells along one side of a block that is skipped as a whole.
constexpr int BlockCells = 4;

SampledGrid EmptyGrid(
  const Eigen::MatrixXd& points, double distance, const OffsetSurfaceOptions& options)
{
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const Eigen::RowVector3d high = points.colwise().maxCoeff();
  SampledGrid grid;
  for (grid.Spacing = distance / options.CellsPerDistance;; grid.Spacing *= 1.1)
  {
    // Two cells beyond the offset surface, so that it never meets a side; whole blocks.
    const Eigen::RowVector3d margin = Eigen::RowVector3d::Constant(distance + 2.0 * grid.Spacing);
    grid.Origin = low - margin;
    const Eigen::Array3d blocks =
      ((high - low + 2.0 * margin) / (BlockCells * grid.Spacing)).array().ceil();
    if ((BlockCells * blocks + 1.0).prod() <= options.MaximumSamples)
    {
      grid.Counts = (BlockCells * blocks.cast<int>() + 1).matrix().transpose();
      return grid;
    }
    if (grid.Spacing > distance)
    {
      throw InvalidInput("the offset distance is " +
        std::to_string(distance / LongestSide(points)) +
        " of the surface's longest side, too small to sample; increase it");
    }
  }
}

/// Calls visit(x, y, z) for each of the (BlockCells + 1)^3 points of a block.
template <typename Visit>
void ForBlock(const Eigen::RowVector3i& block, const Visit& visit)
{
  const Eigen::RowVector3i first = BlockCells * block;
  for (int z = first(2); z <= first(2) + BlockCells; ++z)
  {
    for (int y = first(1); y <= first(1) + BlockCells; ++y)
    {
      for (int x = first(0); x <= first(0) + BlockCells; ++x)
      {
        visit(x, y, z);
      }
    }
  }
}

void Sample(
  SampledGrid& grid, const SignedDistance& field, double distance, const Progress& progress)
{
  const Eigen::RowVector3i blocks = (grid.Counts.array() - 1) / BlockCells;
  std::vector<Eigen::RowVector3i> block;
  Eigen::MatrixXd centres(blocks.prod(), 3);
  for (int z = 0; z < blocks(2); ++z)
  {
    for (int y = 0; y < blocks(1); ++y)
    {
      for (int x = 0; x < blocks(0); ++x)
      {
        centres.row(block.size()) = grid.Origin +
          BlockCells * grid.Spacing * (Eigen::RowVector3d(x, y, z).array() + 0.5).matrix();
        block.emplace_back(x, y, z);
      }
    }
  }
  const Eigen::VectorXd atCentre = field.Evaluate(centres, progress.Part(0.0, 0.3)).Distances;
  // A whole block's points are on the side of its centre where it is farther than its corners.
  const double reach = 1.001 * std::sqrt(0.75) * BlockCells * grid.Spacing;
  grid.Values.resize(grid.Counts.prod());
  std::vector<char> isNear(grid.Values.size(), 0);
  std::vector<Eigen::RowVector3i> nearPoints;
  for (std::size_t b = 0; b < block.size(); ++b)
  {
    const bool skip = std::abs(atCentre(b) - distance) > reach;
    ForBlock(block[b],
      [&](int x, int y, int z)
      {
        const int index = grid.Index(x, y, z);
        if (skip && !isNear[index])
        {
          grid.Values(index) = atCentre(b);
        }
        else if (!skip && !isNear[index])
        {
          isNear[index] = 1;
          nearPoints.emplace_back(x, y, z);
        }
      });
  }
  Eigen::MatrixXd points(nearPoints.size(), 3);
  for (std::size_t i = 0; i < nearPoints.size(); ++i)
  {
    points.row(i) = grid.Point(nearPoints[i](0), nearPoints[i](1), nearPoints[i](2));
  }
  const Eigen::VectorXd exact = field.Evaluate(points, progress.Part(0.3, 1.0)).Distances;
  for (std::size_t i = 0; i < nearPoints.size(); ++i)
  {
    grid.Values(grid.Index(nearPoints[i](0), nearPoints[i](1), nearPoints[i](2))) = exact(i);
  }
}

} // namespace

Mesh OffsetSurface(const SignedDistance& field, double distance,
  const OffsetSurfaceOptions& options, const Progress& progress)
{
  if (!(distance > 0.0) || !std::isfinite(distance))
  {
    throw InvalidInput("the offset distance must be greater than 0");
  }
  SampledGrid grid = EmptyGrid(field.Locator().Surface().Points, distance, options);
  Sample(grid, field, distance, progress.Part(0.0, 0.8));
  Mesh surface = IsoSurface(grid, distance);
  MoveToDistance(surface.Points, field, distance, progress.Part(0.8, 1.0));
  return surface;
}

void MoveToDistance(
  Eigen::MatrixXd& points, const SignedDistance& field, double distance, const Progress& progress)
{
  // The closest point changes with the move where the surface is concave: few rounds settle it.
  constexpr int rounds = 3;
  for (int round = 0; round < rounds && points.rows() > 0; ++round)
  {
    const SignedDistance::Result at = field.Evaluate(
      points, progress.Part(static_cast<double>(round) / rounds, (round + 1.0) / rounds));
    if ((at.Distances.array() - distance).abs().maxCoeff() < 1e-9 * distance)
    {
      return;
    }
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      if (at.Distances(i) != 0.0)
      {
        points.row(i) = at.Closest.Positions.row(i) +
          distance / at.Distances(i) * (points.row(i) - at.Closest.Positions.row(i));
      }
    }
  }
}

} // namespace shape
