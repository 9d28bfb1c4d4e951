#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

// Surfaces with known correspondence.
namespace shapetest
{

/// Returns a sphere with five bumps of different height, without mirror symmetry. The triangles are
/// those of an icosphere that is rotated by `turn` first; the shape does not depend on it.
inline shape::Mesh BumpySphere(int level, const Eigen::Matrix3d& turn)
{
  shape::Mesh mesh = Icosphere(level);
  mesh.Points = mesh.Points * turn.transpose();
  Eigen::Matrix<double, 5, 3> directions;
  directions << 1, 0, 0, -0.4, 0.9, 0, -0.5, -0.6, 0.6, 0.1, -0.5, -0.8, 0.2, 0.3, 0.9;
  const double heights[5] = { 1.4, 1.1, 0.9, 1.2, 0.7 };
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const Eigen::RowVector3d direction = mesh.Points.row(i);
    for (int k = 0; k < 5; ++k)
    {
      const double cosine = direction.dot(directions.row(k).normalized());
      mesh.Points.row(i) += heights[k] * std::exp(14.0 * (cosine - 1.0)) * direction;
    }
  }
  return mesh;
}

/// Returns a smooth shape without symmetry, from a mesh of the unit sphere.
inline shape::Mesh Pebble(shape::Mesh mesh)
{
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const double x = mesh.Points(i, 0), y = mesh.Points(i, 1), z = mesh.Points(i, 2);
    mesh.Points.row(i) *= 1.0 + 0.2 * std::sin(3.0 * x + y) - 0.15 * std::cos(2.0 * z - x);
    mesh.Points(i, 0) *= 1.4;
  }
  return mesh;
}

inline Eigen::Matrix3d Rotation(double angle, const Eigen::Vector3d& axis)
{
  return Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
}

/// A surface with its points and triangles in another order.
struct Renumbered
{
  shape::Mesh Mesh;
  Eigen::VectorXi NewOf; ///< n: the new index of each old point
};

inline Renumbered Renumber(const shape::Mesh& mesh, unsigned int seed)
{
  std::mt19937 random(seed);
  const auto order = [&](Eigen::Index count)
  {
    std::vector<int> list(count);
    std::iota(list.begin(), list.end(), 0);
    std::shuffle(list.begin(), list.end(), random);
    return list;
  };
  Renumbered result;
  const std::vector<int> points = order(mesh.Points.rows());
  const std::vector<int> triangles = order(mesh.Triangles.rows());
  result.Mesh = { mesh.Points(points, Eigen::all), mesh.Triangles(triangles, Eigen::all) };
  result.NewOf.resize(mesh.Points.rows());
  for (int k = 0; k < static_cast<int>(points.size()); ++k)
  {
    result.NewOf(points[k]) = k;
  }
  result.Mesh.Triangles = result.Mesh.Triangles.unaryExpr([&](int i) { return result.NewOf(i); });
  return result;
}

/// Returns the mirror image across x = 0, which faces outwards if the mesh does.
inline shape::Mesh Mirrored(shape::Mesh mesh)
{
  mesh.Points.col(0) *= -1.0;
  mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
  return mesh;
}

/// The map of a surface to itself.
inline shape::SurfacePoints IdentityMap(const shape::Mesh& mesh)
{
  return shape::MakeSurfacePointsAtVertices(
    Eigen::VectorXi::LinSpaced(mesh.Points.rows(), 0, static_cast<int>(mesh.Points.rows()) - 1),
    mesh);
}

/// Positions on a surface to which a map takes points.
inline Eigen::MatrixXd PositionsOn(const shape::SurfacePoints& map, const shape::Mesh& target)
{
  return shape::PullBack(map, target.Triangles, target.Points);
}

/// Returns the distance in space of each point's image from `wanted` (n x 3), divided by the
/// longest edge of the bounding box of `other`.
inline Eigen::VectorXd MapErrors(
  const shape::SurfacePoints& map, const shape::Mesh& other, const Eigen::MatrixXd& wanted)
{
  return (PositionsOn(map, other) - wanted).rowwise().norm() /
    shape::ComputeLongestBoxEdge(other.Points);
}

/// The root mean square distance from `truth`, after a rigid motion, divided by its size.
inline double DistanceFrom(const Eigen::MatrixXd& points, const shape::Mesh& truth)
{
  const Eigen::MatrixXd a = points.rowwise() - points.colwise().mean(),
                        b = truth.Points.rowwise() - truth.Points.colwise().mean();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(
    a.transpose() * b, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::MatrixXd turned = a * (svd.matrixU() * svd.matrixV().transpose());
  return std::sqrt((turned - b).rowwise().squaredNorm().mean()) /
    shape::ComputeLongestBoxEdge(truth.Points);
}

/// The part of a mesh above a height, and the original indices of its points.
struct Cut
{
  shape::Mesh Surface;
  std::vector<int> Points;
};

inline Cut Above(const shape::Mesh& mesh, double height)
{
  Cut cut;
  std::vector<int> kept, position(mesh.Points.rows(), -1);
  for (int t = 0; t < static_cast<int>(mesh.Triangles.rows()); ++t)
  {
    if (shape::GetCorners(mesh, t).col(2).mean() > height)
    {
      kept.push_back(t);
    }
  }
  cut.Surface.Triangles = mesh.Triangles(kept, Eigen::all);
  for (int& point : cut.Surface.Triangles.reshaped())
  {
    if (position[point] < 0)
    {
      position[point] = static_cast<int>(cut.Points.size());
      cut.Points.push_back(point);
    }
    point = position[point];
  }
  cut.Surface.Points = mesh.Points(cut.Points, Eigen::all);
  return cut;
}

} // namespace shapetest
