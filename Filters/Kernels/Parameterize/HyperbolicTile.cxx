#include "Parameterize/HyperbolicTile.h"

#include "Base/Errors.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace shape
{
namespace
{

/// The square of the chord from p to q in the Minkowski metric: 2 (cosh d - 1).
double SquaredChord(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  const Eigen::Vector3d chord = q - p;
  return std::max(0.0, chord.head<2>().squaredNorm() - chord(2) * chord(2));
}

using Long = long double;
using LongPoint = Eigen::Matrix<Long, 3, 1>;

/// Returns the isometry that reflects across the geodesic with the given unit normal, and then
/// across the x-axis.
HyperbolicMotion ReflectTwice(const LongPoint& normal)
{
  const Eigen::Matrix<Long, 1, 3> form(normal(0), normal(1), -normal(2));
  HyperbolicMotion motion = HyperbolicMotion::Identity() - 2.0L * normal * form;
  motion.row(1) *= -1.0L;
  return motion;
}

} // namespace

Eigen::Vector3d MoveHyperbolic(const HyperbolicMotion& motion, const Eigen::Vector3d& point)
{
  return (motion * point.cast<long double>()).cast<double>();
}

double ComputeHyperbolicDistance(const Eigen::Vector3d& p, const Eigen::Vector3d& q)
{
  return 2.0 * std::asinh(0.5 * std::sqrt(SquaredChord(p, q)));
}

Eigen::Vector3d InterpolateHyperbolic(
  const Eigen::Vector3d& p, const Eigen::Vector3d& q, double share)
{
  const double distance = ComputeHyperbolicDistance(p, q);
  return (std::sinh((1.0 - share) * distance) * p + std::sinh(share * distance) * q) /
    std::sinh(distance);
}

Eigen::Vector3d LiftFromKlein(const Eigen::RowVector2d& position)
{
  return Eigen::Vector3d(position(0), position(1), 1.0) / std::sqrt(1.0 - position.squaredNorm());
}

Eigen::MatrixXd ProjectToKlein(const Eigen::MatrixXd& points)
{
  return points.leftCols(2).array().colwise() / points.col(2).array();
}

Eigen::MatrixXd ProjectToPoincare(const Eigen::MatrixXd& points)
{
  return points.leftCols(2).array().colwise() / (1.0 + points.col(2).array());
}

HyperbolicMotion InvertHyperbolic(const HyperbolicMotion& motion)
{
  const Eigen::DiagonalMatrix<Long, 3> metric(1.0L, 1.0L, -1.0L);
  return metric * motion.transpose() * metric;
}

HyperbolicTile BuildHyperbolicTile(int cones)
{
  if (cones < 5)
  {
    throw InvalidInput("a hyperbolic orbifold has at least 5 cones, but " + std::to_string(cones) +
      " are given; give 5 or more");
  }
  // Half of the tile is the regular polygon below the x-axis, whose side from the last cone to the
  // first has its midpoint at (0, 0, 1). Triangles of its centre, a corner and the midpoint of a
  // side have the angles pi / n, pi / 4 and pi / 2, which give its radii.
  const Long turn = std::acos(-1.0L) / cones;
  const Long inner = std::sqrt(0.5L) / std::sin(turn); // cosh of the inner radius
  const Long outer = 1.0L / std::tan(turn);            // cosh of the outer radius
  const Long shift = std::sqrt(inner * inner - 1.0L), radius = std::sqrt(outer * outer - 1.0L);
  // Returns what is given around the polygon's centre, moved down by the inner radius.
  const auto moved = [&](Long x, Long y, Long t)
  { return LongPoint(x, inner * y - shift * t, inner * t - shift * y); };
  HyperbolicTile tile;
  for (int i = 0; i < cones; ++i)
  {
    const Long angle = (0.5L * cones + 2 * i + 1) * turn;
    const LongPoint cone = moved(radius * std::cos(angle), radius * std::sin(angle), outer);
    tile.There.emplace_back(cone.cast<double>());
    if (i + 1 < cones)
    {
      // A leg's image there is taken back by the reflections across it and across the x-axis.
      tile.Legs.push_back(
        ReflectTwice(moved(inner * std::cos(angle + turn), inner * std::sin(angle + turn), shift)));
    }
  }
  // Both ends lie on the x-axis, up to rounding.
  tile.There.front()(1) = tile.There.back()(1) = 0.0;
  for (const Eigen::Vector3d& cone : tile.There)
  {
    tile.Back.emplace_back(cone(0), -cone(1), cone(2));
  }
  return tile;
}

} // namespace shape
