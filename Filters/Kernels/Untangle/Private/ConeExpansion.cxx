#include "Untangle/Private/ConeExpansion.h"

#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/CellSplits.h"
#include "Untangle/Private/ClusterCollapse.h"
#include "Untangle/Private/ClusterExpansion.h"
#include "Untangle/Private/ClusterGrowth.h"
#include "Untangle/Private/PointCluster.h"

#include <algorithm>
#include <optional>
#include <unordered_set>
#include <vector>

namespace shape
{
namespace
{

/// Finds the clusters of inverted tetrahedra, each tetrahedron once.
class ClusterSearch
{
public:
  explicit ClusterSearch(SolidCells& solid)
    : Solid(solid)
  {
  }

  /// Returns the points of the next cluster, or none. What an expansion has done since the last
  /// call does not matter: it inverts nothing, and the parts of split cells come after the others.
  std::vector<int> FindNext()
  {
    this->Tried.resize(this->Solid.CellCount(), 0);
    for (; this->Next < this->Solid.CellCount(); ++this->Next)
    {
      if (this->Tried[this->Next] || this->Solid.PointsOf(this->Next).size() != 4 ||
        !this->Solid.Inverted(this->Next))
      {
        continue;
      }
      std::vector<int> points = this->CollectFrom(this->Next);
      if (!points.empty())
      {
        return points;
      }
    }
    return {};
  }

private:
  /// Returns the inner points of an inverted tetrahedron and of those connected to it by such
  /// points. All these tetrahedra count as tried.
  std::vector<int> CollectFrom(int first)
  {
    std::vector<int> points, cells = { first };
    std::unordered_set<int> taken;
    this->Tried[first] = 1;
    while (!cells.empty())
    {
      const int cell = cells.back();
      cells.pop_back();
      for (const int point : this->Solid.PointsOf(cell))
      {
        if (taken.count(point) > 0 || !PointCluster::IsMovable(this->Solid, point))
        {
          continue;
        }
        taken.insert(point);
        points.push_back(point);
        for (const int other : this->Solid.CellsOf(point))
        {
          if (!this->Tried[other] && this->Solid.Inverted(other))
          {
            this->Tried[other] = 1;
            cells.push_back(other);
          }
        }
      }
    }
    return points;
  }

  SolidCells& Solid;
  std::vector<char> Tried; ///< for each cell
  int Next = 0;
};

/// Makes space for a cluster and expands it. Returns whether that succeeds; the solid has to be
/// restored if not.
bool ExpandInSpace(PointCluster& cluster, ClusterCollapse& collapse,
  const std::vector<int>& members, const ConeExpansionOptions& options, ConeExpansionResult& result,
  const Progress& progress)
{
  cluster.Begin(members);
  ConeExpansionResult expanded = result;
  if (!collapse.MakeSpace(progress.Part(0.0, 0.0)) ||
    !ClusterExpansion(cluster, 0).Expand(options, expanded, progress))
  {
    return false;
  }
  result = expanded;
  return true;
}

/// Grows and expands a cluster, and enlarges it if it does not expand. Returns whether an attempt
/// succeeds; the solid has to be restored if none does.
bool ExpandWithAttempts(PointCluster& cluster, std::vector<int> members,
  const ConeExpansionOptions& options, ConeExpansionResult& result, const Progress& progress)
{
  SolidCells& solid = cluster.Solid;
  const int given = solid.PointCount();
  for (int attempt = 0; attempt < options.MaximumAttempts; ++attempt)
  {
    cluster.Begin(members);
    if (attempt % 4 == 3)
    {
      AddRing(cluster);
    }
    const std::optional<Eigen::RowVector3d> position = GrowCluster(cluster);
    if (!position)
    {
      return false;
    }
    // The next attempt begins with what this one added, except for new points.
    members = cluster.Points();
    members.erase(
      std::remove_if(members.begin(), members.end(), [&](int point) { return point >= given; }),
      members.end());
    // An expansion moves no other points, except for new ones.
    solid.KeepPositions(cluster.FindPointsAround());
    cluster.MoveTo(*position);
    ConeExpansionResult expanded = result;
    if (ClusterExpansion(cluster, attempt).Expand(options, expanded, progress))
    {
      result = expanded;
      return true;
    }
    solid.RestoreState();
  }
  return false;
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
      .Impossible(FindInverted(solid, progress.Part(0.0, 0.0)), progress.Part(0.0, 0.0));
  }
  ConeExpansionResult result;
  PointCluster cluster(solid, options, progress);
  ClusterCollapse collapse(cluster);
  ClusterSearch search(solid);
  try
  {
    for (;;)
    {
      progress(0.0);
      const std::vector<int> members = search.FindNext();
      if (members.empty())
      {
        break;
      }
      solid.KeepState();
      if (ExpandInSpace(cluster, collapse, members, options, result, progress))
      {
        continue;
      }
      solid.RestoreState();
      if (!ExpandWithAttempts(cluster, members, options, result, progress))
      {
        solid.RestoreState();
      }
    }
  }
  catch (const WorkSpent&)
  {
    solid.RestoreState();
  }
  solid.ForgetState();
  return result;
}

} // namespace shape
