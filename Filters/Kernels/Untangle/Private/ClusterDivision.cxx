#include "Untangle/Private/ClusterDivision.h"

#include <map>
#include <utility>

namespace shape
{
namespace
{

/// Returns the point of the cluster with the most faces that a position does not see, or -1.
int FindHinderer(const PointCluster& cluster, const std::vector<StarFace>& faces,
  const Eigen::RowVector3d& position)
{
  std::map<int, int> counts;
  for (const StarFace& face : faces)
  {
    if (!SeesFace(cluster.Solid.Points, face, position))
    {
      for (const int point : face)
      {
        counts[point] += cluster.IsIn(point);
      }
    }
  }
  int best = -1, most = 0;
  for (const auto& [point, count] : counts)
  {
    if (count > most)
    {
      best = point;
      most = count;
    }
  }
  return best;
}

/// Returns the part that grows from a point until it can move, with where it can.
ClusterDivision GrowPart(PointCluster& cluster, int first)
{
  ClusterDivision grown{ { first }, {} };
  while (2 * grown.Part.size() <= cluster.Points().size())
  {
    const std::vector<StarFace> faces = cluster.FindFacesAroundPart(grown.Part);
    grown.Placement = cluster.FindPlacement(faces, cluster.GetPosition());
    if (grown.Placement.IsValid)
    {
      return grown;
    }
    const int next = FindHinderer(cluster, faces, grown.Placement.Position);
    if (next < 0)
    {
      break;
    }
    grown.Part.push_back(next);
  }
  return {};
}

} // namespace

ClusterDivision FindDivision(PointCluster& cluster)
{
  ClusterDivision best;
  for (const int first : cluster.Points())
  {
    if (cluster.FindOuterFacesAround(first).empty())
    {
      continue;
    }
    ClusterDivision grown = GrowPart(cluster, first);
    if (grown.Placement.IsValid && grown.Placement.Clearance > best.Placement.Clearance &&
      cluster.IsDivision(grown.Part))
    {
      best = std::move(grown);
    }
    if (best.Placement.IsComfortable())
    {
      break;
    }
  }
  return best;
}

} // namespace shape
