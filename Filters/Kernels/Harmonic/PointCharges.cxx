#include "Harmonic/PointCharges.h"

#include "Mesh/Mesh.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "Harmonic/PointCharges.cxx"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace shape::HWY_NAMESPACE
{

namespace hn = hwy::HWY_NAMESPACE;
using Wide = hn::ScalableTag<double>;
using Vector = hn::Vec<Wide>;

/// Returns 1 / sqrt(square) to the last bit or two: a single-precision approximation with at least
/// 11 bits, then three Newton steps. `square` must lie in the range of float: see PointCharges.
HWY_INLINE Vector InverseRoot(Wide wide, Vector square)
{
  const hn::Rebind<float, Wide> narrow;
  Vector root = hn::PromoteTo(wide, hn::ApproximateReciprocalSqrt(hn::DemoteTo(narrow, square)));
  const Vector half = hn::Mul(hn::Set(wide, 0.5), square);
  for (int step = 0; step < 3; ++step)
  {
    const Vector rest = hn::NegMulAdd(hn::Mul(half, root), root, hn::Set(wide, 0.5));
    root = hn::MulAdd(root, rest, root);
  }
  return root;
}

/// Sums over all charges: 3 values of the field and, if requested, 9 of its derivative.
template <bool WithDerivative>
HWY_INLINE void Sum(const double* packed, size_t stride, const double* position, double* sums)
{
  const Wide wide;
  const Vector x = hn::Set(wide, position[0]), y = hn::Set(wide, position[1]),
               z = hn::Set(wide, position[2]);
  Vector field[3], slope[9];
  for (Vector& entry : field)
  {
    entry = hn::Zero(wide);
  }
  for (Vector& entry : slope)
  {
    entry = hn::Zero(wide);
  }
  // A lane is a charge; each array of the packed charges is read in whole vectors.
  for (size_t j = 0; j < stride; j += hn::Lanes(wide))
  {
    const Vector away[3] = { hn::Sub(x, hn::LoadU(wide, packed + j)),
      hn::Sub(y, hn::LoadU(wide, packed + stride + j)),
      hn::Sub(z, hn::LoadU(wide, packed + 2 * stride + j)) };
    const Vector square =
      hn::MulAdd(away[0], away[0], hn::MulAdd(away[1], away[1], hn::Mul(away[2], away[2])));
    const Vector root = InverseRoot(wide, square);
    const Vector cube = hn::Mul(root, hn::Mul(root, root));
    for (int r = 0; r < 3; ++r)
    {
      const Vector charge = hn::LoadU(wide, packed + (3 + r) * stride + j);
      field[r] = hn::MulAdd(charge, root, field[r]);
      if (WithDerivative)
      {
        // The gradient of q / |y - x| is -q (y - x) / |y - x|^3.
        const Vector pull = hn::Mul(charge, cube);
        for (int c = 0; c < 3; ++c)
        {
          slope[3 * r + c] = hn::NegMulAdd(pull, away[c], slope[3 * r + c]);
        }
      }
    }
  }
  for (int i = 0; i < 3; ++i)
  {
    sums[i] = hn::GetLane(hn::SumOfLanes(wide, field[i]));
  }
  for (int i = 0; WithDerivative && i < 9; ++i)
  {
    sums[3 + i] = hn::GetLane(hn::SumOfLanes(wide, slope[i]));
  }
}

void Field(const double* packed, size_t stride, const double* position, double* sums)
{
  Sum<false>(packed, stride, position, sums);
}

void FieldAndSlope(const double* packed, size_t stride, const double* position, double* sums)
{
  Sum<true>(packed, stride, position, sums);
}

} // namespace shape::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace shape
{

namespace
{

HWY_EXPORT(Field);
HWY_EXPORT(FieldAndSlope);

/// At least the number of lanes of any processor's vectors.
constexpr Eigen::Index Lanes = 32;
/// Position, in units of the box, of the zero charges that fill the last vector.
constexpr double Far = 1e6;

} // namespace

PointCharges::PointCharges(const ChargeSet& set)
  : Affine(set.Affine)
{
  const Eigen::Index count = set.Points.rows();
  if (count == 0)
  {
    return;
  }
  this->Origin = set.Points.colwise().minCoeff();
  const double size = ComputeLongestBoxEdge(set.Points);
  this->Size = size > 0.0 ? size : 1.0;
  this->Stride = static_cast<std::size_t>((count + Lanes - 1) / Lanes * Lanes);
  Eigen::MatrixXd packed = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(this->Stride), 6);
  packed.leftCols<3>().setConstant(Far);
  // In units of the box, because InverseRoot needs squares in the range of float.
  packed.topLeftCorner(count, 3) = (set.Points.rowwise() - this->Origin) / this->Size;
  packed.topRightCorner(count, 3) = 0.25 * M_1_PI / this->Size * set.Charges;
  this->Packed.assign(packed.data(), packed.data() + packed.size());
}

Eigen::Vector3d PointCharges::Evaluate(const Eigen::Vector3d& position) const
{
  Eigen::Vector3d sums = Eigen::Vector3d::Zero();
  if (this->Stride > 0)
  {
    const Eigen::Vector3d scaled = (position - this->Origin.transpose()) / this->Size;
    HWY_DYNAMIC_DISPATCH(Field)(this->Packed.data(), this->Stride, scaled.data(), sums.data());
  }
  return sums + this->Affine.leftCols<3>() * position + this->Affine.col(3);
}

Eigen::Vector3d PointCharges::Evaluate(
  const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const
{
  Eigen::Matrix<double, 12, 1> sums = Eigen::Matrix<double, 12, 1>::Zero();
  if (this->Stride > 0)
  {
    const Eigen::Vector3d scaled = (position - this->Origin.transpose()) / this->Size;
    HWY_DYNAMIC_DISPATCH(FieldAndSlope)
    (this->Packed.data(), this->Stride, scaled.data(), sums.data());
  }
  jacobian = this->Affine.leftCols<3>();
  for (int r = 0; r < 3; ++r)
  {
    // The sums are derivatives by scaled coordinates: the chain rule divides by the box.
    jacobian.row(r) += sums.segment<3>(3 + 3 * r).transpose() / this->Size;
  }
  return sums.head<3>() + this->Affine.leftCols<3>() * position + this->Affine.col(3);
}

} // namespace shape

#endif
