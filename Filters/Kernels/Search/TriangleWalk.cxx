#include "Search/TriangleWalk.h"

#include "Base/Parallel.h"
#include "Search/Private/TriangleProjection.h"

#include <algorithm>
#include <limits>

namespace shape
{

TriangleFans::TriangleFans(const Eigen::MatrixXi& triangles, Eigen::Index points)
  : First(points + 1, 0)
  , Triangles(triangles.size())
{
  for (const int point : triangles.reshaped())
  {
    ++this->First[point + 1];
  }
  for (Eigen::Index i = 0; i < points; ++i)
  {
    this->First[i + 1] += this->First[i];
  }
  std::vector<int> next = this->First;
  for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      this->Triangles[next[triangles(t, k)]++] = t;
    }
  }
}

void TriangleWalk::Go(int point, const Eigen::VectorXd& towards)
{
  this->Squared = std::numeric_limits<double>::infinity();
  bool nearer = this->Look(point, towards);
  while (nearer)
  {
    nearer = false;
    const Eigen::RowVector3i corners = this->Triangles.row(this->Triangle);
    for (const int corner : corners)
    {
      // The fans of all three corners: the triangles that share a corner with this one.
      nearer = this->Look(corner, towards) || nearer;
    }
  }
}

/// Tests the triangles around a point; returns whether one is closer.
bool TriangleWalk::Look(int point, const Eigen::VectorXd& towards)
{
  constexpr double rounding = 1e-12; // otherwise a walk could cycle between equally near points
  bool nearer = false;
  for (int i = this->Fans.First[point]; i < this->Fans.First[point + 1]; ++i)
  {
    const int t = this->Fans.Triangles[i];
    const auto p = this->Points.col(this->Triangles(t, 0));
    Eigen::VectorXd &e = this->First, &f = this->Second, &w = this->Way;
    e = this->Points.col(this->Triangles(t, 1)) - p;
    f = this->Points.col(this->Triangles(t, 2)) - p;
    w = towards - p;
    const double a = e.squaredNorm(), b = e.dot(f), c = f.squaredNorm(), u = w.dot(e), v = w.dot(f);
    const auto [x, y] = ProjectOntoTriangle(a, b, c, u, v);
    // Rounding must not make it negative, or the walk would never end.
    const double squared =
      std::max(0.0, w.squaredNorm() + x * (x * a + 2.0 * y * b - 2.0 * u) + y * (y * c - 2.0 * v));
    if (squared < this->Squared * (1.0 - rounding))
    {
      this->Squared = squared;
      this->Triangle = t;
      this->Barycentric << std::max(0.0, 1.0 - x - y), x, y;
      nearer = true;
    }
  }
  return nearer;
}

SurfacePoints WalkToPositions(const Eigen::MatrixXd& positions, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, const TriangleFans& fans, const std::function<int(int)>& begin,
  const Progress& progress)
{
  constexpr int grain = 256;
  const Eigen::MatrixXd columns = points.transpose();
  SurfacePoints map{ Eigen::VectorXi(positions.rows()), Eigen::MatrixXd(positions.rows(), 3) };
  ParallelFor(
    static_cast<int>(positions.rows()), grain,
    [&](int first, int last)
    {
      TriangleWalk walk(triangles, columns, fans);
      for (int i = first; i < last; ++i)
      {
        walk.Go(begin(i), positions.row(i).transpose());
        map.Triangles(i) = walk.Triangle;
        map.Barycentrics.row(i) = walk.Barycentric;
      }
    },
    progress);
  return map;
}

} // namespace shape
