#include "Fill/LoopNormals.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// Normals of points, areas around them and their rings, found where they are asked for.
class Neighbourhoods
{
public:
  Neighbourhoods(const Mesh& surface, const TriangleFans& fans)
    : Surface(surface)
    , Fans(fans)
  {
  }

  /// The sum of the area vectors of the triangles around a point, twice.
  const RowVector3d& AreaVector(int point)
  {
    const auto [position, isNew] = this->Vectors.try_emplace(point, RowVector3d::Zero());
    if (isNew)
    {
      for (int i = this->Fans.First[point]; i < this->Fans.First[point + 1]; ++i)
      {
        const Eigen::Matrix3d corners = GetCorners(this->Surface, this->Fans.Triangles[i]);
        const RowVector3d first = corners.row(1) - corners.row(0);
        const RowVector3d second = corners.row(2) - corners.row(0);
        position->second += first.cross(second);
      }
    }
    return position->second;
  }

  /// The points around one, it among them, in order of number: two rings at least, and more where
  /// triangles are thin beside it, as far as two edges of triangles of even sides reach.
  std::vector<int> Around(int point)
  {
    constexpr int maximum = 5; // rings
    constexpr double reach = 2.0, limit = 2.5;
    std::vector<int> found = this->Widened(this->Widened({ point }));
    double areas = 0.0, weighted = 0.0;
    for (const int near : found)
    {
      const double area = this->AreaVector(near).norm() / this->Valence(near);
      areas += area;
      weighted += area * std::sqrt(2.0 / std::sqrt(3.0) * area); // of an even triangle's side
    }
    const double side = areas > 0.0 ? weighted / areas : 0.0;
    const auto distance = [&](int near)
    { return (this->Surface.Points.row(near) - this->Surface.Points.row(point)).norm(); };
    for (int ring = 2; ring < maximum &&
         std::none_of(
           found.begin(), found.end(), [&](int near) { return distance(near) >= reach * side; });
         ++ring)
    {
      found = this->Widened(found);
    }
    std::vector<int> near;
    std::copy_if(found.begin(), found.end(), std::back_inserter(near),
      [&](int other) { return distance(other) <= limit * side; });
    return near;
  }

private:
  /// Points and those that triangles join to them.
  std::vector<int> Widened(const std::vector<int>& points) const
  {
    std::vector<int> more = points;
    for (const int near : points)
    {
      for (int i = this->Fans.First[near]; i < this->Fans.First[near + 1]; ++i)
      {
        const auto corners = this->Surface.Triangles.row(this->Fans.Triangles[i]);
        more.insert(more.end(), corners.begin(), corners.end());
      }
    }
    std::sort(more.begin(), more.end());
    more.erase(std::unique(more.begin(), more.end()), more.end());
    return more;
  }

  int Valence(int point) const
  {
    return std::max(1, this->Fans.First[point + 1] - this->Fans.First[point]);
  }

  const Mesh& Surface;
  const TriangleFans& Fans;
  std::map<int, RowVector3d> Vectors;
};

/// The slopes (x, y) at the origin of the paraboloid that fits places (n x 3) best, the differences
/// in z times their weights.
Eigen::RowVector2d SlopesOfParaboloid(
  const Eigen::MatrixXd& positions, const Eigen::VectorXd& weights)
{
  const double size = positions.leftCols<2>().rowwise().norm().mean();
  if (!(size > 0.0))
  {
    return Eigen::RowVector2d::Zero();
  }
  const Eigen::ArrayXd x = positions.col(0) / size, y = positions.col(1) / size;
  Eigen::MatrixXd terms(positions.rows(), 6);
  terms << x, y, 0.5 * x * x, x * y, 0.5 * y * y, Eigen::ArrayXd::Ones(positions.rows());
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> fit;
  fit.setThreshold(1e-3);
  fit.compute(weights.asDiagonal() * terms);
  return fit.solve(weights.cwiseProduct(positions.col(2)) / size).head<2>().transpose();
}

RowVector3d LoopNormal(const Mesh& surface, Neighbourhoods& around, int point)
{
  const RowVector3d mean = around.AreaVector(point).stableNormalized();
  std::vector<int> ring;
  constexpr double facing = 0.3; // cosine
  for (const int near : around.Around(point))
  {
    if (around.AreaVector(near).stableNormalized().dot(mean) > facing)
    {
      ring.push_back(near);
    }
  }
  constexpr std::size_t few = 7;
  if (ring.size() < few)
  {
    return mean;
  }
  Eigen::MatrixXd ways(ring.size(), 3);
  Eigen::VectorXd areas(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    ways.row(row) = surface.Points.row(ring[i]) - surface.Points.row(point);
    areas(row) = around.AreaVector(ring[i]).norm();
  }
  areas = areas.cwiseMax(1e-3 * areas.mean()) / areas.mean();
  RowVector3d normal = mean;
  for (int round = 0; round < 3; ++round)
  {
    Eigen::Matrix3d frame; // columns
    frame.col(2) = normal;
    frame.col(0) = normal.unitOrthogonal();
    frame.col(1) = frame.col(2).cross(frame.col(0));
    const Eigen::RowVector2d slopes = SlopesOfParaboloid(ways * frame, areas);
    normal = (normal - slopes * frame.leftCols<2>().transpose()).normalized();
  }
  constexpr double turned = 0.5; // cosine
  return normal.dot(mean) > turned ? normal : mean;
}

} // namespace

Eigen::MatrixXd ComputeBoundaryNormals(
  const Mesh& surface, const TriangleFans& fans, const std::vector<int>& points)
{
  Neighbourhoods around(surface, fans);
  Eigen::MatrixXd normals(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    normals.row(static_cast<Eigen::Index>(i)) = LoopNormal(surface, around, points[i]);
  }
  return normals;
}

} // namespace shape
