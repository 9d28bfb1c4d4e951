#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// Charges as columns: the position, and the charge divided by 4 pi.
using ChargeColumns = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// A step of the recurrence for the coefficients of 1 / |x - y|. It is for monomials whose power of
/// z is 0 or 1: the recurrence needs no other, and the others follow from Laplace's equation.
struct TaylorStep
{
  /// The monomials whose power of x, y or z is lower by one, and of x or y by two;
  /// TaylorSums::MaximumSize where there is none.
  std::array<int, 3> Lower;
  std::array<int, 2> Lowest;
  double LowerFactor = 0.0, LowestFactor = 0.0;
};

/// What AddTaylorSums reads, and what it adds to.
struct TaylorSums
{
  const TaylorStep* Steps = nullptr; ///< one for each monomial
  int Size = 0;                      ///< number of monomials, at most MaximumSize
  int Degree = 0;
  const ChargeColumns* Charges = nullptr;
  const std::vector<int>* Ids = nullptr; ///< columns of Charges
  Eigen::Vector3d Centre = Eigen::Vector3d::Zero();
  double Radius = 0.0;
  double* Coefficients[3] = {}; ///< of each component: Size numbers
  double* Remainder = nullptr;  ///< 3 numbers
  double* Magnitude = nullptr;  ///< 3 numbers

  static constexpr int MaximumSize = 81; ///< those of degree 8 and less
};

/// The sums over charges of TaylorExpansion::Add, in vectors of the processor's full width.
void AddTaylorSums(const TaylorSums& sums);

} // namespace shape
