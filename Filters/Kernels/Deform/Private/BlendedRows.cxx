#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Deform/Private/BlendedRows.cxx"
// These would only repeat what AVX-512 and SSE4 compile to.
#define HWY_DISABLED_TARGETS (HWY_SSSE3 | HWY_AVX3_DL)
#include <hwy/foreach_target.h>

#include "Deform/Private/BlendedRows.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace shape
{
// No unnamed namespace here: the dispatch below takes addresses from every target.
namespace HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;

constexpr int Block = 8;
using Tag = hn::CappedTag<double, Block>;

/// The sums of weights times each of the 15 numbers over blocks of eight samples.
/// Weights are floats, which halves the memory to read; sums are doubles.
void SumsFor(const float* weights, const double* values, int blocks, double* sums)
{
  const Tag d;
  const hn::Rebind<float, Tag> single;
  constexpr int size = 15;
  const auto lanes = static_cast<int>(hn::Lanes(d));
  hn::Vec<Tag> totals[size];
  for (auto& total : totals)
  {
    total = hn::Zero(d);
  }
  for (int block = 0; block < blocks; ++block)
  {
    for (int i = 0; i < Block; i += lanes)
    {
      const auto weight = hn::PromoteTo(d, hn::LoadU(single, weights + i));
      for (int c = 0; c < size; ++c)
      {
        totals[c] = hn::MulAdd(weight, hn::LoadU(d, values + c * Block + i), totals[c]);
      }
    }
    weights += Block;
    values += std::ptrdiff_t(size) * Block;
  }
  for (int c = 0; c < size; ++c)
  {
    sums[c] = hn::GetLane(hn::SumOfLanes(d, totals[c]));
  }
}

/// The sum of weights, rounded as that of weights times 1 is above.
/// So the diagonal of the identity rotation blends to exactly 1, and a shape that does not move
/// stays as it is.
double SumFor(const float* weights, int blocks)
{
  const Tag d;
  const hn::Rebind<float, Tag> single;
  const auto lanes = static_cast<int>(hn::Lanes(d));
  auto total = hn::Zero(d);
  for (int i = 0; i < blocks * Block; i += lanes)
  {
    total = hn::Add(total, hn::PromoteTo(d, hn::LoadU(single, weights + i)));
  }
  return hn::GetLane(hn::SumOfLanes(d, total));
}

} // namespace HWY_NAMESPACE
} // namespace shape
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include <algorithm>
#include <cmath>

namespace shape
{

HWY_EXPORT(SumsFor);
HWY_EXPORT(SumFor);

namespace
{
constexpr int BlockSize = 8;
} // namespace

SampleTransforms::SampleTransforms(int samples)
  : Values((samples + BlockSize - 1) / BlockSize * std::size_t(MotionSize * BlockSize), 0.0)
{
}

void SampleTransforms::Set(int sample, const Eigen::Vector3d& rest, const Eigen::Vector3d& position,
  const Eigen::Matrix3d& rotation)
{
  double* to = this->Values.data() + sample / BlockSize * std::size_t(MotionSize * BlockSize) +
    sample % BlockSize;
  const Eigen::Vector3d turned = rotation * rest;
  for (int c = 0; c < 3; ++c)
  {
    to[c * BlockSize] = position(c);
    to[(3 + c) * BlockSize] = turned(c);
  }
  for (int c = 0; c < 9; ++c)
  {
    to[(6 + c) * BlockSize] = rotation(c);
  }
}

void BlendedRows::Add(int begin, int count)
{
  const int block = begin / BlockSize;
  const int blocks = (begin + count + BlockSize - 1) / BlockSize - block;
  this->Rows.push_back({ this->Total, block, blocks, begin % BlockSize, count, 1.0 });
  this->Total += blocks * std::size_t(BlockSize);
}

void BlendedRows::Allocate()
{
  this->Weights.assign(this->Total, 0.0F);
}

void BlendedRows::Set(int row, const float* weights)
{
  Row& one = this->Rows[row];
  float* const to = this->Weights.data() + one.First;
  std::copy(weights, weights + one.Count, to + one.Skip);
  one.Sum = HWY_DYNAMIC_DISPATCH(SumFor)(to, one.Blocks);
}

void BlendedRows::Clear()
{
  this->Rows.clear();
  this->Weights.clear();
  this->Total = 0;
}

/// Equation 5 with the sums over the band: qhat, R q and R are summed separately, since each point
/// applies its own scale to the last two.
BlendedTransform BlendedRows::Blend(int row, const SampleTransforms& motions) const
{
  const Row& one = this->Rows[row];
  double sums[MotionSize];
  HWY_DYNAMIC_DISPATCH(SumsFor)
  (this->Weights.data() + one.First,
    motions.Data() + one.Block * std::ptrdiff_t(MotionSize * BlockSize), one.Blocks, sums);
  BlendedTransform blend;
  blend.Position = Eigen::Map<const Eigen::Vector3d>(sums) / one.Sum;
  blend.Turned = Eigen::Map<const Eigen::Vector3d>(sums + 3) / one.Sum;
  blend.Rotation = Eigen::Map<const Eigen::Matrix3d>(sums + 6) / one.Sum;
  return blend;
}

} // namespace shape
#endif
