#include "Geometry/Orientation.h"

#include "Geometry/TwoDoubles.h"

#include <array>
#include <cmath>

namespace shape
{
namespace
{

/// A number as the exact sum of at most N doubles that do not overlap, the smallest first.
template <int N>
struct Expansion
{
  std::array<double, N> Terms;
  int Count = 0;

  void Append(double term)
  {
    if (term != 0.0)
    {
      this->Terms[this->Count++] = term;
    }
  }
  int Sign() const
  {
    const double largest = this->Count > 0 ? this->Terms[this->Count - 1] : 0.0;
    return (largest > 0.0) - (largest < 0.0);
  }
};

/// a - b, exactly.
Expansion<2> Difference(double a, double b)
{
  const TwoDoubles sum = ExactSum(a, -b);
  Expansion<2> difference;
  difference.Append(sum.Low);
  difference.Append(sum.High);
  return difference;
}

/// a + sign * b.
template <int N, int M>
Expansion<N + M> Sum(const Expansion<N>& a, const Expansion<M>& b, double sign = 1.0)
{
  Expansion<N + M> sum;
  for (int i = 0; i < a.Count; ++i)
  {
    sum.Append(a.Terms[i]);
  }
  for (int j = 0; j < b.Count; ++j)
  {
    // Grow-Expansion of Shewchuk 1997: a term is added to an expansion from its smallest term on.
    double carried = sign * b.Terms[j];
    const int terms = sum.Count;
    sum.Count = 0;
    for (int i = 0; i < terms; ++i)
    {
      const TwoDoubles pair = ExactSum(carried, sum.Terms[i]);
      carried = pair.High;
      sum.Append(pair.Low);
    }
    sum.Append(carried);
  }
  return sum;
}

template <int N, int M>
Expansion<2 * N * M> Product(const Expansion<N>& a, const Expansion<M>& b)
{
  Expansion<2 * N * M> product;
  for (int i = 0; i < a.Count; ++i)
  {
    for (int j = 0; j < b.Count; ++j)
    {
      const TwoDoubles pair = ExactProduct(a.Terms[i], b.Terms[j]);
      for (double carried : { pair.Low, pair.High })
      {
        const int terms = product.Count;
        product.Count = 0;
        for (int k = 0; k < terms; ++k)
        {
          const TwoDoubles sum = ExactSum(carried, product.Terms[k]);
          carried = sum.High;
          product.Append(sum.Low);
        }
        product.Append(carried);
      }
    }
  }
  return product;
}

/// a d - b c.
Expansion<16> Minor(
  const Expansion<2>& a, const Expansion<2>& b, const Expansion<2>& c, const Expansion<2>& d)
{
  return Sum(Product(a, d), Product(b, c), -1.0);
}

int SignOf(double value)
{
  return (value > 0.0) - (value < 0.0);
}

} // namespace

// The determinant in doubles decides if it exceeds its error bound. Otherwise it is computed
// exactly with expansions (Shewchuk 1997).
int EvaluateOrientation(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b,
  const Eigen::RowVector3d& c, const Eigen::RowVector3d& d)
{
  const Eigen::RowVector3d u = b - a, v = c - a, w = d - a;
  const double xy = u(0) * v(1), yx = u(1) * v(0);
  const double yz = u(1) * v(2), zy = u(2) * v(1);
  const double zx = u(2) * v(0), xz = u(0) * v(2);
  const double value = (yz - zy) * w(0) + (zx - xz) * w(1) + (xy - yx) * w(2);
  const double size = (std::abs(yz) + std::abs(zy)) * std::abs(w(0)) +
    (std::abs(zx) + std::abs(xz)) * std::abs(w(1)) + (std::abs(xy) + std::abs(yx)) * std::abs(w(2));
  // Shewchuk's bound for this expression, 7.77e-16, rounded up.
  if (std::abs(value) > 8e-16 * size)
  {
    return SignOf(value);
  }
  std::array<Expansion<2>, 3> p, q, r;
  for (int k = 0; k < 3; ++k)
  {
    p[k] = Difference(b(k), a(k));
    q[k] = Difference(c(k), a(k));
    r[k] = Difference(d(k), a(k));
  }
  const auto x = Product(Minor(p[1], p[2], q[1], q[2]), r[0]);
  const auto y = Product(Minor(p[2], p[0], q[2], q[0]), r[1]);
  const auto z = Product(Minor(p[0], p[1], q[0], q[1]), r[2]);
  return Sum(Sum(x, y), z).Sign();
}

int EvaluateOrientation(
  const Eigen::RowVector2d& a, const Eigen::RowVector2d& b, const Eigen::RowVector2d& c)
{
  const Eigen::RowVector2d u = b - a, v = c - a;
  const double value = u(0) * v(1) - u(1) * v(0);
  const double size = std::abs(u(0) * v(1)) + std::abs(u(1) * v(0));
  // Shewchuk's bound for this expression, 3.33e-16, rounded up.
  if (std::abs(value) > 4e-16 * size)
  {
    return SignOf(value);
  }
  return Minor(
    Difference(b(0), a(0)), Difference(b(1), a(1)), Difference(c(0), a(0)), Difference(c(1), a(1)))
    .Sign();
}

int EvaluateInCircle(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
  const Eigen::RowVector2d& c, const Eigen::RowVector2d& d)
{
  const Eigen::RowVector2d u = a - d, v = b - d, w = c - d;
  const double uv = u(0) * v(1), vu = u(1) * v(0);
  const double vw = v(0) * w(1), wv = v(1) * w(0);
  const double wu = w(0) * u(1), uw = w(1) * u(0);
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), ww = w.squaredNorm();
  const double value = uu * (vw - wv) + vv * (wu - uw) + ww * (uv - vu);
  const double size = uu * (std::abs(vw) + std::abs(wv)) + vv * (std::abs(wu) + std::abs(uw)) +
    ww * (std::abs(uv) + std::abs(vu));
  // Shewchuk's bound for this expression, 1.11e-15, rounded up.
  if (std::abs(value) > 1.2e-15 * size)
  {
    return SignOf(value);
  }
  std::array<Expansion<2>, 2> p, q, r;
  for (int k = 0; k < 2; ++k)
  {
    p[k] = Difference(a(k), d(k));
    q[k] = Difference(b(k), d(k));
    r[k] = Difference(c(k), d(k));
  }
  const auto squared = [](const std::array<Expansion<2>, 2>& x)
  { return Sum(Product(x[0], x[0]), Product(x[1], x[1])); };
  const auto x = Product(Minor(q[0], q[1], r[0], r[1]), squared(p));
  const auto y = Product(Minor(r[0], r[1], p[0], p[1]), squared(q));
  const auto z = Product(Minor(p[0], p[1], q[0], q[1]), squared(r));
  return Sum(Sum(x, y), z).Sign();
}

bool SegmentMeetsTriangle(const Eigen::RowVector2d& a, const Eigen::RowVector2d& b,
  const Eigen::Matrix<double, 3, 2>& triangle)
{
  bool left = false, right = false;
  for (int k = 0; k < 3; ++k)
  {
    const Eigen::RowVector2d p = triangle.row(k), q = triangle.row((k + 1) % 3);
    // Both ends lie outside one edge.
    if (EvaluateOrientation(p, q, a) <= 0 && EvaluateOrientation(p, q, b) <= 0)
    {
      return false;
    }
    const int side = EvaluateOrientation(a, b, p);
    left = left || side > 0;
    right = right || side < 0;
  }
  return left && right;
}

std::vector<int> FindInvertedTriangles(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& positions)
{
  std::vector<int> rows;
  for (int t = 0; t < static_cast<int>(triangles.rows()); ++t)
  {
    const Eigen::RowVector2d a = positions.row(triangles(t, 0)), b = positions.row(triangles(t, 1)),
                             c = positions.row(triangles(t, 2));
    if (EvaluateOrientation(a, b, c) <= 0)
    {
      rows.push_back(t);
    }
  }
  return rows;
}

} // namespace shape
