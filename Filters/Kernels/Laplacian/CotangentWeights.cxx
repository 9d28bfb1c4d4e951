#include "Laplacian/CotangentWeights.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace shape
{
namespace
{

/// Minimum excess of the sum of two edges over the third, relative to the longest edge.
constexpr double Slack = 1e-6;

std::array<double, 3> Mollified(std::array<double, 3> sides)
{
  // Sharp and Crane 2020, section 4.5, applied to one triangle.
  const double longest = *std::max_element(sides.begin(), sides.end());
  const double excess = sides[0] + sides[1] + sides[2] - 2.0 * longest;
  const double raise = std::max(0.0, Slack * longest - excess);
  for (double& side : sides)
  {
    side += raise;
  }
  return sides;
}

/// Heron's formula in Kahan's form, accurate for needles. Edges in any order.
double AreaOfSides(std::array<double, 3> sides)
{
  std::sort(sides.begin(), sides.end());
  const auto [c, b, a] = sides;
  return 0.25 *
    std::sqrt(std::max(0.0, (a + (b + c)) * (c - (a - b)) * (c + (a - b)) * (a + (b - c))));
}

} // namespace

TriangleAngles ComputeTriangleAngles(const Mesh& mesh)
{
  Eigen::MatrixXd sides(mesh.Triangles.rows(), 3);
  for (Eigen::Index t = 0; t < sides.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      sides(t, corner) = (mesh.Points.row(mesh.Triangles(t, (corner + 1) % 3)) -
        mesh.Points.row(mesh.Triangles(t, (corner + 2) % 3)))
                           .norm();
    }
  }
  return ComputeAnglesFromLengths(sides);
}

TriangleAngles ComputeAnglesFromLengths(const Eigen::MatrixXd& lengths)
{
  const Eigen::Index count = lengths.rows();
  TriangleAngles angles{ Eigen::MatrixXd(count, 3), Eigen::VectorXd(count) };
  for (Eigen::Index t = 0; t < count; ++t)
  {
    const std::array<double, 3> sides = Mollified({ lengths(t, 0), lengths(t, 1), lengths(t, 2) });
    const double area = AreaOfSides(sides);
    angles.Areas(t) = area;
    for (int corner = 0; corner < 3; ++corner)
    {
      const double a = sides[corner];
      const double b = sides[(corner + 1) % 3];
      const double c = sides[(corner + 2) % 3];
      // cot = (b^2 + c^2 - a^2) / (4 area), with c^2 - a^2 as a product, which does not cancel. A
      // triangle without extent is treated as equilateral.
      angles.Cotangents(t, corner) =
        area > 0.0 ? (b * b + (c - a) * (c + a)) / (4.0 * area) : 1.0 / std::sqrt(3.0);
    }
  }
  return angles;
}

Eigen::SparseMatrix<double> BuildCotangentStiffness(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& cotangents, Eigen::Index points)
{
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(12 * triangles.rows() + points);
  for (Eigen::Index i = 0; i < points; ++i)
  {
    // Points without a triangle have a diagonal entry, too.
    entries.emplace_back(i, i, 0.0);
  }
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      const int i = triangles(t, (corner + 1) % 3);
      const int j = triangles(t, (corner + 2) % 3);
      // Half the cotangent, for the edge opposite the corner, from each of its two triangles.
      const double weight = 0.5 * cotangents(t, corner);
      entries.emplace_back(i, j, -weight);
      entries.emplace_back(j, i, -weight);
      entries.emplace_back(i, i, weight);
      entries.emplace_back(j, j, weight);
    }
  }
  Eigen::SparseMatrix<double> stiffness(points, points);
  stiffness.setFromTriplets(entries.begin(), entries.end());
  return stiffness;
}

Eigen::VectorXd ComputeLumpedMasses(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& areas, Eigen::Index points)
{
  Eigen::VectorXd masses = Eigen::VectorXd::Zero(points);
  for (Eigen::Index t = 0; t < areas.size(); ++t)
  {
    for (const int point : triangles.row(t))
    {
      masses(point) += areas(t) / 3.0;
    }
  }
  return masses;
}

Eigen::SparseMatrix<double> BuildPositiveStiffness(
  const Eigen::SparseMatrix<double>& stiffness, double minimum)
{
  Eigen::SparseMatrix<double> positive = stiffness;
  for (int column = 0; column < positive.outerSize(); ++column)
  {
    double sum = 0.0;
    for (Eigen::SparseMatrix<double>::InnerIterator entry(positive, column); entry; ++entry)
    {
      if (entry.row() != column)
      {
        entry.valueRef() = std::min(entry.value(), -minimum);
        sum -= entry.value();
      }
    }
    positive.coeffRef(column, column) = sum;
  }
  return positive;
}

} // namespace shape
