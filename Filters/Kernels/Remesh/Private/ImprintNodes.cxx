#include "Remesh/Private/ImprintNodes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// A position moved to the edge or the point that it is near to.
RowVector3d Snapped(const Eigen::Matrix3d& corners, RowVector3d place, double share)
{
  constexpr double rounding = 1e-10; // the parts that are counted are smaller
  const double minimum = std::max(share, rounding);
  if (place.minCoeff() > 0.0)
  {
    const RowVector3d position = place * corners;
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3, last = (k + 2) % 3;
      const RowVector3d edge = corners.row(last) - corners.row(next);
      const RowVector3d own = position - corners.row(next);
      const double squared = edge.squaredNorm();
      if (place(k) <= rounding || own.cross(edge).norm() <= share * squared)
      {
        const double along = squared > 0.0 ? own.dot(edge) / squared : 0.5;
        place(k) = 0.0;
        place(last) = std::clamp(along, 0.0, 1.0);
        place(next) = 1.0 - place(last);
        break;
      }
    }
  }
  Eigen::Index corner = 0;
  if (place.minCoeff() == 0.0 && place.maxCoeff(&corner) >= 1.0 - minimum)
  {
    place = RowVector3d::Unit(corner);
  }
  return place;
}

} // namespace

PointPair FindCommonEdge(const ImprintNode& a, const ImprintNode& b)
{
  const PointPair edge(std::min(a.Low, b.Low), std::max(a.High, b.High));
  return a.Low >= 0 && b.Low >= 0 && a.IsOn(edge) && b.IsOn(edge) ? edge : PointPair(-1, -1);
}

ImprintNode ImprintNodes::At(const SurfacePoint& place)
{
  const Eigen::RowVector3i points = this->Surface.Triangles.row(place.Triangle);
  const RowVector3d at =
    Snapped(GetCorners(this->Surface, place.Triangle), place.Barycentric, this->SnapShare);
  Eigen::Index corner = 0, opposite = 0;
  if (at.maxCoeff(&corner) == 1.0)
  {
    return { points(corner), points(corner), points(corner), 0 };
  }
  if (at.minCoeff(&opposite) == 0.0)
  {
    Eigen::Index from = (opposite + 1) % 3, to = (opposite + 2) % 3;
    if (points(from) > points(to))
    {
      std::swap(from, to);
    }
    // Measured from the lower point: both triangles of the edge give the same integer.
    const auto along = static_cast<std::int64_t>(std::llround(at(to) * Parts));
    SurfacePoint exact{ place.Triangle, RowVector3d::Zero() };
    exact.Barycentric(to) = static_cast<double>(along) / Parts;
    exact.Barycentric(from) = 1.0 - exact.Barycentric(to);
    const int id = this->NumberOf({ points(from), points(to), along, -1 }, exact);
    this->EdgeNodes[PointPair(points(from), points(to))][along] = id;
    return { id, points(from), points(to), along };
  }
  const auto second = static_cast<std::int64_t>(std::llround(at(1) * Parts));
  const auto third = static_cast<std::int64_t>(std::llround(at(2) * Parts));
  const double b = static_cast<double>(second) / Parts, c = static_cast<double>(third) / Parts;
  const int id = this->NumberOf(
    { -1, place.Triangle, second, third }, { place.Triangle, RowVector3d(1.0 - b - c, b, c) });
  return { id, -1, -1, 0 };
}

int ImprintNodes::Add(const SurfacePoint& place)
{
  this->Positions.push_back(place);
  return static_cast<int>(this->Surface.Points.rows() + this->Positions.size()) - 1;
}

const std::map<std::int64_t, int>& ImprintNodes::OnEdge(int a, int b) const
{
  static const std::map<std::int64_t, int> none;
  const auto found = this->EdgeNodes.find(std::minmax(a, b));
  return found == this->EdgeNodes.end() ? none : found->second;
}

/// One at the same position has the same.
int ImprintNodes::NumberOf(const std::array<std::int64_t, 4>& key, const SurfacePoint& place)
{
  const auto found = this->Numbers.find(key);
  if (found != this->Numbers.end())
  {
    return found->second;
  }
  const int number = this->Add(place);
  this->Numbers[key] = number;
  return number;
}

} // namespace shape
