#include "Search/NearestSurfacePoints.h"

#include "Search/NearestRows.h"
#include "Search/TriangleWalk.h"

#include <vector>

namespace shape
{

SurfacePoints FindNearestSurfacePoints(const Eigen::MatrixXd& queries,
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& points, const Progress& progress)
{
  const TriangleFans fans(triangles, points.rows());
  std::vector<int> used;
  for (int i = 0; i < static_cast<int>(points.rows()); ++i)
  {
    if (fans.First[i] < fans.First[i + 1])
    {
      used.push_back(i);
    }
  }
  const Eigen::MatrixXd targets = points(used, Eigen::all);
  const Eigen::VectorXi nearest = FindNearestRows(queries, targets, progress.Part(0.0, 0.7));
  return WalkToPositions(
    queries, triangles, points, fans, [&](int i) { return used[nearest(i)]; },
    progress.Part(0.7, 1.0));
}

} // namespace shape
