#include "Search/NearestSurfacePoints.h"

#include "Base/Parallel.h"
#include "Search/TriangleWalk.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace shape
{

Eigen::VectorXi FindNearestRows(
  const Eigen::MatrixXd& queries, const Eigen::MatrixXd& rows, const Progress& progress)
{
  // |q - r|^2 = |q|^2 - 2 (q r - |r|^2 / 2): the nearest r maximises the bracket.
  const Eigen::MatrixXf targets = rows.cast<float>();
  const Eigen::VectorXf halves = 0.5F * targets.rowwise().squaredNorm();
  constexpr int grain = 128, block = 1024; // queries and rows whose products stay in the cache
  const BlasThreads one(false);
  Eigen::VectorXi nearest(queries.rows());
  ParallelFor(
    static_cast<int>(queries.rows()), grain,
    [&](int begin, int end)
    {
      const Eigen::MatrixXf own = queries.middleRows(begin, end - begin).transpose().cast<float>();
      Eigen::VectorXf best =
        Eigen::VectorXf::Constant(end - begin, -std::numeric_limits<float>::infinity());
      for (Eigen::Index first = 0; first < rows.rows(); first += block)
      {
        const Eigen::Index count = std::min<Eigen::Index>(block, rows.rows() - first);
        Eigen::MatrixXf products = targets.middleRows(first, count) * own;
        products.colwise() -= halves.segment(first, count);
        for (int i = 0; i < end - begin; ++i)
        {
          // The index is computed only for a new maximum, because finding it takes longer.
          if (products.col(i).maxCoeff() > best(i))
          {
            Eigen::Index at = 0;
            best(i) = products.col(i).maxCoeff(&at);
            nearest(begin + i) = static_cast<int>(first + at);
          }
        }
      }
    },
    progress);
  return nearest;
}

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
