#pragma once

#include <algorithm>
#include <array>

namespace shape
{

/// The scalar products from which the point of a triangle nearest to a point follows. e and f are
/// the edges from the first corner, and w is the vector from this corner to the point: e e, e f,
/// f f, e w, f w and w w.
struct WalkProducts
{
  double A = 0.0, B = 0.0, C = 0.0, U = 0.0, V = 0.0, Square = 0.0;
};

/// Returns the point of a triangle nearest to a point, in any dimension, from scalar products
/// alone. e and f are the edges from the first corner, and w is the vector from this corner to the
/// point. a = e e, b = e f, c = f f, u = e w, v = f w. The result (s, t) stands for the first
/// corner + s e + t f; s, t >= 0 and s + t <= 1.
inline std::array<double, 2> ProjectOntoTriangle(double a, double b, double c, double u, double v)
{
  const double determinant = a * c - b * b;
  if (determinant > 0.0)
  {
    const double s = (c * u - b * v) / determinant, t = (a * v - b * u) / determinant;
    if (s >= 0.0 && t >= 0.0 && s + t <= 1.0)
    {
      return { s, t };
    }
  }
  // Otherwise the result lies on one of the edges: the nearest of three candidates.
  const auto share = [](double along, double length)
  { return length > 0.0 ? std::clamp(along / length, 0.0, 1.0) : 0.0; };
  const double across = share(v - u + a - b, a - 2.0 * b + c);
  const std::array<std::array<double, 2>, 3> positions = { { { share(u, a), 0.0 },
    { 0.0, share(v, c) }, { 1.0 - across, across } } };
  const auto farther = [&](const std::array<double, 2>& position)
  {
    const auto [s, t] = position;
    return s * (s * a + 2.0 * t * b - 2.0 * u) + t * (t * c - 2.0 * v);
  };
  return *std::min_element(positions.begin(), positions.end(),
    [&](const auto& one, const auto& other) { return farther(one) < farther(other); });
}

} // namespace shape
