#include "Harmonic/Private/TaylorExpansion.h"

#include <algorithm>
#include <array>
#include <utility>

namespace shape
{

namespace
{

/// The recurrences as tables of indices.
struct TaylorTables
{
  std::vector<TaylorExpansion::Monomial> Monomials;
  std::vector<TaylorStep> Steps; ///< one for each monomial with a power of z below 2
  /// For each step, its monomial.
  std::vector<int> OfSteps;
  /// The other monomials, by degree: first follows from the monomials Sources with these factors.
  struct LaplaceStep
  {
    int Target;
    std::array<int, 2> Sources;
    std::array<double, 2> Factors;
  };
  std::vector<LaplaceStep> LaplaceSteps;
  /// Of a shift along each axis: first += step * second, in this order. LowShifts are those that
  /// the terms of LowDegree and less need.
  std::array<std::vector<std::pair<int, int>>, 3> Shifts, LowShifts;

  TaylorTables()
  {
    constexpr int degree = TaylorExpansion::Degree;
    int index[degree + 1][degree + 1][degree + 1];
    for (int n = 0; n <= degree; ++n)
    {
      for (int x = n; x >= 0; --x)
      {
        for (int y = n - x; y >= 0; --y)
        {
          index[x][y][n - x - y] = static_cast<int>(this->Monomials.size());
          this->Monomials.push_back({ { x, y, n - x - y }, n });
        }
      }
    }
    const auto find = [&](std::array<int, 3> powers, int axis, int change)
    {
      powers[axis] += change;
      return powers[axis] < 0 ? TaylorExpansion::Size : index[powers[0]][powers[1]][powers[2]];
    };
    std::array<int, TaylorExpansion::Size + 1> steps;
    steps.fill(TaylorSums::MaximumSize);
    for (int i = 0; i < TaylorExpansion::Size; ++i)
    {
      const auto& [powers, n] = this->Monomials[i];
      const std::array<int, 3> p{ powers[0], powers[1], powers[2] };
      if (p[2] < 2)
      {
        // n r^2 a_k + (2 n - 1) sum_i d_i a_(k - e_i) + (n - 1) sum_i a_(k - 2 e_i) = 0, n = |k|
        const double rank = std::max(n, 1);
        steps[i] = static_cast<int>(this->Steps.size());
        this->OfSteps.push_back(i);
        this->Steps.push_back(
          { { steps[find(p, 0, -1)], steps[find(p, 1, -1)], steps[find(p, 2, -1)] },
            { steps[find(p, 0, -2)], steps[find(p, 1, -2)] }, (1.0 - 2.0 * rank) / rank,
            (1.0 - rank) / rank });
        continue;
      }
      // sum_i (k_i + 2) (k_i + 1) a_(k + 2 e_i) = 0
      const std::array<int, 3> base{ p[0], p[1], p[2] - 2 };
      const auto factor = [](int power) { return (power + 2.0) * (power + 1.0); };
      this->LaplaceSteps.push_back({ i, { find(base, 0, 2), find(base, 1, 2) },
        { -factor(base[0]) / factor(base[2]), -factor(base[1]) / factor(base[2]) } });
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      // Horner's scheme, repeated: the coefficients of p(x + step) from those of p(x), for each
      // line of monomials along the axis. Lines are independent, so they are the inner loops.
      for (int s = 0; s < degree; ++s)
      {
        for (int t = degree - 1; t >= s; --t)
        {
          for (int u = 0; u + t < degree; ++u)
          {
            for (int v = 0; u + v + t < degree; ++v)
            {
              std::array<int, 3> powers{};
              powers[(axis + 1) % 3] = u;
              powers[(axis + 2) % 3] = v;
              const std::pair<int, int> pair(find(powers, axis, t), find(powers, axis, t + 1));
              this->Shifts[axis].push_back(pair);
              // The powers along earlier axes stay.
              const int earlier = (axis > 0 ? powers[0] : 0) + (axis > 1 ? powers[1] : 0);
              if (s + earlier <= TaylorExpansion::LowDegree)
              {
                this->LowShifts[axis].push_back(pair);
              }
            }
          }
        }
      }
    }
  }
};

const TaylorTables& GetTables()
{
  static const TaylorTables tables;
  return tables;
}

/// Returns the coefficients after a shift. The components of a coefficient lie side by side, for
/// vector instructions.
Eigen::Matrix<double, TaylorExpansion::Size, 3> ShiftedBy(
  const Eigen::Matrix<double, TaylorExpansion::Size, 3>& coefficients, const Eigen::Vector3d& step,
  const std::array<std::vector<std::pair<int, int>>, 3>& shifts)
{
  std::array<Eigen::Array4d, TaylorExpansion::Size> rows;
  for (int i = 0; i < TaylorExpansion::Size; ++i)
  {
    rows[i] << coefficients.row(i).transpose().array(), 0.0;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const auto& [target, source] : shifts[axis])
    {
      rows[target] += step(axis) * rows[source];
    }
  }
  Eigen::Matrix<double, TaylorExpansion::Size, 3> shifted;
  for (int i = 0; i < TaylorExpansion::Size; ++i)
  {
    shifted.row(i) = rows[i].head<3>().transpose();
  }
  return shifted;
}

} // namespace

const std::vector<TaylorExpansion::Monomial>& TaylorExpansion::GetMonomials()
{
  return GetTables().Monomials;
}

void TaylorExpansion::Add(const ChargeColumns& charges, const std::vector<int>& ids,
  const Eigen::Vector3d& centre, double radius, int degree)
{
  if (ids.empty())
  {
    return;
  }
  TaylorSums sums;
  const TaylorTables& tables = GetTables();
  Eigen::Matrix<double, TaylorSums::MaximumSize, 3> found;
  found.setZero();
  sums.Steps = tables.Steps.data();
  sums.Size = (degree + 1) * (degree + 1);
  sums.Degree = degree;
  sums.Charges = &charges;
  sums.Ids = &ids;
  sums.Centre = centre;
  sums.Radius = radius;
  for (int c = 0; c < 3; ++c)
  {
    sums.Coefficients[c] = found.col(c).data();
  }
  sums.Remainder = this->Remainder.data();
  sums.Magnitude = this->Magnitude.data();
  AddTaylorSums(sums);
  Eigen::Matrix<double, Size, 3> all;
  for (int i = 0; i < sums.Size; ++i)
  {
    all.row(tables.OfSteps[i]) = found.row(i);
  }
  for (const auto& [target, sources, factors] : tables.LaplaceSteps)
  {
    if (target >= SizeOf(degree))
    {
      break;
    }
    all.row(target) = factors[0] * all.row(sources[0]) + factors[1] * all.row(sources[1]);
  }
  this->Coefficients.topRows(SizeOf(degree)) += all.topRows(SizeOf(degree));
}

void TaylorExpansion::Shift(const Eigen::Vector3d& step)
{
  this->Coefficients = ShiftedBy(this->Coefficients, step, GetTables().Shifts);
}

TaylorExpansion TaylorExpansion::GetLowTerms(const Eigen::Vector3d& step) const
{
  constexpr int low = SizeOf(LowDegree);
  TaylorExpansion terms;
  terms.Coefficients.topRows<low>() =
    ShiftedBy(this->Coefficients, step, GetTables().LowShifts).topRows<low>();
  terms.Remainder = this->Remainder;
  terms.Magnitude = this->Magnitude;
  return terms;
}

Eigen::Matrix3d TaylorExpansion::BoundHighTerms(double half) const
{
  Eigen::Matrix3d bound = Eigen::Matrix3d::Zero();
  double scale = 1.0;
  for (int i = SizeOf(LowDegree), degree = LowDegree + 1; i < Size; ++i)
  {
    const auto& [powers, n] = GetMonomials()[i];
    if (n > degree)
    {
      ++degree;
      scale *= half;
    }
    // (n - 1 over LowDegree) is the sum of the products of powers that the derivatives bring down.
    double factor = scale;
    for (int k = 1; k <= LowDegree; ++k)
    {
      factor *= (n - static_cast<double>(k)) / k;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      bound.col(axis) += powers[axis] * factor * this->Coefficients.row(i).cwiseAbs().transpose();
    }
  }
  return bound;
}

} // namespace shape
