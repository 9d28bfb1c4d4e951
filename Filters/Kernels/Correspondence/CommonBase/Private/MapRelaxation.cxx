#include "Correspondence/CommonBase/Private/MapRelaxation.h"

#include "Base/Errors.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace shape
{
namespace
{

constexpr double Infinite = std::numeric_limits<double>::infinity();

/// Sets weights that differ from 0 by rounding only to 0.
Eigen::RowVector3d Cleaned(Eigen::RowVector3d barycentric)
{
  constexpr double minimum = 1e-12;
  barycentric = (barycentric.array() < minimum).select(0.0, barycentric);
  return barycentric / barycentric.sum();
}

/// A cone's place on the other surface: the same cone.
SurfacePoint AtCone(const ConeSurface& surface, int point)
{
  const int side = surface.CornersAt(point).front();
  return surface.OnGiven(side / 3, Eigen::RowVector3d::Unit(side % 3));
}

} // namespace

MapRelaxation::MapRelaxation(const PatchedSurface& from, ConeSurface& moved,
  const PatchedSurface& to, const ConeSurface& fixed, std::vector<ConePlace> places)
  : From(from)
  , Moved(moved)
  , Fixed(fixed)
  , Found(std::move(places))
  , Images(Eigen::MatrixXd::Zero(moved.PointCount(), 3))
  , Targets(to.Surface.Points * std::sqrt(ComputeArea(from.Surface) / ComputeArea(to.Surface)))
{
  for (std::size_t path = 0; path < from.Paths.size(); ++path)
  {
    this->Images.row(from.Paths[path].front()) = this->Targets.row(to.Paths[path].front());
    this->Images.row(from.Paths[path].back()) = this->Targets.row(to.Paths[path].back());
  }
  for (int point = 0; point < moved.PointCount(); ++point)
  {
    if (moved.IsUsed(point) && !moved.IsCone(point))
    {
      this->Images.row(point) = this->ImageAt(point, this->Found[point]);
    }
  }
  this->UpdateRest();
}

void MapRelaxation::UpdateRest()
{
  this->Inverses.resize(this->Moved.TriangleCount());
  this->Forms.resize(this->Moved.TriangleCount());
  this->Areas.assign(this->Moved.TriangleCount(), 0.0);
  for (int t = 0; t < this->Moved.TriangleCount(); ++t)
  {
    if (this->Moved.PointAt(3 * t) < 0)
    {
      continue;
    }
    Eigen::Matrix<double, 3, 2> edges;
    for (int k = 0; k < 2; ++k)
    {
      edges.col(k) = (this->From.Surface.Points.row(this->Moved.PointAt(3 * t + 1 + k)) -
        this->From.Surface.Points.row(this->Moved.PointAt(3 * t)))
                       .transpose();
    }
    const Eigen::Matrix2d form = edges.transpose() * edges;
    this->Forms[t] = form;
    this->Inverses[t] = form.inverse();
    this->Areas[t] = 0.5 * std::sqrt(form.determinant());
  }
}

Eigen::RowVector3d MapRelaxation::ImageAt(int point, const ConePlace& place) const
{
  const Eigen::RowVector3d barycentric =
    this->Fixed.BarycentricOf(place.Triangle, place.Motion(this->Moved.PositionOf(point)));
  Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    position += barycentric(k) * this->Targets.row(this->Fixed.PointAt(3 * place.Triangle + k));
  }
  return position;
}

double MapRelaxation::EnergyOf(int triangle, Terms* terms, int corner) const
{
  Eigen::Matrix<double, 3, 2> edges;
  for (int k = 0; k < 2; ++k)
  {
    edges.col(k) = (this->Images.row(this->Moved.PointAt(3 * triangle + 1 + k)) -
      this->Images.row(this->Moved.PointAt(3 * triangle)))
                     .transpose();
  }
  const Eigen::Matrix2d image = edges.transpose() * edges;
  const Eigen::Matrix2d& inverse = this->Inverses[triangle];
  const double determinant = image.determinant();
  if (!(determinant > 0.0))
  {
    return Infinite;
  }
  // With the forms G of the triangle and H of its image: tr(G^-1 H) + tr(H^-1 G).
  const Eigen::Matrix2d back = image.inverse();
  const Eigen::Matrix2d& rest = this->Forms[triangle];
  if (terms != nullptr)
  {
    const Eigen::Matrix<double, 3, 2> slope =
      2.0 * this->Areas[triangle] * edges * (inverse - back * rest * back);
    const Eigen::Matrix2d curvature =
      2.0 * this->Areas[triangle] * (inverse + 3.0 * back * rest * back);
    terms->Slope += corner == 0 ? Eigen::Vector3d(-slope.rowwise().sum()) : slope.col(corner - 1);
    terms->Curvature += corner == 0 ? curvature.sum() : curvature(corner - 1, corner - 1);
  }
  return this->Areas[triangle] * ((inverse * image).trace() + (back * rest).trace());
}

double MapRelaxation::Energy() const
{
  double sum = 0.0, area = 0.0;
  for (int t = 0; t < this->Moved.TriangleCount(); ++t)
  {
    if (this->Moved.PointAt(3 * t) >= 0)
    {
      sum += this->EnergyOf(t);
      area += this->Areas[t];
    }
  }
  return sum / area;
}

bool MapRelaxation::Relax(int point)
{
  const std::vector<int> corners = this->Moved.CornersAt(point);
  double before = 0.0;
  Terms terms;
  for (const int side : corners)
  {
    before += this->EnergyOf(side / 3, &terms, side % 3);
  }
  const ConePlace place = this->Found[point];
  const Eigen::RowVector2d position = this->Moved.PositionOf(point);
  const Eigen::RowVector3d image = this->Images.row(point);
  // The step in space, brought into the triangle of B and from there to the flat surface.
  const int first = 3 * place.Triangle;
  Eigen::Matrix<double, 3, 2> edges, flat;
  Eigen::Matrix2d plane;
  for (int k = 0; k < 2; ++k)
  {
    edges.col(k) = (this->Targets.row(this->Fixed.PointAt(first + 1 + k)) -
      this->Targets.row(this->Fixed.PointAt(first)))
                     .transpose();
    plane.col(k) =
      (this->Fixed.PositionAt(first + 1 + k) - this->Fixed.PositionAt(first)).transpose();
  }
  Eigen::Vector3d step = -terms.Slope / terms.Curvature;
  if (!std::isfinite(before))
  {
    // A triangle whose image has no area: towards the centroid of the points around.
    step.setZero();
    for (const int side : corners)
    {
      step += (this->Images.row(this->Moved.PointAt(NextHalfEdge(side))) - image).transpose() /
        static_cast<double>(corners.size());
    }
  }
  const Eigen::Vector2d share = (edges.transpose() * edges).inverse() * (edges.transpose() * step);
  const Eigen::RowVector2d move = place.Motion.Inverse().Rotate((plane * share).transpose());
  if (!move.allFinite())
  {
    return false;
  }
  constexpr int halvings = 10;
  double factor = 2.0;
  for (int trial = 0; trial < halvings; ++trial, factor *= 0.5)
  {
    const Eigen::RowVector2d to =
      ((position + factor * move) / BaseGridStep).array().round() * BaseGridStep;
    this->Moved.MoveTo(point, to);
    bool isBetter = true;
    for (const int side : corners)
    {
      isBetter = isBetter && this->Moved.IsCounterClockwise(side / 3);
    }
    if (isBetter)
    {
      const std::optional<ConePlace> found = this->Fixed.Walk(place, position, to);
      isBetter = found.has_value();
      if (isBetter)
      {
        this->Images.row(point) = this->ImageAt(point, *found);
        double after = 0.0;
        for (const int side : corners)
        {
          after += this->EnergyOf(side / 3);
        }
        if (after < before)
        {
          this->Found[point] = *found;
          return true;
        }
      }
    }
    this->Moved.MoveTo(point, position);
    this->Images.row(point) = image;
  }
  return false;
}

void MapRelaxation::RemoveSplits()
{
  const std::vector<std::array<int, 2>>& ends = this->From.SplitEdges;
  const int given = this->Moved.PointCount() - static_cast<int>(ends.size());
  for (int point = this->Moved.PointCount() - 1; point >= given; --point)
  {
    if (this->Moved.IsUsed(point))
    {
      this->Moved.Remove(point, ends[point - given]);
    }
  }
  this->UpdateRest();
}

void MapRelaxation::Run(const Progress& progress)
{
  constexpr int sweeps = 40, between = 5; // between attempts to remove points
  constexpr int grain = 1024;             // points between reports
  constexpr double enough = 1e-7;         // relative decrease in a sweep
  double before = Infinite;
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    if (sweep % between == 0)
    {
      this->RemoveSplits();
    }
    bool hasMoved = false;
    for (int point = 0; point < this->Moved.PointCount(); ++point)
    {
      if (point % grain == 0)
      {
        progress(static_cast<double>(sweep) / sweeps);
      }
      if (this->Moved.IsUsed(point) && !this->Moved.IsCone(point))
      {
        hasMoved = this->Relax(point) || hasMoved;
      }
    }
    const double energy = this->Energy();
    if (!hasMoved || before - energy < enough * energy)
    {
      return;
    }
    before = energy;
  }
}

// From a point of the other surface in a triangle of this one, straight lines in the triangle lead
// to its corners. From a point that has been located, its edges lead to others.
std::vector<ConePlace> LocatePoints(
  const ConeSurface& surface, const ConeSurface& other, const std::vector<ConePlace>& places)
{
  std::vector<ConePlace> found(surface.PointCount());
  std::vector<int> open;
  const auto locate = [&](
                        int side, const LatticeMotion& back, const std::optional<ConePlace>& place)
  {
    if (place)
    {
      const int point = surface.PointAt(side);
      found[point] = { place->Triangle,
        Compose(place->Motion, Compose(back, surface.ChartAt(side))) };
      open.push_back(point);
    }
  };
  const auto isOpen = [&](int point)
  { return !surface.IsCone(point) && found[point].Triangle < 0; };
  for (int point = 0; point < other.PointCount(); ++point)
  {
    if (!other.IsUsed(point) || other.IsCone(point))
    {
      continue;
    }
    const int first = 3 * places[point].Triangle;
    const LatticeMotion back = places[point].Motion.Inverse();
    for (int side = first; side < first + 3; ++side)
    {
      if (isOpen(surface.PointAt(side)))
      {
        locate(side, back, other.WalkFrom(point, back(surface.PositionAt(side))));
      }
    }
  }
  for (std::size_t next = 0; next < open.size(); ++next)
  {
    const int from = open[next];
    for (const int side : surface.CornersAt(from))
    {
      const int along = NextHalfEdge(side);
      const LatticeMotion back = surface.ChartAt(side).Inverse();
      if (isOpen(surface.PointAt(along)))
      {
        locate(along, back,
          other.Walk(found[from], surface.PositionOf(from), back(surface.PositionAt(along))));
      }
    }
  }
  for (int point = 0; point < surface.PointCount(); ++point)
  {
    if (surface.IsUsed(point) && isOpen(point))
    {
      throw SolveFailure("point " + std::to_string(point) +
        " has no place on the other surface within double precision; remesh the surfaces");
    }
  }
  return found;
}

SurfacePoints GetImages(Eigen::Index points, const PatchedSurface& from, const ConeSurface& surface,
  const std::vector<ConePlace>& places, const PatchedSurface& to, const ConeSurface& other)
{
  SurfacePoints images{ Eigen::VectorXi(points), Eigen::MatrixXd(points, 3) };
  const auto set = [&](int point, const SurfacePoint& image)
  {
    images.Triangles(point) = image.Triangle;
    images.Barycentrics.row(point) = Cleaned(image.Barycentric);
  };
  for (int point = 0; point < static_cast<int>(points); ++point)
  {
    if (!surface.IsCone(point))
    {
      const ConePlace& place = places[point];
      set(point,
        other.OnGiven(place.Triangle,
          Cleaned(other.BarycentricOf(place.Triangle, place.Motion(surface.PositionOf(point))))));
    }
  }
  for (std::size_t path = 0; path < from.Paths.size(); ++path)
  {
    set(from.Paths[path].front(), AtCone(other, to.Paths[path].front()));
    set(from.Paths[path].back(), AtCone(other, to.Paths[path].back()));
  }
  return images;
}

} // namespace shape
