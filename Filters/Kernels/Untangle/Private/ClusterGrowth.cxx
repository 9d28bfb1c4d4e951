#include "Untangle/Private/ClusterGrowth.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace shape
{
namespace
{

/// Returns the longest edge of a face that can be split, or the face if only it can be; else none.
std::vector<int> FindSplittable(const PointCluster& cluster, const StarFace& face)
{
  std::vector<int> simplex;
  double longest = 0.0;
  for (int k = 0; k < 3; ++k)
  {
    const std::vector<int> edge = { face[k], face[(k + 1) % 3] };
    const double length =
      (cluster.Solid.Points.row(edge[0]) - cluster.Solid.Points.row(edge[1])).norm();
    if (length > longest && cluster.CanSplit(edge))
    {
      longest = length;
      simplex = edge;
    }
  }
  if (simplex.empty() && cluster.CanSplit({ face[0], face[1], face[2] }))
  {
    simplex = { face[0], face[1], face[2] };
  }
  return simplex;
}

/// Inserts a point of the cluster into a face or one of its edges. Returns whether that can be.
bool AddSplit(PointCluster& cluster, const StarFace& face)
{
  const std::vector<int> simplex = FindSplittable(cluster, face);
  if (simplex.empty())
  {
    return false;
  }
  cluster.Add(cluster.Solid.Split(simplex));
  return true;
}

/// Adds the movable corners of a face outside the cluster. Returns whether there are any.
bool AddCorners(PointCluster& cluster, const StarFace& face)
{
  bool isAny = false;
  for (const int point : face)
  {
    if (cluster.IsMovable(point))
    {
      cluster.Add(point);
      isAny = true;
    }
  }
  return isAny;
}

/// Adds points of the faces that a position does not see. Returns false if there is none to add.
bool AddUnseen(
  PointCluster& cluster, const std::vector<StarFace>& faces, const Eigen::RowVector3d& position)
{
  bool isGrown = false;
  for (const StarFace& face : faces)
  {
    if (!cluster.IsOutside(face) || SeesFace(cluster.Solid.Points, face, position))
    {
      continue;
    }
    const bool isMovable = AddCorners(cluster, face);
    // A split changes the faces around it, so there is at most one, and only if nothing else helps.
    isGrown = isGrown || isMovable || AddSplit(cluster, face);
  }
  return isGrown;
}

/// The points of a growing cluster that have neighbours outside, in the order in which they joined.
class Rim
{
public:
  explicit Rim(const PointCluster& cluster)
    : Cluster(cluster)
  {
  }

  /// Brings the rim up to date and returns it. Points that have left it do not come back, since the
  /// cluster only grows, and new points in its surroundings belong to it.
  const std::vector<int>& Update()
  {
    const std::vector<int>& all = this->Cluster.Points();
    this->Points.insert(
      this->Points.end(), all.begin() + static_cast<std::ptrdiff_t>(this->Joined), all.end());
    this->Joined = all.size();
    this->Points.erase(std::remove_if(this->Points.begin(), this->Points.end(),
                         [&](int point) { return this->Cluster.IsSurrounded(point); }),
      this->Points.end());
    return this->Points;
  }

private:
  const PointCluster& Cluster;
  std::vector<int> Points;
  std::size_t Joined = 0; ///< number of the cluster's points that are known
};

/// Returns the edges outside the cluster that are opposite to points of its rim, and whether it
/// runs around each of them.
std::map<std::pair<int, int>, bool> FindEdgesOutside(
  const PointCluster& cluster, const std::vector<int>& rim)
{
  std::map<std::pair<int, int>, bool> edges;
  for (const int point : rim)
  {
    for (const StarFace& face : cluster.FindFacesAround(point))
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = face[k], b = face[(k + 1) % 3], c = face[(k + 2) % 3];
        if (!cluster.IsIn(a) && !cluster.IsIn(b))
        {
          const auto edge = edges.emplace(std::minmax(a, b), true).first;
          edge->second = edge->second && cluster.IsIn(c);
        }
      }
    }
  }
  return edges;
}

/// Closes holes of the cluster that run around a single edge: one of its ends, or a new point in
/// it, joins the cluster. Returns whether there are any.
bool CloseHoles(PointCluster& cluster, const std::vector<int>& rim)
{
  bool isAny = false;
  for (const auto& [edge, isAround] : FindEdgesOutside(cluster, rim))
  {
    const auto [a, b] = edge;
    if (!isAround || cluster.IsIn(a) || cluster.IsIn(b))
    {
      continue;
    }
    if (cluster.IsMovable(a) || cluster.IsMovable(b))
    {
      cluster.Add(cluster.IsMovable(a) ? a : b);
      isAny = true;
    }
    else if (cluster.CanSplit({ a, b }))
    {
      cluster.Add(cluster.Solid.Split({ a, b }));
      isAny = true;
    }
  }
  return isAny;
}

/// Adds the movable points around the points of the rim. Returns whether there are any.
bool AddAround(PointCluster& cluster, const std::vector<int>& rim)
{
  bool isAny = false;
  for (const int point : rim)
  {
    for (const int other : cluster.FindNeighbours(point))
    {
      if (!cluster.IsIn(other) && cluster.IsMovable(other))
      {
        cluster.Add(other);
        isAny = true;
      }
    }
  }
  return isAny;
}

} // namespace

std::optional<Eigen::RowVector3d> GrowCluster(PointCluster& cluster)
{
  constexpr int slowSteps = 12;
  Rim rim(cluster);
  for (int step = 0;; ++step)
  {
    if (step > slowSteps)
    {
      AddAround(cluster, rim.Update());
    }
    const std::vector<int>& outermost = rim.Update();
    const std::vector<StarFace> faces = cluster.FindOuterFaces(outermost);
    const StarPlacement found = cluster.FindPlacement(faces, cluster.ComputeCentroid());
    if (!found.IsValid)
    {
      if (!AddUnseen(cluster, faces, found.Position))
      {
        return std::nullopt;
      }
      continue;
    }
    if (cluster.IsCollapsible() ||
      !(CloseHoles(cluster, outermost) || AddAround(cluster, outermost)))
    {
      return found.Position;
    }
  }
}

void AddRing(PointCluster& cluster)
{
  AddAround(cluster, Rim(cluster).Update());
}

} // namespace shape
