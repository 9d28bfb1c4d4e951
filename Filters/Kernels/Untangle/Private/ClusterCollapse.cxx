#include "Untangle/Private/ClusterCollapse.h"

#include "Geometry/PositiveTetrahedron.h"
#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/TutteEmbedding.h"

#include <algorithm>
#include <cstddef>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// How many rings of points around a cluster move.
constexpr int MovedRings = 3;

/// A Newton step takes about the time in which a cluster looks at this many cells for each simplex.
constexpr std::size_t WorkOfStep = 40;

} // namespace

bool ClusterCollapse::MakeSpace(const Progress& progress)
{
  constexpr int trials = 4;
  constexpr std::size_t maximumPoints = 60;
  SolidCells& solid = this->Cluster.Solid;
  const Eigen::VectorXd sizes = this->FindSizes(progress);
  for (int trial = 0; trial < trials && this->Cluster.Points().size() <= maximumPoints; ++trial)
  {
    const std::vector<int> points = this->FindMovedPoints();
    solid.KeepPositions(points);
    SimplexPatch patch = BuildPatch(solid, points, sizes, progress);
    if (this->MovePoints(patch, progress) == 0)
    {
      this->Cluster.MoveTo(this->Cluster.GetPosition());
      return this->Cluster.IsCollapsible();
    }
    if (!this->AddInverted(patch))
    {
      return false;
    }
  }
  return false;
}

/// Returns the sizes of the cells around each point. New points have the means of their parents.
Eigen::VectorXd ClusterCollapse::FindSizes(const Progress& progress)
{
  const SolidCells& solid = this->Cluster.Solid;
  if (this->GivenSizes.size() == 0)
  {
    this->GivenSizes = ComputeLogarithmicSizes(solid, progress);
  }
  Eigen::VectorXd sizes(solid.PointCount());
  sizes.head(this->GivenSizes.size()) = this->GivenSizes;
  for (auto point = static_cast<int>(this->GivenSizes.size()); point < solid.PointCount(); ++point)
  {
    double sum = 0.0, count = 0.0;
    for (const int parent : solid.Parents[point - solid.OriginalPointCount])
    {
      sum += parent < 0 ? 0.0 : sizes(parent);
      count += parent < 0 ? 0.0 : 1.0;
    }
    sizes(point) = sum / count;
  }
  return sizes;
}

/// Returns the inner points of the cluster and of the rings around it, ascending.
std::vector<int> ClusterCollapse::FindMovedPoints() const
{
  const SolidCells& solid = this->Cluster.Solid;
  std::vector<int> points = FindPointsAround(solid, this->Cluster.Points(), MovedRings);
  points.erase(std::remove_if(points.begin(), points.end(),
                 [&](int point)
                 {
                   this->Cluster.Count(solid.CellsOf(point).size());
                   return solid.OnBoundary(point);
                 }),
    points.end());
  return points;
}

/// Makes the cluster one point of a patch, and moves the points of the patch. Returns the number of
/// its simplices that are not positive.
int ClusterCollapse::MovePoints(SimplexPatch& patch, const Progress& progress)
{
  const int collapsed = this->Cluster.Points().front();
  std::vector<ReferenceSimplex> kept;
  std::set<int> corners;
  for (ReferenceSimplex& simplex : patch.Simplices)
  {
    int inside = 0;
    for (int& corner : simplex.Corners)
    {
      if (this->Cluster.IsIn(corner))
      {
        corner = collapsed;
        ++inside;
      }
    }
    if (inside < 2)
    {
      kept.push_back(simplex);
      corners.insert(simplex.Corners.begin(), simplex.Corners.end());
    }
  }
  patch.Simplices = std::move(kept);
  std::vector<int>& free = patch.FreePoints;
  free.erase(
    std::remove_if(free.begin(), free.end(), [&](int point) { return corners.count(point) == 0; }),
    free.end());
  this->Cluster.MoveTo(this->Cluster.ComputeCentroid());
  PatchOptions options;
  // With the 40 steps of MovePoints, the model oblong ends with 18506 cells instead of 9234.
  options.Patience = 20;
  options.FurtherSteps = 10; // which widen the kernel that the cluster is expanded in
  const PatchResult moved =
    MinimizeEnergy(this->Cluster.Solid.Points, patch, nullptr, options, progress);
  this->Cluster.Count(WorkOfStep * static_cast<std::size_t>(moved.Steps) * patch.Simplices.size());
  return moved.Negative;
}

/// Adds the movable corners of simplices that are not positive. Returns whether there are any.
bool ClusterCollapse::AddInverted(const SimplexPatch& patch)
{
  std::set<int> joining;
  for (const ReferenceSimplex& simplex : patch.Simplices)
  {
    if (IsPositive(this->Cluster.Solid.Points, simplex.Corners))
    {
      continue;
    }
    for (const int point : simplex.Corners)
    {
      if (!this->Cluster.IsIn(point) && this->Cluster.IsMovable(point))
      {
        joining.insert(point);
      }
    }
  }
  for (const int point : joining)
  {
    this->Cluster.Add(point);
  }
  return !joining.empty();
}

} // namespace shape
