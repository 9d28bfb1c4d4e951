#include "Untangle/Private/KernelMoves.h"

#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/StarKernel.h"

#include <algorithm>
#include <set>
#include <vector>

namespace shape
{
namespace
{

/// Moves a point if fewer of its tetrahedra are inverted afterwards. Returns by how many.
int MoveIntoKernel(SolidCells& solid, int point)
{
  const std::vector<int>& cells = solid.CellsOf(point);
  const auto count = [&]
  {
    return static_cast<int>(
      std::count_if(cells.begin(), cells.end(), [&](int cell) { return solid.Inverted(cell); }));
  };
  const int before = count();
  if (before == 0)
  {
    return 0;
  }
  const Eigen::RowVector3d kept = solid.Points.row(point);
  solid.Points.row(point) =
    FindKernelCentre(solid.Points, FindFacesAround(solid, point), kept).Position;
  const int gain = before - count();
  if (gain <= 0)
  {
    solid.Points.row(point) = kept;
    return 0;
  }
  return gain;
}

/// Moves a point whose tetrahedra are positive to the centre of its kernel.
void Relax(SolidCells& solid, int point)
{
  const StarPlacement placement =
    FindKernelCentre(solid.Points, FindFacesAround(solid, point), solid.Points.row(point));
  if (placement.IsValid)
  {
    solid.Points.row(point) = placement.Position;
  }
}

/// Returns the inner points of some cells.
std::set<int> FindInnerPoints(const SolidCells& solid, const std::vector<int>& cells)
{
  std::set<int> points;
  for (const int cell : cells)
  {
    for (const int point : solid.PointsOf(cell))
    {
      if (!solid.OnBoundary(point))
      {
        points.insert(point);
      }
    }
  }
  return points;
}

} // namespace

int MoveIntoKernels(SolidCells& solid, const Progress& progress)
{
  constexpr int patience = 20, patiencePerRing = 5;
  constexpr std::size_t maximumMoves = 200000;
  std::size_t moves = 0;
  for (int idle = 0;;)
  {
    const std::vector<int> inverted = FindInverted(solid, progress.Part(0.0, 0.0));
    const std::set<int> points = FindInnerPoints(solid, inverted);
    moves += points.size();
    int gain = 0;
    for (const int point : points)
    {
      progress(0.0);
      gain += MoveIntoKernel(solid, point);
    }
    idle = gain > 0 ? 0 : idle + 1;
    if (inverted.empty() || idle > patience || moves > maximumMoves)
    {
      return static_cast<int>(inverted.size());
    }
    if (idle == 0)
    {
      continue;
    }
    // Points around make space.
    const std::vector<int> around = FindPointsAround(
      solid, { points.begin(), points.end() }, 1 + idle / patiencePerRing, progress.Part(0.0, 0.0));
    moves += around.size();
    for (const int point : around)
    {
      if (!solid.OnBoundary(point))
      {
        progress(0.0);
        Relax(solid, point);
      }
    }
  }
}

} // namespace shape
