#include "Labels/Private/JunctionFit.h"

#include "Base/Parallel.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <numeric>
#include <set>
#include <unordered_set>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

constexpr int JunctionsAtOnce = 64;
/// The points of an interface that a plane is fitted to: closer ones have moved with the junction,
/// and a curved interface deviates from the plane farther away.
constexpr int FirstRing = 2, LastRing = 4;
constexpr std::size_t MinimumPoints = 6;
/// The weight of the squared distance from the given position, beside 1 for each plane.
constexpr double KeptShare = 0.02;

class JunctionFit
{
public:
  JunctionFit(const SurfaceNet& net, const Eigen::MatrixXd& points)
    : Net(net)
    , Points(points)
    , IsJunction(points.rows(), 0)
    , First(points.rows() + 1, 0)
    , Fans(net.Triangles.size())
  {
    for (const int point : net.JunctionPoints)
    {
      this->IsJunction[point] = 1;
    }
    for (const int point : net.Triangles.reshaped())
    {
      ++this->First[point + 1];
    }
    std::partial_sum(this->First.begin(), this->First.end(), this->First.begin());
    std::vector<int> next(this->First.begin(), this->First.end() - 1);
    for (int t = 0; t < static_cast<int>(net.Triangles.rows()); ++t)
    {
      for (const int point : Eigen::RowVector3i(net.Triangles.row(t)))
      {
        this->Fans[next[point]++] = t;
      }
    }
  }

  Eigen::RowVector3d Fit(int junction) const
  {
    const Eigen::Vector3d given = this->Points.row(junction);
    Eigen::Matrix3d sum = KeptShare * Eigen::Matrix3d::Identity();
    Eigen::Vector3d right = KeptShare * given;
    std::set<std::pair<int, int>> interfaces;
    for (int k = this->First[junction]; k < this->First[junction + 1]; ++k)
    {
      const Eigen::RowVector2i labels = this->Net.Regions.row(this->Fans[k]);
      if (!interfaces.insert({ labels(0), labels(1) }).second)
      {
        continue;
      }
      const std::vector<int> nearby = this->FindNearby(junction, labels);
      if (nearby.size() < MinimumPoints)
      {
        continue;
      }
      const Eigen::MatrixXd places = this->Points(nearby, Eigen::all);
      const Eigen::RowVector3d mean = places.colwise().mean();
      const Eigen::MatrixXd offsets = places.rowwise() - mean;
      const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(
        Eigen::Matrix3d(offsets.transpose() * offsets));
      const Eigen::Vector3d normal = axes.eigenvectors().col(0);
      sum += normal * normal.transpose();
      right += normal * normal.dot(mean.transpose());
    }
    return sum.ldlt().solve(right).transpose();
  }

private:
  /// The points inside the interface between two regions that are two to four edges away.
  std::vector<int> FindNearby(int junction, const Eigen::RowVector2i& labels) const
  {
    std::vector<int> ring = { junction }, nearby;
    std::unordered_set<int> seen = { junction };
    for (int distance = 1; distance <= LastRing; ++distance)
    {
      std::vector<int> next;
      for (const int point : ring)
      {
        for (int k = this->First[point]; k < this->First[point + 1]; ++k)
        {
          const int t = this->Fans[k];
          if (this->Net.Regions.row(t) != labels)
          {
            continue;
          }
          for (const int corner : Eigen::RowVector3i(this->Net.Triangles.row(t)))
          {
            if (!this->IsJunction[corner] && seen.insert(corner).second)
            {
              next.push_back(corner);
            }
          }
        }
      }
      if (distance >= FirstRing)
      {
        nearby.insert(nearby.end(), next.begin(), next.end());
      }
      ring = std::move(next);
    }
    return nearby;
  }

  const SurfaceNet& Net;
  const Eigen::MatrixXd& Points;
  std::vector<char> IsJunction;
  std::vector<int> First, Fans; ///< the triangles around each point
};

} // namespace

Eigen::MatrixXd FitJunctions(const SurfaceNet& net, const Eigen::MatrixXd& points)
{
  const JunctionFit fit(net, points);
  Eigen::MatrixXd fitted(net.JunctionPoints.size(), 3);
  ParallelFor(static_cast<int>(fitted.rows()), JunctionsAtOnce,
    [&](int begin, int end)
    {
      for (int i = begin; i < end; ++i)
      {
        fitted.row(i) = fit.Fit(net.JunctionPoints[i]);
      }
    });
  return fitted;
}

} // namespace shape
