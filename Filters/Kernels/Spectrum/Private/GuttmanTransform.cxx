#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Spectrum/Private/GuttmanTransform.cxx"
// These would only repeat what AVX-512 and SSE4 compile to.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Spectrum/Private/GuttmanTransform.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shape
{
// No unnamed namespace here: the dispatch below takes addresses from every target.
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

/// Computes the ratios of wanted and current distances of point j and points [begin, end); adds the
/// products and squares of the two distances to sums[0] and sums[1]. The range is of whole vectors.
template <class Tag>
void RatiosOf(Tag tag, const Eigen::MatrixXd& positions, int j, const double* wanted, int begin,
  int end, double* ratios, double* sums)
{
  const std::ptrdiff_t count = positions.rows();
  const auto dimensions = static_cast<int>(positions.cols());
  const auto zero = hn::Zero(tag);
  auto products = zero, squares = zero;
  for (int i = begin; i < end; i += static_cast<int>(hn::Lanes(tag)))
  {
    auto square = zero;
    const double* column = positions.data();
    for (int k = 0; k < dimensions; ++k, column += count)
    {
      const auto way = hn::Sub(hn::LoadU(tag, column + i), hn::Set(tag, column[j]));
      square = hn::MulAdd(way, way, square);
    }
    const auto now = hn::Sqrt(square), wish = hn::LoadU(tag, wanted + i);
    products = hn::MulAdd(wish, now, products);
    squares = hn::Add(squares, square);
    // The direction between points at the same position is undefined; their term is 0.
    hn::StoreU(hn::IfThenElseZero(hn::Gt(now, zero), hn::Div(wish, now)), tag, ratios + i);
  }
  sums[0] += hn::GetLane(hn::SumOfLanes(tag, products));
  sums[1] += hn::GetLane(hn::SumOfLanes(tag, squares));
}

/// Subtracts ratio times (x - x_i) from coordinates [begin, end) of `transformed`, and returns the
/// sum of what was subtracted. The range is of whole vectors.
template <class Tag>
double AddWays(Tag tag, const double* ratios, const double* column, double x, int begin, int end,
  double* transformed)
{
  auto sum = hn::Zero(tag);
  const auto own = hn::Set(tag, x);
  for (int i = begin; i < end; i += static_cast<int>(hn::Lanes(tag)))
  {
    const auto ratio = hn::LoadU(tag, ratios + i);
    const auto way = hn::Sub(own, hn::LoadU(tag, column + i));
    sum = hn::MulAdd(ratio, way, sum);
    hn::StoreU(hn::NegMulAdd(ratio, way, hn::LoadU(tag, transformed + i)), tag, transformed + i);
  }
  return hn::GetLane(hn::SumOfLanes(tag, sum));
}

/// Adds the terms of point j and all points before it, so that each pair is visited once.
void AddPairs(const Eigen::MatrixXd& distances, const Eigen::MatrixXd& positions, int j,
  double* ratios, double* sums, Eigen::MatrixXd& transformed)
{
  const hn::ScalableTag<double> wide;
  const hn::CappedTag<double, 1> single;
  const int lanes = static_cast<int>(hn::Lanes(wide)), whole = j / lanes * lanes;
  const double* wanted = distances.data() + j * distances.rows();
  RatiosOf(wide, positions, j, wanted, 0, whole, ratios, sums);
  RatiosOf(single, positions, j, wanted, whole, j, ratios, sums);
  for (Eigen::Index k = 0; k < positions.cols(); ++k)
  {
    const double *column = positions.data() + k * positions.rows(), x = column[j];
    double* to = transformed.data() + k * transformed.rows();
    to[j] += AddWays(wide, ratios, column, x, 0, whole, to) +
      AddWays(single, ratios, column, x, whole, j, to);
  }
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <array>
#include <vector>

namespace shape
{

HWY_EXPORT(AddPairs);

double TransformByGuttman(
  const Eigen::MatrixXd& distances, Eigen::MatrixXd& positions, Eigen::MatrixXd& transformed)
{
  const auto count = static_cast<int>(positions.rows());
  transformed.setZero(positions.rows(), positions.cols());
  std::vector<double> ratios(count);
  // Over pairs: sums of wanted * current distance, and of squared current distances.
  std::array<double, 2> sums{};
  for (int j = 1; j < count; ++j)
  {
    HWY_DYNAMIC_DISPATCH(AddPairs)
    (distances, positions, j, ratios.data(), sums.data(), transformed);
  }
  transformed /= static_cast<double>(count);
  const auto [products, lengths] = sums;
  // The stress sum (wanted - a now)^2 is minimal for a = products / lengths.
  if (lengths <= 0.0)
  {
    return distances.squaredNorm();
  }
  positions *= products / lengths;
  return distances.squaredNorm() - 2.0 * products * products / lengths;
}

} // namespace shape
#endif // HWY_ONCE
