#include "Untangle/Private/CellPatches.h"

#include "Geometry/PositiveTetrahedron.h"
#include "Untangle/EllipticEnergy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace shape
{

std::vector<int> FindInverted(SolidCells& solid, const Progress& progress)
{
  std::vector<int> inverted;
  for (int cell = 0; cell < solid.CellCount(); ++cell)
  {
    if (cell % ReportInterval == 0)
    {
      progress(static_cast<double>(cell) / solid.CellCount());
    }
    if (solid.Inverted(cell))
    {
      inverted.push_back(cell);
    }
  }
  return inverted;
}

std::vector<int> FindPointsAround(
  const SolidCells& solid, std::vector<int> points, int rings, const Progress& progress)
{
  std::vector<char> found(solid.PointCount(), 0);
  for (const int point : points)
  {
    found[point] = 1;
  }
  std::size_t begin = 0;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (const std::size_t end = points.size(); begin < end; ++begin)
    {
      if (begin % ReportInterval == 0)
      {
        progress(static_cast<double>(ring) / rings);
      }
      for (const int cell : solid.CellsOf(points[begin]))
      {
        for (const int other : solid.PointsOf(cell))
        {
          if (!found[other])
          {
            found[other] = 1;
            points.push_back(other);
          }
        }
      }
    }
  }
  std::sort(points.begin(), points.end());
  return points;
}

std::vector<char> MarkAroundInverted(SolidCells& solid, int rings, const Progress& progress)
{
  std::vector<char> marked(solid.PointCount(), 0);
  std::set<int> points;
  for (const int cell : FindInverted(solid, progress.Part(0.0, 0.0)))
  {
    points.insert(solid.PointsOf(cell).begin(), solid.PointsOf(cell).end());
  }
  for (const int point :
    FindPointsAround(solid, { points.begin(), points.end() }, rings - 1, progress))
  {
    marked[point] = 1;
  }
  return marked;
}

std::vector<std::vector<int>> FindMovablePatches(const SolidCells& solid,
  const std::vector<char>& marked, const std::function<bool(int)>& movable,
  const Progress& progress)
{
  std::vector<char> taken(solid.PointCount(), 0);
  const auto take = [&](int point, std::vector<int>& patch)
  {
    if (marked[point] && movable(point) && !taken[point])
    {
      taken[point] = 1;
      patch.push_back(point);
    }
  };
  std::vector<std::vector<int>> patches;
  for (int first = 0; first < solid.PointCount(); ++first)
  {
    std::vector<int> patch;
    take(first, patch);
    for (std::size_t i = 0; i < patch.size(); ++i)
    {
      if (i % ReportInterval == 0)
      {
        progress(static_cast<double>(first) / solid.PointCount());
      }
      for (const int cell : solid.CellsOf(patch[i]))
      {
        for (const int point : solid.PointsOf(cell))
        {
          take(point, patch);
        }
      }
    }
    if (!patch.empty())
    {
      std::sort(patch.begin(), patch.end());
      patches.push_back(std::move(patch));
    }
  }
  return patches;
}

SimplexPatch BuildPatch(SolidCells& solid, const std::vector<int>& points,
  const Eigen::VectorXd& sizes, const Progress& progress)
{
  SimplexPatch patch;
  patch.FreePoints = points;
  std::vector<int> cells;
  for (const int point : points)
  {
    const std::vector<int>& around = solid.CellsOf(point);
    cells.insert(cells.end(), around.begin(), around.end());
  }
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  for (std::size_t i = 0; i < cells.size(); ++i)
  {
    if (i % ReportInterval == 0)
    {
      progress(static_cast<double>(i) / static_cast<double>(cells.size()));
    }
    const int cell = cells[i];
    const auto simplices = solid.SimplicesOf(cell);
    for (std::size_t k = 0; k < simplices.size(); ++k)
    {
      const std::array<int, 4>& corners = simplices[k];
      if (std::none_of(corners.begin(), corners.end(),
            [&](int point) { return std::binary_search(points.begin(), points.end(), point); }))
      {
        continue;
      }
      double size = 0.0;
      for (const int point : corners)
      {
        size += 0.25 * sizes(point);
      }
      patch.Simplices.push_back({ corners,
        ComputeHatGradients(solid.Reference(cell, static_cast<int>(k), std::exp(size))) });
    }
  }
  return patch;
}

int CountNegative(const SimplexPatch& patch, const Eigen::MatrixXd& x)
{
  return static_cast<int>(std::count_if(patch.Simplices.begin(), patch.Simplices.end(),
    [&](const ReferenceSimplex& simplex) { return !IsPositive(x, simplex.Corners); }));
}

} // namespace shape
