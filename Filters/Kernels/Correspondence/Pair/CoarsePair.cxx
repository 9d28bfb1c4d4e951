#include "Correspondence/Pair/CoarsePair.h"

#include "Search/TriangleWalk.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

std::optional<CoarseSurface> CoarsenIfLarge(const Surface& surface, const Landmarks& landmarks,
  int which, int maximum, const Progress& progress)
{
  if (maximum <= 0 || surface.Points().rows() <= maximum)
  {
    return {};
  }
  std::vector<int> kept;
  for (const auto& landmark : landmarks)
  {
    kept.push_back(landmark[which]);
  }
  return CoarsenSurface(surface, maximum, kept, progress);
}

/// The images of fine points on the coarse version of the other surface.
/// The map is extended linearly: the target of a fine point is the mean of the images of its coarse
/// triangle's corners. This mean may be off the surface, so it is reached by a walk on the
/// triangles, which starts at the image of the nearest coarse point and cannot jump to another
/// sheet.
SurfacePoints Interpolated(
  const SurfacePoints& map, const CoarseSurface& from, const Surface& to, const Progress& progress)
{
  const Eigen::MatrixXd towards =
    PullBack(from.Positions, from.Surface.Triangles(), PullBack(map, to.Triangles(), to.Points()));
  const Eigen::VectorXi nearest = FindNearestCorners(from.Positions, from.Surface.Triangles()),
                        begins = FindNearestCorners(map, to.Triangles());
  return WalkToPositions(
    towards, to.Triangles(), to.Points(), TriangleFans(to.Triangles(), to.Points().rows()),
    [&](int i) { return begins(nearest(i)); }, progress);
}

} // namespace

CoarsePair::CoarsePair(const Surface& a, const Surface& b, const Landmarks& landmarks, int maximum,
  const Progress& progress)
  : One{ a, CoarsenIfLarge(a, landmarks, 0, maximum, progress.Part(0.0, 0.5)) }
  , Two{ b, CoarsenIfLarge(b, landmarks, 1, maximum, progress.Part(0.5, 1.0)) }
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
  SurfacePoints result =
    from.Coarse ? Interpolated(map, *from.Coarse, to.Working(), progress.Part(0.0, 0.5)) : map;
  return to.Coarse ? LocateOnFinerSurface(*to.Coarse, to.Fine, result, progress.Part(0.5, 1.0))
                   : result;
}

SurfaceMaps CoarsePair::OnFine(const SurfaceMaps& maps, const Progress& progress) const
{
  return { Lifted(maps.AToB, this->One, this->Two, progress.Part(0.0, 0.5)),
    Lifted(maps.BToA, this->Two, this->One, progress.Part(0.5, 1.0)) };
}

} // namespace shape
