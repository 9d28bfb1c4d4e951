#include "Correspondence/CommonBase/Private/PositionOrder.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace shape
{

PositionOrder::PositionOrder(const Surface& given)
  : Points(given.Points().rows())
  , Triangles(given.Triangles().rows())
  , PointOf(given.Points().rows())
{
  std::iota(this->Points.begin(), this->Points.end(), 0);
  std::stable_sort(this->Points.begin(), this->Points.end(),
    [&](int one, int other)
    {
      const auto p = given.Points().row(one), q = given.Points().row(other);
      return std::lexicographical_compare(p.begin(), p.end(), q.begin(), q.end());
    });
  for (std::size_t i = 0; i < this->Points.size(); ++i)
  {
    this->PointOf[this->Points[i]] = static_cast<int>(i);
  }
  const auto sorted = [&](int triangle)
  {
    std::array<int, 3> corners{};
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->PointOf[given.Triangles()(triangle, k)];
    }
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::iota(this->Triangles.begin(), this->Triangles.end(), 0);
  std::stable_sort(this->Triangles.begin(), this->Triangles.end(),
    [&](int one, int other) { return sorted(one) < sorted(other); });
  Eigen::MatrixXi triangles = given.Triangles()(this->Triangles, Eigen::all);
  for (int& corner : triangles.reshaped())
  {
    corner = this->PointOf[corner];
  }
  this->Shape =
    Surface(Eigen::MatrixXd(given.Points()(this->Points, Eigen::all)), std::move(triangles));
}

Eigen::VectorXi AsGiven(const Eigen::VectorXi& values, const PositionOrder& order)
{
  return values(order.PointOf);
}

SurfacePoints AsGiven(const SurfacePoints& map, const PositionOrder& from, const PositionOrder& to)
{
  SurfacePoints given{ map.Triangles(from.PointOf), map.Barycentrics(from.PointOf, Eigen::all) };
  for (int& triangle : given.Triangles)
  {
    triangle = to.Triangles[triangle];
  }
  return given;
}

} // namespace shape
