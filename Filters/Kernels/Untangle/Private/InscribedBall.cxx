#include "Untangle/Private/InscribedBall.h"

#include "Geometry/TwoDoubles.h"

#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>

namespace shape
{
namespace
{

template <typename Scalar, int D>
using Vector = Eigen::Matrix<Scalar, D, 1>;

/// A . x >= B.
template <typename Scalar, int D>
struct Constraint
{
  Vector<Scalar, D> A;
  Scalar B;
};

/// A few hundred roundings.
template <typename Scalar>
constexpr double Tolerance = std::is_same_v<Scalar, double> ? 1e-13 : 1e-29;

/// The constraints of the programmes in one variable less, and in less than that. They are written
/// anew each time, in the same memory.
template <typename Scalar, int D>
struct Workspace
{
  explicit Workspace(std::size_t count)
    : Reduced(count + 2)
    , Next(count + 2)
  {
  }
  std::vector<Constraint<Scalar, D - 1>> Reduced;
  Workspace<Scalar, D - 1> Next;
};

template <typename Scalar>
struct Workspace<Scalar, 1>
{
  explicit Workspace(std::size_t) {}
};

/// Returns a vector without one of its entries.
template <typename Scalar, int D>
Vector<Scalar, D - 1> Without(const Vector<Scalar, D>& v, int gone)
{
  Vector<Scalar, D - 1> rest;
  for (int k = 0; k < D - 1; ++k)
  {
    rest(k) = v(k < gone ? k : k + 1);
  }
  return rest;
}

/// Maximises objective . x subject to constraints and lower <= x <= upper. Returns false if no x
/// satisfies them.
template <typename Scalar, int D>
bool Maximize(const Vector<Scalar, D>& objective,
  const std::vector<Constraint<Scalar, D>>& constraints, std::size_t count,
  const Vector<Scalar, D>& lower, const Vector<Scalar, D>& upper,
  [[maybe_unused]] Workspace<Scalar, D>& workspace, Vector<Scalar, D>& x)
{
  using std::abs;
  const Scalar zero = 0.0, tolerance = Tolerance<Scalar>;
  if constexpr (D == 1)
  {
    Scalar low = lower(0), high = upper(0);
    for (std::size_t i = 0; i < count; ++i)
    {
      const Scalar a = constraints[i].A(0), b = constraints[i].B;
      if (abs(a) < tolerance)
      {
        if (b > tolerance)
        {
          return false;
        }
      }
      else if (a > zero)
      {
        low = std::max(low, Scalar(b / a));
      }
      else
      {
        high = std::min(high, Scalar(b / a));
      }
    }
    if (low > high + tolerance * (abs(low) + abs(high)))
    {
      return false;
    }
    x(0) = objective(0) > zero ? high : low;
    return true;
  }
  else
  {
    for (int k = 0; k < D; ++k)
    {
      x(k) = objective(k) > zero ? upper(k) : lower(k);
    }
    std::vector<Constraint<Scalar, D - 1>>& reduced = workspace.Reduced;
    for (std::size_t i = 0; i < count; ++i)
    {
      const Vector<Scalar, D>& a = constraints[i].A;
      if (a.dot(x) >= constraints[i].B - tolerance)
      {
        continue;
      }
      // The optimum lies where this constraint is an equality. One variable is eliminated.
      int gone = 0;
      const Scalar pivot = a.cwiseAbs().maxCoeff(&gone);
      if (pivot < tolerance)
      {
        return false;
      }
      // x(gone) = shift - slope . rest.
      const Vector<Scalar, D - 1> slope = Without<Scalar, D>(a, gone) / a(gone);
      const Scalar shift = constraints[i].B / a(gone);
      for (std::size_t j = 0; j < i; ++j)
      {
        const Scalar factor = constraints[j].A(gone);
        reduced[j].A = Without<Scalar, D>(constraints[j].A, gone) - factor * slope;
        reduced[j].B = constraints[j].B - factor * shift;
      }
      reduced[i] = { -slope, lower(gone) - shift };
      reduced[i + 1] = { slope, shift - upper(gone) };
      Vector<Scalar, D - 1> rest;
      if (!Maximize<Scalar, D - 1>(Without<Scalar, D>(objective, gone) - objective(gone) * slope,
            reduced, i + 2, Without<Scalar, D>(lower, gone), Without<Scalar, D>(upper, gone),
            workspace.Next, rest))
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

template <typename Scalar>
InscribedBallOf<Scalar> FindInscribedBall(
  const std::vector<HalfSpaceOf<Scalar>>& halfSpaces, double extent)
{
  std::vector<Constraint<Scalar, 4>> constraints;
  constraints.reserve(halfSpaces.size());
  for (const HalfSpaceOf<Scalar>& half : halfSpaces)
  {
    constraints.push_back(
      { Vector<Scalar, 4>(half.Normal(0), half.Normal(1), half.Normal(2), -1.0), -half.Offset });
  }
  std::mt19937 random(1);
  for (std::size_t i = constraints.size(); i > 1; --i)
  {
    std::swap(constraints[i - 1], constraints[random() % i]);
  }
  const Vector<Scalar, 4> upper(extent, extent, extent, extent);
  const Vector<Scalar, 4> lower(-extent, -extent, -extent, -4.0 * extent);
  Workspace<Scalar, 4> workspace(constraints.size());
  Vector<Scalar, 4> x;
  if (!Maximize<Scalar, 4>(
        Vector<Scalar, 4>::UnitW(), constraints, constraints.size(), lower, upper, workspace, x))
  {
    return { Vector<Scalar, 3>::Zero(), -extent };
  }
  return { x.template head<3>(), x(3) };
}

template InscribedBallOf<double> FindInscribedBall(
  const std::vector<HalfSpaceOf<double>>& halfSpaces, double extent);
template InscribedBallOf<TwoDoubles> FindInscribedBall(
  const std::vector<HalfSpaceOf<TwoDoubles>>& halfSpaces, double extent);

} // namespace shape
