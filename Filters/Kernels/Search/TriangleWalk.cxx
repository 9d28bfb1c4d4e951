#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Search/TriangleWalk.cxx"
// These would only repeat what AVX-512 and SSE4 compile to.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Search/Private/TriangleProjection.h"
#include "Search/TriangleWalk.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shape
{
// No unnamed namespace here: the dispatch below takes addresses from every target.
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Adds coordinates [begin, end) to the products of a triangle's edges from its first corner and
/// the way from there to a position. The range is of whole vectors.
template <class Tag>
void AddProducts(Tag tag, const double* const* corners, const double* towards, Eigen::Index begin,
  Eigen::Index end, WalkProducts& sums)
{
  auto a = hn::Zero(tag), b = a, c = a, u = a, v = a, square = a;
  for (Eigen::Index k = begin; k < end; k += static_cast<Eigen::Index>(hn::Lanes(tag)))
  {
    const auto p = hn::LoadU(tag, corners[0] + k);
    const auto e = hn::Sub(hn::LoadU(tag, corners[1] + k), p),
               f = hn::Sub(hn::LoadU(tag, corners[2] + k), p),
               w = hn::Sub(hn::LoadU(tag, towards + k), p);
    a = hn::MulAdd(e, e, a);
    b = hn::MulAdd(e, f, b);
    c = hn::MulAdd(f, f, c);
    u = hn::MulAdd(w, e, u);
    v = hn::MulAdd(w, f, v);
    square = hn::MulAdd(w, w, square);
  }
  const auto add = [tag](double& to, auto sum) { to += hn::GetLane(hn::SumOfLanes(tag, sum)); };
  add(sums.A, a);
  add(sums.B, b);
  add(sums.C, c);
  add(sums.U, u);
  add(sums.V, v);
  add(sums.Square, square);
}

WalkProducts ProductsOf(const double* const* corners, const double* towards, Eigen::Index dimension)
{
  const hn::ScalableTag<double> wide;
  const hn::CappedTag<double, 1> single;
  const auto lanes = static_cast<Eigen::Index>(hn::Lanes(wide));
  const Eigen::Index whole = dimension / lanes * lanes;
  WalkProducts sums;
  AddProducts(wide, corners, towards, 0, whole, sums);
  AddProducts(single, corners, towards, whole, dimension, sums);
  return sums;
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "Base/Parallel.h"

#include <algorithm>
#include <array>
#include <limits>

namespace shape
{

HWY_EXPORT(ProductsOf);

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
    std::array<const double*, 3> corners;
    for (int k = 0; k < 3; ++k)
    {
      corners[k] = this->Points.col(this->Triangles(t, k)).data();
    }
    const auto [a, b, c, u, v, square] =
      HWY_DYNAMIC_DISPATCH(ProductsOf)(corners.data(), towards.data(), towards.size());
    const auto [x, y] = ProjectOntoTriangle(a, b, c, u, v);
    // Rounding must not make it negative, or the walk would never end.
    const double squared =
      std::max(0.0, square + x * (x * a + 2.0 * y * b - 2.0 * u) + y * (y * c - 2.0 * v));
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
#endif // HWY_ONCE
