#include "Hex/Voxels/Private/NarrowBandDistance.h"

#include "Base/Errors.h"
#include "Solids/GridWinding.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// Marks the cells whose centres may be nearer than LevelBand cells to a surface.
std::vector<char> CellsNear(const Mesh& surface, const SampledGrid& grid)
{
  std::vector<char> near(grid.Counts.cast<Eigen::Index>().prod(), 0);
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = (GetCorners(surface, t).rowwise() - grid.Origin) / grid.Spacing;
    const Eigen::Array3i low =
      (corners.colwise().minCoeff().transpose().array() - LevelBand).ceil().cast<int>().max(0);
    const Eigen::Array3i high = (corners.colwise().maxCoeff().transpose().array() + LevelBand)
                                  .floor()
                                  .cast<int>()
                                  .min(grid.Counts.transpose().array() - 1);
    for (int z = low(2); z <= high(2); ++z)
    {
      for (int y = low(1); y <= high(1); ++y)
      {
        const auto row = near.begin() + grid.Index(0, y, z);
        std::fill(row + low(0), row + std::max(high(0) + 1, low(0)), 1);
      }
    }
  }
  return near;
}

} // namespace

SampledGrid BuildGridAround(const Eigen::MatrixXd& points, double size)
{
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const Eigen::RowVector3d high = points.colwise().maxCoeff();
  const Eigen::RowVector3d counts = ((high - low) / size).array().ceil() + 3.0;
  constexpr double maximum = 2e8;
  if (!(counts.prod() <= maximum))
  {
    throw InvalidInput("cells of size " + std::to_string(size) + " make a grid of " +
      std::to_string(counts.prod()) + " cells around the surface; at most " +
      std::to_string(maximum) +
      " are possible: make CellSize greater, or turn the surface along the axes");
  }
  SampledGrid grid;
  grid.Spacing = size;
  grid.Counts = counts.cast<int>();
  grid.Origin = 0.5 * (low + high) - 0.5 * size * (counts.array() - 1.0).matrix();
  return grid;
}

void SampleDistances(
  const Mesh& surface, const SurfaceLocator& boundary, SampledGrid& grid, const Progress& progress)
{
  const double far = LevelBand * grid.Spacing;
  const Eigen::VectorXi windings = ComputeGridWindingNumbers(surface, grid);
  grid.Values =
    (windings.array() > 0).select(Eigen::VectorXd::Constant(windings.size(), -far), far);
  const std::vector<char> near = CellsNear(boundary.GetSurface(), grid);
  std::vector<int> cells;
  for (int cell = 0; cell < static_cast<int>(near.size()); ++cell)
  {
    if (near[cell])
    {
      cells.push_back(cell);
    }
  }
  Eigen::MatrixXd centres(static_cast<Eigen::Index>(cells.size()), 3);
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    const int x = cells[i] % grid.Counts(0), yz = cells[i] / grid.Counts(0);
    centres.row(static_cast<Eigen::Index>(i)) =
      grid.Point(x, yz % grid.Counts(1), yz / grid.Counts(1));
  }
  const Eigen::VectorXd distances = boundary.Find(centres, progress).Distances;
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    double& level = grid.Values(cells[i]);
    level =
      std::copysign(std::min(distances(static_cast<Eigen::Index>(i)), std::abs(level)), level);
  }
}

SampledGrid SampleSolidDistances(
  const Mesh& surface, const SurfaceLocator& boundary, double size, const Progress& progress)
{
  SampledGrid grid = BuildGridAround(surface.Points, size);
  SampleDistances(surface, boundary, grid, progress);
  return grid;
}

} // namespace shape
