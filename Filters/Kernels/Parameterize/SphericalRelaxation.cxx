#include "Parameterize/SphericalRelaxation.h"

#include "Parameterize/SphericalTriangles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>

namespace shape
{
namespace
{

double TriangleEnergy(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const StarTriangle& t)
{
  return (t.CotangentA * (c - b).squaredNorm() + t.CotangentB * (a - c).squaredNorm() +
           t.CotangentC * (b - a).squaredNorm() + t.AreaTerm) /
    ComputeSphericalDeterminant(a, b, c);
}

/// Returns the energy of a star with centre `a`; infinite if a triangle does not face outwards.
double Energy(
  const Eigen::MatrixXd& points, const Eigen::RowVector3d& a, const std::vector<StarTriangle>& star)
{
  double energy = 0.0;
  for (const StarTriangle& t : star)
  {
    const Eigen::RowVector3d b = points.row(t.B);
    const Eigen::RowVector3d c = points.row(t.C);
    if (!IsFacingOutwards(a, b, c))
    {
      return std::numeric_limits<double>::infinity();
    }
    energy += TriangleEnergy(a, b, c, t);
  }
  return energy;
}

/// Returns the Newton step in the tangent plane at `a` for the energy N / D summed over the star.
Eigen::RowVector3d NewtonStep(
  const Eigen::MatrixXd& points, const Eigen::RowVector3d& a, const std::vector<StarTriangle>& star)
{
  // E = N / D with a quadratic N and, in the tangent plane, a linear D. So E' = (N' - E D') / D and
  // E'' = (N'' - E' D'^T - D' E'^T) / D.
  Eigen::Matrix<double, 2, 3> tangents;
  tangents.row(0) = a.unitOrthogonal();
  tangents.row(1) = a.cross(Eigen::RowVector3d(tangents.row(0)));
  Eigen::Vector2d gradient = Eigen::Vector2d::Zero();
  Eigen::Matrix2d hessian = Eigen::Matrix2d::Zero();
  for (const StarTriangle& t : star)
  {
    const Eigen::RowVector3d b = points.row(t.B);
    const Eigen::RowVector3d c = points.row(t.C);
    const double determinant = ComputeSphericalDeterminant(a, b, c);
    const double energy = TriangleEnergy(a, b, c, t);
    const Eigen::Vector2d slopeN =
      tangents * (2.0 * (t.CotangentB * (a - c) + t.CotangentC * (a - b))).transpose();
    const Eigen::Vector2d slopeD = tangents * b.cross(c - b).transpose();
    const Eigen::Vector2d slope = (slopeN - energy * slopeD) / determinant;
    gradient += slope;
    hessian += (2.0 * (t.CotangentB + t.CotangentC) * Eigen::Matrix2d::Identity() -
                 slope * slopeD.transpose() - slopeD * slope.transpose()) /
      determinant;
  }
  const double trace = hessian.trace();
  // Almost singular by rounding: a step against the gradient.
  if (!(hessian.determinant() > 1e-12 * trace * trace) || !(trace > 0.0))
  {
    hessian = std::max(std::abs(trace), 1e-300) * Eigen::Matrix2d::Identity();
  }
  return -(hessian.inverse() * gradient).transpose() * tangents;
}

} // namespace

bool RelaxPoint(Eigen::MatrixXd& points, int point, const std::vector<StarTriangle>& star)
{
  const Eigen::RowVector3d position = points.row(point);
  const double energy = Energy(points, position, star);
  Eigen::RowVector3d step = NewtonStep(points, position, star);
  if (!step.allFinite() || !(energy < std::numeric_limits<double>::infinity()))
  {
    return false;
  }
  for (int halving = 0; halving < 10; ++halving, step *= 0.5)
  {
    const Eigen::RowVector3d moved = (position + step).normalized();
    // A gain near rounding would depend on the order of summation, and so on the number of threads.
    if (Energy(points, moved, star) < energy * (1.0 - 1e-13))
    {
      points.row(point) = moved;
      return true;
    }
  }
  return false;
}

void RelaxOnSphere(Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
  const Eigen::MatrixXd& cotangents, const std::vector<int>& movable, int sweeps,
  const Progress& progress)
{
  std::vector<int> starOf(points.rows(), -1);
  for (std::size_t i = 0; i < movable.size(); ++i)
  {
    starOf[movable[i]] = static_cast<int>(i);
  }
  std::vector<std::vector<StarTriangle>> stars(movable.size());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int a = 0; a < 3; ++a)
    {
      const int star = starOf[triangles(t, a)];
      if (star >= 0)
      {
        const int b = (a + 1) % 3;
        const int c = (a + 2) % 3;
        stars[star].push_back({ triangles(t, b), triangles(t, c), cotangents(t, a),
          cotangents(t, b), cotangents(t, c) });
      }
    }
  }
  bool moved = true;
  for (int sweep = 0; sweep < sweeps && moved; ++sweep)
  {
    moved = false;
    for (std::size_t i = 0; i < movable.size(); ++i)
    {
      moved = RelaxPoint(points, movable[i], stars[i]) || moved;
      if (i % 4096 == 0)
      {
        progress((sweep + static_cast<double>(i) / movable.size()) / sweeps);
      }
    }
  }
  progress(1.0);
}

} // namespace shape
