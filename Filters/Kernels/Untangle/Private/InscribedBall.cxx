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

/// The constraints of the programmes in one variable less, and in less than that. They are written
/// anew each time, in the same memory.
template <int D>
struct Workspace
{
  explicit Workspace(std::size_t count)
    : Reduced(count + 2)
    , Next(count + 2)
  {
  }
  std::vector<Constraint<D - 1>> Reduced;
  Workspace<D - 1> Next;
};

template <>
struct Workspace<1>
{
  explicit Workspace(std::size_t) {}
};

/// Returns a vector without one of its entries.
template <int D>
Eigen::Matrix<double, D - 1, 1> Without(const Eigen::Matrix<double, D, 1>& v, int gone)
{
  Eigen::Matrix<double, D - 1, 1> rest;
  for (int k = 0; k < D - 1; ++k)
  {
    rest(k) = v(k < gone ? k : k + 1);
  }
  return rest;
}

/// Maximises objective . x subject to constraints and lower <= x <= upper. Returns false if no x
/// satisfies them.
template <int D>
bool Maximize(const Eigen::Matrix<double, D, 1>& objective,
  const std::vector<Constraint<D>>& constraints, std::size_t count,
  const Eigen::Matrix<double, D, 1>& lower, const Eigen::Matrix<double, D, 1>& upper,
  [[maybe_unused]] Workspace<D>& workspace, Eigen::Matrix<double, D, 1>& x)
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
    std::vector<Constraint<D - 1>>& reduced = workspace.Reduced;
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
      // x(gone) = shift - slope . rest.
      const Eigen::Matrix<double, D - 1, 1> slope = Without<D>(a, gone) / a(gone);
      const double shift = constraints[i].B / a(gone);
      for (std::size_t j = 0; j < i; ++j)
      {
        const double factor = constraints[j].A(gone);
        reduced[j].A = Without<D>(constraints[j].A, gone) - factor * slope;
        reduced[j].B = constraints[j].B - factor * shift;
      }
      reduced[i] = { -slope, lower(gone) - shift };
      reduced[i + 1] = { slope, shift - upper(gone) };
      Eigen::Matrix<double, D - 1, 1> rest;
      if (!Maximize<D - 1>(Without<D>(objective, gone) - objective(gone) * slope, reduced, i + 2,
            Without<D>(lower, gone), Without<D>(upper, gone), workspace.Next, rest))
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
  Workspace<4> workspace(constraints.size());
  Eigen::Vector4d x;
  if (!Maximize<4>(
        Eigen::Vector4d::UnitW(), constraints, constraints.size(), lower, upper, workspace, x))
  {
    return { Eigen::Vector3d::Zero(), -extent };
  }
  return { x.head<3>(), x(3) };
}

} // namespace shape
