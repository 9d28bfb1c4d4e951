#include "Untangle/Private/InscribedBall.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace shape
{
namespace
{

/// A . x >= B.
template <int D>
struct Constraint
{
  Eigen::Matrix<double, D, 1> A;
  double B;
};

constexpr double Tolerance = 1e-13;

/// Maximises objective . x subject to constraints and lower <= x <= upper. Returns false if no x
/// satisfies them.
template <int D>
bool Maximize(const Eigen::Matrix<double, D, 1>& objective,
  const std::vector<Constraint<D>>& constraints, std::size_t count,
  const Eigen::Matrix<double, D, 1>& lower, const Eigen::Matrix<double, D, 1>& upper,
  Eigen::Matrix<double, D, 1>& x)
{
  if constexpr (D == 1)
  {
    double low = lower(0), high = upper(0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const double a = constraints[i].A(0), b = constraints[i].B;
      if (std::abs(a) < Tolerance)
      {
        if (b > Tolerance)
        {
          return false;
        }
      }
      else if (a > 0.0)
      {
        low = std::max(low, b / a);
      }
      else
      {
        high = std::min(high, b / a);
      }
    }
    if (low > high + Tolerance * (std::abs(low) + std::abs(high)))
    {
      return false;
    }
    x(0) = objective(0) > 0.0 ? high : low;
    return true;
  }
  else
  {
    for (int k = 0; k < D; ++k)
    {
      x(k) = objective(k) > 0.0 ? upper(k) : lower(k);
    }
    std::vector<Constraint<D - 1>> reduced;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Eigen::Matrix<double, D, 1>& a = constraints[i].A;
      if (a.dot(x) >= constraints[i].B - Tolerance)
      {
        continue;
      }
      // The optimum lies where this constraint is an equality. One variable is eliminated.
      int gone = 0;
      const double pivot = a.cwiseAbs().maxCoeff(&gone);
      if (pivot < Tolerance)
      {
        return false;
      }
      const auto without = [gone](const Eigen::Matrix<double, D, 1>& v)
      {
        Eigen::Matrix<double, D - 1, 1> rest;
        for (int k = 0; k < D - 1; ++k)
        {
          rest(k) = v(k < gone ? k : k + 1);
        }
        return rest;
      };
      // x(gone) = shift - slope . rest.
      const Eigen::Matrix<double, D - 1, 1> slope = without(a) / a(gone);
      const double shift = constraints[i].B / a(gone);
      reduced.clear();
      for (std::size_t j = 0; j < i; ++j)
      {
        const double factor = constraints[j].A(gone);
        reduced.push_back(
          { without(constraints[j].A) - factor * slope, constraints[j].B - factor * shift });
      }
      reduced.push_back({ -slope, lower(gone) - shift });
      reduced.push_back({ slope, shift - upper(gone) });
      Eigen::Matrix<double, D - 1, 1> rest;
      if (!Maximize<D - 1>(without(objective) - objective(gone) * slope, reduced, reduced.size(),
            without(lower), without(upper), rest))
      {
        return false;
      }
      for (int k = 0; k < D - 1; ++k)
      {
        x(k < gone ? k : k + 1) = rest(k);
      }
      x(gone) = shift - slope.dot(rest);
    }
    return true;
  }
}

} // namespace

InscribedBall FindInscribedBall(const std::vector<HalfSpace>& halfSpaces, double extent)
{
  std::vector<Constraint<4>> constraints;
  constraints.reserve(halfSpaces.size());
  for (const HalfSpace& half : halfSpaces)
  {
    constraints.push_back(
      { Eigen::Vector4d(half.Normal(0), half.Normal(1), half.Normal(2), -1.0), -half.Offset });
  }
  std::mt19937 random(1);
  for (std::size_t i = constraints.size(); i > 1; --i)
  {
    std::swap(constraints[i - 1], constraints[random() % i]);
  }
  const Eigen::Vector4d upper(extent, extent, extent, extent);
  const Eigen::Vector4d lower(-extent, -extent, -extent, -4.0 * extent);
  Eigen::Vector4d x;
  if (!Maximize<4>(Eigen::Vector4d::UnitW(), constraints, constraints.size(), lower, upper, x))
  {
    return { Eigen::Vector3d::Zero(), -extent };
  }
  return { x.head<3>(), x(3) };
}

} // namespace shape
