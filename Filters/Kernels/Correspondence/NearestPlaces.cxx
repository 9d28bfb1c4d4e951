#include "Correspondence/NearestPlaces.h"

#include "Core/Parallel.h"
#include "Correspondence/NearestRows.h"
#include "Correspondence/PlaceInTriangle.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace shape
{
namespace
{

/// The triangles around each point: those of point i from First[i] to First[i + 1].
struct Fans
{
  explicit Fans(const Eigen::MatrixXi& triangles, Eigen::Index points)
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

  std::vector<int> First, Triangles;
};

/// Goes from triangle to triangle towards a place.
class Walk
{
public:
  Walk(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& columns, const Fans& fans)
    : Triangles(triangles)
    , Points(columns)
    , Around(fans)
  {
  }

  void Begin() { this->Squared = std::numeric_limits<double>::infinity(); }

  /// Looks at the triangles around a point; whether one leads nearer.
  bool Look(int point, const Eigen::VectorXd& query)
  {
    bool nearer = false;
    for (int i = this->Around.First[point]; i < this->Around.First[point + 1]; ++i)
    {
      const int t = this->Around.Triangles[i];
      const auto p = this->Points.col(this->Triangles(t, 0));
      const Eigen::VectorXd e = this->Points.col(this->Triangles(t, 1)) - p,
                            f = this->Points.col(this->Triangles(t, 2)) - p, w = query - p;
      const double a = e.squaredNorm(), b = e.dot(f), c = f.squaredNorm(), u = w.dot(e),
                   v = w.dot(f);
      const auto [x, y] = PlaceInTriangle(a, b, c, u, v);
      // Rounding must not make it negative: the walk would never end.
      const double squared = std::max(
        0.0, w.squaredNorm() + x * (x * a + 2.0 * y * b - 2.0 * u) + y * (y * c - 2.0 * v));
      if (squared < this->Squared * (1.0 - Rounding))
      {
        this->Squared = squared;
        this->Triangle = t;
        this->Barycentric << std::max(0.0, 1.0 - x - y), x, y;
        nearer = true;
      }
    }
    return nearer;
  }

  int Triangle = -1;
  Eigen::RowVector3d Barycentric;

private:
  static constexpr double Rounding = 1e-12; // else a walk could go around places equally near
  const Eigen::MatrixXi& Triangles;
  const Eigen::MatrixXd& Points; ///< d x n
  const Fans& Around;
  double Squared = 0.0;
};

} // namespace

PreciseMap NearestPlaces(const Eigen::MatrixXd& queries, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& points, const Progress& progress)
{
  const Fans fans(triangles, points.rows());
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
      Walk walk(triangles, columns, fans);
      for (int i = begin; i < end; ++i)
      {
        const Eigen::VectorXd query = queries.row(i);
        walk.Begin();
        bool nearer = walk.Look(used[nearest(i)], query);
        while (nearer)
        {
          nearer = false;
          const Eigen::RowVector3i corners = triangles.row(walk.Triangle);
          for (const int corner : corners)
          {
            nearer = walk.Look(corner, query) || nearer;
          }
        }
        map.Triangles(i) = walk.Triangle;
        map.Barycentrics.row(i) = walk.Barycentric;
      }
    },
    progress.Part(0.7, 1.0));
  return map;
}

} // namespace shape
