#include "Harmonic/Private/TaylorExpansion.h"

#include <algorithm>
#include <array>
#include <utility>

namespace shape
{

namespace
{

/// Several charges at once: the compiler makes vector instructions of these operations.
constexpr int Lanes = 4;
using Pack = Eigen::Array<double, Lanes, 1>;

/// The recurrences as tables of indices.
struct TaylorTables
{
  std::vector<TaylorExpansion::Monomial> Monomials;
  /// For each monomial, the monomials whose power of x, y or z is lower by one and by two; Size, an
  /// entry that is always 0, where there is none.
  std::vector<std::array<int, 3>> Lower, Lowest;
  /// Of a shift along each axis: first += step * second, in this order.
  std::array<std::vector<std::pair<int, int>>, 3> Shifts;

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
    for (const auto& [powers, n] : this->Monomials)
    {
      const std::array<int, 3> p{ powers[0], powers[1], powers[2] };
      this->Lower.push_back({ find(p, 0, -1), find(p, 1, -1), find(p, 2, -1) });
      this->Lowest.push_back({ find(p, 0, -2), find(p, 1, -2), find(p, 2, -2) });
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      // Horner's scheme, repeated: the coefficients of p(x + step) from those of p(x), for each
      // line of monomials along the axis.
      for (int u = 0; u <= degree; ++u)
      {
        for (int v = 0; u + v <= degree; ++v)
        {
          const int top = degree - u - v;
          std::array<int, 3> powers{};
          powers[(axis + 1) % 3] = u;
          powers[(axis + 2) % 3] = v;
          for (int s = 0; s < top; ++s)
          {
            for (int t = top - 1; t >= s; --t)
            {
              this->Shifts[axis].emplace_back(find(powers, axis, t), find(powers, axis, t + 1));
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

} // namespace

const std::vector<TaylorExpansion::Monomial>& TaylorExpansion::GetMonomials()
{
  return GetTables().Monomials;
}

void TaylorExpansion::Add(const Eigen::MatrixXd& points, const Eigen::MatrixXd& charges,
  const std::vector<int>& ids, const Eigen::Vector3d& centre, double radius, int degree)
{
  const TaylorTables& tables = GetTables();
  const int size = SizeOf(degree);
  std::array<Pack, Size + 1> terms;
  std::array<std::array<Pack, 3>, Size> sums;
  terms[Size].setZero();
  for (int i = 0; i < size; ++i)
  {
    sums[i].fill(Pack::Zero());
  }
  std::array<Pack, 3> remainders, magnitudes;
  remainders.fill(Pack::Zero());
  magnitudes.fill(Pack::Zero());
  for (std::size_t first = 0; first < ids.size(); first += Lanes)
  {
    // Lanes without a charge repeat the last one, with charge 0.
    std::array<Pack, 3> away, charge;
    for (int lane = 0; lane < Lanes; ++lane)
    {
      const std::size_t place = std::min(first + lane, ids.size() - 1);
      for (int c = 0; c < 3; ++c)
      {
        away[c](lane) = centre(c) - points(ids[place], c);
        charge[c](lane) = place == first + lane ? charges(ids[place], c) : 0.0;
      }
    }
    const Pack inverse = (away[0].square() + away[1].square() + away[2].square()).inverse();
    const Pack root = inverse.sqrt();
    for (Pack& entry : away)
    {
      entry *= inverse;
    }
    // n r^2 a_k + (2 n - 1) sum_i d_i a_(k - e_i) + (n - 1) sum_i a_(k - 2 e_i) = 0, n = |k|
    terms[0] = root;
    for (int i = 1; i < size; ++i)
    {
      const double n = tables.Monomials[i].Degree;
      const auto& [x, y, z] = tables.Lower[i];
      const auto& [xx, yy, zz] = tables.Lowest[i];
      terms[i] =
        ((1.0 - 2.0 * n) / n) * (away[0] * terms[x] + away[1] * terms[y] + away[2] * terms[z]) -
        ((n - 1.0) / n) * inverse * (terms[xx] + terms[yy] + terms[zz]);
    }
    for (int i = 0; i < size; ++i)
    {
      for (int c = 0; c < 3; ++c)
      {
        sums[i][c] += charge[c] * terms[i];
      }
    }
    const Pack t = radius * root;
    const Pack magnitude = inverse / (1.0 - t).square();
    Pack tail = magnitude * (degree + 1.0 - degree * t);
    for (int n = 0; n < degree; ++n)
    {
      tail *= t;
    }
    for (int c = 0; c < 3; ++c)
    {
      remainders[c] += charge[c].abs() * tail;
      magnitudes[c] += charge[c].abs() * magnitude;
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    for (int i = 0; i < size; ++i)
    {
      this->Coefficients(i, c) += sums[i][c].sum();
    }
    this->Remainder(c) += remainders[c].sum();
    this->Magnitude(c) += magnitudes[c].sum();
  }
}

void TaylorExpansion::Shift(const Eigen::Vector3d& step)
{
  // The components of a coefficient lie side by side, for vector instructions.
  std::array<Pack, Size> rows;
  for (int i = 0; i < Size; ++i)
  {
    rows[i] << this->Coefficients.row(i).transpose().array(), 0.0;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    for (const auto& [target, source] : GetTables().Shifts[axis])
    {
      rows[target] += step(axis) * rows[source];
    }
  }
  for (int i = 0; i < Size; ++i)
  {
    this->Coefficients.row(i) = rows[i].head<3>().transpose();
  }
}

} // namespace shape
