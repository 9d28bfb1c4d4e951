#include "Correspondence/NearestPlaces.h"

#include "Core/Parallel.h"
#include "Correspondence/NearestRows.h"
#include "Surface/TriangleWalk.h"

#include <vector>

namespace shape
{

PreciseMap NearestPlaces(const Eigen::MatrixXd& queries, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, const Progress& progress)
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
  const Eigen::VectorXi nearest = NearestRows(queries, targets, progress.Part(0.0, 0.7));
  const Eigen::MatrixXd columns = points.transpose();
  PreciseMap map{ Eigen::VectorXi(queries.rows()), Eigen::MatrixXd(queries.rows(), 3) };
  ParallelFor(
    static_cast<int>(queries.rows()), 256,
    [&](int begin, int end)
    {
      TriangleWalk walk(triangles, columns, fans);
      for (int i = begin; i < end; ++i)
      {
        walk.Go(used[nearest(i)], queries.row(i));
        map.Triangles(i) = walk.Triangle;
        map.Barycentrics.row(i) = walk.Barycentric;
      }
    },
    progress.Part(0.7, 1.0));
  return map;
}

} // namespace shape
