#include "Untangle/Private/ConeExpansion.h"

#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/CellSplits.h"
#include "Untangle/Private/ClusterExpansion.h"
#include "Untangle/Private/ClusterGrowth.h"
#include "Untangle/Private/PointCluster.h"

#include <algorithm>

namespace shape
{
namespace
{

/// Returns the inner points of an inverted tetrahedron and of those connected to it by such points.
/// All these tetrahedra count as tried.
std::vector<int> CollectCluster(SolidCells& solid, int first, std::vector<char>& tried)
{
  std::vector<int> points, cells = { first };
  std::vector<char> taken(solid.PointCount(), 0);
  tried[first] = 1;
  while (!cells.empty())
  {
    const int cell = cells.back();
    cells.pop_back();
    for (const int point : solid.PointsOf(cell))
    {
      if (taken[point] || !PointCluster::IsMovable(solid, point))
      {
        continue;
      }
      taken[point] = 1;
      points.push_back(point);
      for (const int other : solid.CellsOf(point))
      {
        if (!tried[other] && solid.Inverted(other))
        {
          tried[other] = 1;
          cells.push_back(other);
        }
      }
    }
  }
  return points;
}

/// Returns the points of a cluster whose inverted tetrahedra have not been tried, or none.
std::vector<int> FindNextCluster(SolidCells& solid, std::vector<char>& tried)
{
  tried.resize(solid.CellCount(), 0);
  for (int first = 0; first < solid.CellCount(); ++first)
  {
    if (tried[first] || solid.PointsOf(first).size() != 4 || !solid.Inverted(first))
    {
      continue;
    }
    std::vector<int> points = CollectCluster(solid, first, tried);
    if (!points.empty())
    {
      return points;
    }
  }
  return {};
}

/// Grows and expands a cluster, and enlarges it if it does not expand. The solid is restored if no
/// attempt succeeds.
void ExpandWithAttempts(SolidCells& solid, std::vector<int> members,
  const ConeExpansionOptions& options, double& work, ConeExpansionResult& result,
  const Progress& progress)
{
  const SolidCells kept = solid;
  for (int attempt = 0; attempt < options.MaximumAttempts && work < options.MaximumWork; ++attempt)
  {
    PointCluster cluster(solid, members, options.SplitCells, work);
    if (attempt % 4 == 3)
    {
      AddRing(cluster);
    }
    if (!GrowCluster(cluster, progress))
    {
      solid = kept;
      return;
    }
    // The next attempt begins with what this one added, except for new points.
    members = cluster.Points();
    members.erase(std::remove_if(members.begin(), members.end(),
                    [&](int point) { return point >= kept.PointCount(); }),
      members.end());
    ConeExpansionResult expanded = result;
    if (ClusterExpansion(cluster, attempt).Expand(options, expanded, progress))
    {
      result = expanded;
      return;
    }
    solid = kept;
  }
}

} // namespace

ConeExpansionResult ExpandInverted(
  SolidCells& solid, const ConeExpansionOptions& options, const Progress& report)
{
  double done = 0.0;
  const Progress progress(
    [&](double fraction)
    {
      // Attempts begin anew, but the reports do not fall.
      done = std::max(done, fraction);
      report(done);
      return true;
    });
  if (options.SplitCells)
  {
    // Tetrahedra without an inner point need one.
    CellSplits(solid, [&](int point) { return !solid.OnBoundary(point); })
      .Impossible(FindInverted(solid));
  }
  ConeExpansionResult result;
  double work = 0.0;
  std::vector<char> tried;
  for (;;)
  {
    progress(0.0);
    const std::vector<int> members = FindNextCluster(solid, tried);
    if (members.empty())
    {
      return result;
    }
    ExpandWithAttempts(solid, members, options, work, result, progress);
  }
}

} // namespace shape
