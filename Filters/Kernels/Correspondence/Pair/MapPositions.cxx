#include "Correspondence/Pair/MapPositions.h"

#include "Search/TriangleWalk.h"

namespace shape
{

SurfacePoints MapPositions(const SurfacePoints& positions, const Eigen::MatrixXi& triangles,
  const SurfacePoints& images, const Surface& target, const Progress& progress)
{
  const Eigen::MatrixXd towards =
    PullBack(positions, triangles, PullBack(images, target.Triangles(), target.Points()));
  const Eigen::VectorXi nearest = FindNearestCorners(positions, triangles),
                        begins = FindNearestCorners(images, target.Triangles());
  return WalkToPositions(
    towards, target.Triangles(), target.Points(),
    TriangleFans(target.Triangles(), target.Points().rows()),
    [&](int i) { return begins(nearest(i)); }, progress);
}

} // namespace shape
