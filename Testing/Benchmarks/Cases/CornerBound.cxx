#include "Cases/CornerBound.h"

#include "Search/ClosestPoint.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace
{

using Direction = Eigen::RowVector3d;

/// What a patch takes of the surroundings of a corner.
struct Sector
{
  Direction Begin, Middle; ///< unit vectors: along the crease before it, and half way to the next
  double Angle = 0.0;
};

double AngleBetween(const Direction& a, const Direction& b)
{
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// The direction in a fan of directions, each at an angle to the one before, at half of the angle.
Direction MidpointOf(const std::vector<Direction>& fan, double angle)
{
  double before = 0.0;
  for (std::size_t i = 0; i + 1 < fan.size(); ++i)
  {
    const double step = AngleBetween(fan[i], fan[i + 1]);
    if (before + step >= 0.5 * angle)
    {
      const double share = (0.5 * angle - before) / step;
      return ((1.0 - share) * fan[i] + share * fan[i + 1]).normalized();
    }
    before += step;
  }
  return fan.back();
}

/// The sectors around a corner, counter-clockwise seen from outside.
std::vector<Sector> SectorsAround(
  const shape::Mesh& surface, int corner, const std::set<std::pair<int, int>>& creases)
{
  std::map<int, int> next; // around the corner
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (surface.Triangles(t, k) == corner)
      {
        next[surface.Triangles(t, (k + 1) % 3)] = surface.Triangles(t, (k + 2) % 3);
      }
    }
  }
  const auto first = std::find_if(next.begin(), next.end(),
    [&](const auto& step) {
      return creases.count({ corner, step.first }) > 0;
    });
  std::vector<Sector> sectors;
  if (first == next.end())
  {
    return sectors;
  }
  std::vector<Direction> fan;
  double angle = 0.0;
  int point = first->first;
  for (std::size_t i = 0; i <= next.size(); ++i, point = next.at(point))
  {
    const Direction towards = (surface.Points.row(point) - surface.Points.row(corner)).normalized();
    angle += fan.empty() ? 0.0 : AngleBetween(fan.back(), towards);
    fan.push_back(towards);
    if (i > 0 && creases.count({ corner, point }) > 0)
    {
      sectors.push_back({ fan.front(), MidpointOf(fan, angle), angle });
      fan = { towards };
      angle = 0.0;
    }
  }
  return sectors;
}

bool IsConvex(const std::vector<Sector>& sectors)
{
  bool isConvex = true;
  for (std::size_t i = 0; i < sectors.size(); ++i)
  {
    const Sector& before = sectors[(i + sectors.size() - 1) % sectors.size()];
    isConvex = isConvex && before.Middle.dot(sectors[i].Begin.cross(sectors[i].Middle)) < 0.0;
  }
  return isConvex;
}

/// The least scaled Jacobian around the best inward edge.
double AroundAnEdge(const std::vector<Direction>& along)
{
  std::vector<Direction> products;
  for (std::size_t i = 0; i < along.size(); ++i)
  {
    products.push_back(along[i].cross(along[(i + 1) % along.size()]));
  }
  Direction nearest = Direction::Constant(std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < products.size(); ++i)
  {
    for (std::size_t j = i; j < products.size(); ++j)
    {
      for (std::size_t k = j; k < products.size(); ++k)
      {
        Eigen::Matrix3d face;
        face << products[i], products[j], products[k];
        const Direction position =
          shape::FindClosestPointInTriangle(face, Direction::Zero()) * face;
        nearest = position.squaredNorm() < nearest.squaredNorm() ? position : nearest;
      }
    }
  }
  double minimum = std::numeric_limits<double>::infinity();
  for (const Direction& product : products)
  {
    minimum = std::min(minimum, product.dot(nearest.normalized()));
  }
  return std::max(minimum, 0.0); // 0 is in the hull: every edge is on the wrong side of some patch
}

/// The least scaled Jacobian of hexahedra with three of the edges each, for the best choice of
/// these between the i-th and the j-th.
double Without(const std::vector<Direction>& along, std::size_t i, std::size_t j)
{
  double best = j - i < 2 ? 1.0 : 0.0;
  for (std::size_t k = i + 1; k < j; ++k)
  {
    // Negative where the corner is convex.
    const double own = -along[i].dot(along[k].cross(along[j]));
    best = std::max(best, std::min({ own, Without(along, i, k), Without(along, k, j) }));
  }
  return best;
}

double BoundOf(const std::vector<Sector>& sectors)
{
  const std::size_t count = sectors.size();
  double best = 0.0;
  for (unsigned int halved = 0; halved < 1U << count; ++halved)
  {
    std::vector<Direction> along;
    bool isAllowed = true;
    for (std::size_t i = 0; i < count; ++i)
    {
      constexpr double wide = 1.5707963267948966;
      along.push_back(sectors[i].Begin);
      if ((halved >> i & 1U) != 0U)
      {
        isAllowed = isAllowed && sectors[i].Angle > wide;
        along.push_back(sectors[i].Middle);
      }
    }
    if (isAllowed)
    {
      best = std::max({ best, AroundAnEdge(along), Without(along, 0, along.size() - 1) });
    }
  }
  return best;
}

} // namespace

double benchmark::CornerBound(const shape::Mesh& surface, const shape::SurfaceFeatures& features)
{
  std::set<std::pair<int, int>> creases;
  for (const shape::FeatureCurve& curve : features.Curves)
  {
    for (std::size_t i = 0; i + 1 < curve.Points.size(); ++i)
    {
      creases.emplace(curve.Points[i], curve.Points[i + 1]);
      creases.emplace(curve.Points[i + 1], curve.Points[i]);
    }
  }
  double bound = 1.0;
  for (const int corner : features.Corners)
  {
    const std::vector<Sector> sectors = SectorsAround(surface, corner, creases);
    constexpr std::size_t minimum = 3, maximum = 8; // patches: of more no bound is computed
    if (sectors.size() >= minimum && sectors.size() <= maximum && IsConvex(sectors))
    {
      bound = std::min(bound, BoundOf(sectors));
    }
  }
  return bound;
}
