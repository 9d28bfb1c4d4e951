#include "Correspondence/Pair/CoarsePair.h"

#include "Correspondence/Pair/MapPositions.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Search/TriangleWalk.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace shape
{

CoarsePair::Side CoarsePair::Coarsen(
  const Surface& surface, const std::vector<int>& kept, int maximum, const Progress& progress)
{
  if (maximum <= 0 || surface.Points().rows() <= maximum)
  {
    return { surface, {} };
  }
  return { surface, CoarsenSurface(surface, maximum, kept, progress) };
}

CoarsePair::CoarsePair(Side a, Side b)
  : One(std::move(a))
  , Two(std::move(b))
{
}

CoarsePair::CoarsePair(const Surface& a, const Surface& b, const Landmarks& landmarks, int maximum,
  const Progress& progress)
  : One(Coarsen(a, PointsOf(landmarks, 0), maximum, progress.Part(0.0, 0.5)))
  , Two(Coarsen(b, PointsOf(landmarks, 1), maximum, progress.Part(0.5, 1.0)))
{
}

int CoarsePair::Side::CoarsePoint(int point) const
{
  if (!this->Coarse)
  {
    return point;
  }
  const std::vector<int>& points = this->Coarse->Points;
  // The points kept by coarsening are in increasing order.
  return static_cast<int>(std::lower_bound(points.begin(), points.end(), point) - points.begin());
}

Landmarks CoarsePair::OnCoarse(const Landmarks& landmarks) const
{
  Landmarks result;
  for (const auto& [a, b] : landmarks)
  {
    result.push_back({ this->One.CoarsePoint(a), this->Two.CoarsePoint(b) });
  }
  return result;
}

Landmarks CoarsePair::OnFine(const Landmarks& landmarks) const
{
  Landmarks result;
  for (const auto& [a, b] : landmarks)
  {
    result.push_back({ this->FinePointOfA(a), this->FinePointOfB(b) });
  }
  return result;
}

Eigen::MatrixXd CoarsePair::Side::Interpolate(const Eigen::MatrixXd& values) const
{
  return this->Coarse ? PullBack(this->Coarse->Positions, this->Coarse->Surface.Triangles(), values)
                      : values;
}

Eigen::MatrixXd CoarsePair::ValuesOnFineA(const Eigen::MatrixXd& values) const
{
  return this->One.Interpolate(values);
}

Eigen::MatrixXd CoarsePair::ValuesOnFineB(const Eigen::MatrixXd& values) const
{
  return this->Two.Interpolate(values);
}

/// First the fine points of `from`, then their images from the coarse to the fine version of `to`.
SurfacePoints CoarsePair::Lifted(
  const SurfacePoints& map, const Side& from, const Side& to, const Progress& progress)
{
  SurfacePoints result = from.Coarse
    ? MapPositions(from.Coarse->Positions, from.Coarse->Surface.Triangles(), map, to.Working(),
        progress.Part(0.0, 0.5))
    : map;
  return to.Coarse ? LocateOnFinerSurface(*to.Coarse, to.Fine, result, progress.Part(0.5, 1.0))
                   : result;
}

SurfaceMaps CoarsePair::OnFine(const SurfaceMaps& maps, const Progress& progress) const
{
  return { Lifted(maps.AToB, this->One, this->Two, progress.Part(0.0, 0.5)),
    Lifted(maps.BToA, this->Two, this->One, progress.Part(0.5, 1.0)) };
}

} // namespace shape
