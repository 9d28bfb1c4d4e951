#include "Hex/Polycube/Private/TetrahedralWalk.h"

#include <Eigen/LU>

#include <algorithm>
#include <utility>

namespace shape
{
namespace
{

/// How far outside of a tetrahedron a place still counts as in it, for rounding.
constexpr double Rounding = 1e-9;

} // namespace

TetrahedralWalk::TetrahedralWalk(const Eigen::MatrixXd& points, const Eigen::MatrixXi& tetrahedra)
  : Points(points)
  , Tetrahedra(tetrahedra)
  , Neighbours(tetrahedra.rows(), { -1, -1, -1, -1 })
{
  using Face = std::pair<std::array<int, 3>, std::array<int, 2>>;
  std::vector<Face> faces;
  for (int t = 0; t < tetrahedra.rows(); ++t)
  {
    for (int k = 0; k < 4; ++k)
    {
      std::array<int, 3> corners = { tetrahedra(t, (k + 1) % 4), tetrahedra(t, (k + 2) % 4),
        tetrahedra(t, (k + 3) % 4) };
      std::sort(corners.begin(), corners.end());
      faces.push_back({ corners, { t, k } });
    }
  }
  std::sort(faces.begin(), faces.end());
  for (std::size_t i = 0; i + 1 < faces.size(); ++i)
  {
    if (faces[i].first == faces[i + 1].first)
    {
      const auto [t, k] = faces[i].second;
      const auto [u, l] = faces[i + 1].second;
      this->Neighbours[t][k] = u;
      this->Neighbours[u][l] = t;
    }
  }
}

Eigen::Vector4d TetrahedralWalk::Weights(int tetrahedron, const Eigen::Vector3d& position) const
{
  const auto c = this->Tetrahedra.row(tetrahedron);
  const Eigen::Vector3d origin = this->Points.row(c(0)).transpose();
  Eigen::Matrix3d edges;
  for (int k = 0; k < 3; ++k)
  {
    edges.col(k) = this->Points.row(c(k + 1)).transpose() - origin;
  }
  Eigen::Vector4d weights;
  weights.tail<3>() = edges.inverse() * (position - origin);
  weights(0) = 1.0 - weights.tail<3>().sum();
  return weights;
}

TetrahedralWalk::Position TetrahedralWalk::Go(
  int tetrahedron, const Eigen::Vector3d& from, const Eigen::Vector3d& to) const
{
  int entered = -2; // nowhere, which is not the outside
  // A straight line meets each tetrahedron of its sheet once; rounding may add a few.
  for (Eigen::Index step = 0; step <= this->Tetrahedra.rows(); ++step)
  {
    const Eigen::Vector4d end = this->Weights(tetrahedron, to);
    const Eigen::Vector4d begin = this->Weights(tetrahedron, from);
    int exit = -1;
    double minimum = 2.0;
    for (int k = 0; k < 4; ++k)
    {
      if (end(k) < -Rounding && this->Neighbours[tetrahedron][k] != entered)
      {
        const double share = begin(k) / (begin(k) - end(k));
        if (end(k) < begin(k) && share < minimum)
        {
          minimum = share;
          exit = k;
        }
      }
    }
    const bool arrived = exit < 0;
    const int next = arrived ? -1 : this->Neighbours[tetrahedron][exit];
    if (next < 0)
    {
      Eigen::Vector4d weights =
        arrived ? end : Eigen::Vector4d(begin + std::clamp(minimum, 0.0, 1.0) * (end - begin));
      weights = weights.cwiseMax(0.0);
      return { tetrahedron, weights / weights.sum(), arrived, exit };
    }
    entered = tetrahedron;
    tetrahedron = next;
  }
  return { tetrahedron, Eigen::Vector4d::Constant(0.25), false, -1 };
}

} // namespace shape
