#include "Correspondence/CommonBase/Private/MapRelaxation.h"

#include "Correspondence/CommonBase/Private/MapPlaces.h"
#include "Geometry/Orientation.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace shape
{
namespace
{

using Edges = Eigen::Matrix<double, 3, 2>;

/// The edges of a triangle from its first corner.
Edges EdgesOf(const ConeSurface& surface, int triangle, const Eigen::MatrixXd& points)
{
  Edges edges;
  for (int k = 0; k < 2; ++k)
  {
    edges.col(k) = (points.row(surface.PointAt(3 * triangle + 1 + k)) -
      points.row(surface.PointAt(3 * triangle)))
                     .transpose();
  }
  return edges;
}

/// The derivative of positions in space by those on the flat surface, in the coordinates from which
/// `motion` leads to the triangle's.
Edges SpaceByFlat(const ConeSurface& surface, int triangle, const LatticeMotion& motion,
  const Eigen::MatrixXd& points)
{
  Eigen::Matrix2d plane, turn;
  for (int k = 0; k < 2; ++k)
  {
    plane.col(k) =
      (surface.PositionAt(3 * triangle + 1 + k) - surface.PositionAt(3 * triangle)).transpose();
    turn.col(k) = motion.Rotate(Eigen::RowVector2d::Unit(k)).transpose();
  }
  return EdgesOf(surface, triangle, points) * plane.inverse() * turn;
}

bool IsCovered(const ConeSurface& surface, int triangle, const Eigen::RowVector2d& position)
{
  for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
  {
    if (EvaluateOrientation(
          surface.PositionAt(side), surface.PositionAt(NextHalfEdge(side)), position) < 0)
    {
      return false;
    }
  }
  return true;
}

Eigen::MatrixXd ScaledPoints(const Mesh& mesh)
{
  return mesh.Points / std::sqrt(ComputeArea(mesh));
}

} // namespace

MapRelaxation::MapRelaxation(Side a, Side b)
  : Sides{ { { std::move(a), {}, {}, {}, {}, {}, {} }, { std::move(b), {}, {}, {}, {}, {}, {} } } }
{
  for (Relaxed& side : this->Sides)
  {
    side.Points = ScaledPoints(side.Patched.Surface);
    side.Next.assign(side.Flat.PointCount(), -1);
    for (int path = 0; path < side.Patched.CurvePaths; ++path)
    {
      const std::vector<int>& points = side.Patched.Paths[path];
      for (std::size_t i = 1; i + 1 < points.size(); ++i)
      {
        side.Next[points[i]] = points[i + 1];
      }
    }
  }
  for (Relaxed& side : this->Sides)
  {
    this->UpdateShapes(side);
    this->UpdateImages(side);
  }
  this->UpdateHeld();
}

void MapRelaxation::UpdateShapes(Relaxed& side)
{
  side.Shapes.resize(side.Flat.TriangleCount());
  side.Areas.assign(side.Flat.TriangleCount(), 0.0);
  for (int t = 0; t < side.Flat.TriangleCount(); ++t)
  {
    if (side.Flat.PointAt(3 * t) >= 0)
    {
      const Edges edges = EdgesOf(side.Flat, t, side.Points);
      const Eigen::Vector3d first = edges.col(0).normalized(),
                            normal = edges.col(0).cross(edges.col(1));
      Eigen::Matrix2d plane;
      plane << edges.col(0).norm(), first.dot(edges.col(1)), 0.0,
        normal.norm() / edges.col(0).norm();
      side.Shapes[t] = plane.inverse();
      side.Areas[t] = 0.5 * normal.norm();
    }
  }
}

void MapRelaxation::UpdateImages(Relaxed& side)
{
  const Relaxed& other = this->OtherOf(side);
  side.Images.setZero(side.Flat.PointCount(), 3);
  for (std::size_t path = 0; path < side.Patched.Paths.size(); ++path)
  {
    const std::vector<int>&points = side.Patched.Paths[path], &partners = other.Patched.Paths[path];
    side.Images.row(points.front()) = other.Points.row(partners.front());
    side.Images.row(points.back()) = other.Points.row(partners.back());
  }
  for (int point = 0; point < side.Flat.PointCount(); ++point)
  {
    if (side.Flat.IsUsed(point) && !side.Flat.IsCone(point))
    {
      side.Images.row(point) = this->ImageAt(side, point);
    }
  }
}

void MapRelaxation::UpdateHeld()
{
  for (Relaxed& side : this->Sides)
  {
    side.Held.assign(side.Flat.TriangleCount(), {});
    const Relaxed& other = this->OtherOf(side);
    for (int point = 0; point < other.Flat.PointCount(); ++point)
    {
      if (other.Flat.IsUsed(point) && !other.Flat.IsCone(point))
      {
        side.Held[other.Places[point].Triangle].push_back(point);
      }
    }
  }
}

void MapRelaxation::RemoveSplits(Relaxed& side)
{
  const std::vector<std::array<int, 2>>& ends = side.Patched.SplitEdges;
  const int given = side.Flat.PointCount() - static_cast<int>(ends.size());
  bool hasRemoved = false;
  for (int point = side.Flat.PointCount() - 1; point >= given; --point)
  {
    if (side.Flat.IsUsed(point) && !side.Flat.IsCone(point))
    {
      hasRemoved = side.Flat.Remove(point, ends[point - given]) || hasRemoved;
    }
  }
  if (hasRemoved)
  {
    Relaxed& other = this->OtherOf(side);
    other.Places = LocatePoints(other.Flat, side.Flat, side.Places);
    this->UpdateShapes(side);
    this->UpdateImages(other);
    this->UpdateHeld();
  }
}

Eigen::RowVector3d MapRelaxation::ImageAt(const Relaxed& side, int point) const
{
  const Relaxed& other = this->OtherOf(side);
  const ConePlace& place = side.Places[point];
  const Eigen::RowVector3d barycentric =
    other.Flat.BarycentricOf(place.Triangle, place.Motion(side.Flat.PositionOf(point)));
  Eigen::RowVector3d position = Eigen::RowVector3d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    position += barycentric(k) * other.Points.row(other.Flat.PointAt(3 * place.Triangle + k));
  }
  return position;
}

void MapRelaxation::AddEnergy(
  const Relaxed& side, int triangle, const Goal& goal, Total& total, Terms* terms, int corner)
{
  const Eigen::Matrix2d& shape = side.Shapes[triangle];
  const Edges jacobian = EdgesOf(side.Flat, triangle, side.Images) * shape;
  // The singular values are those of a symmetric matrix of two rows.
  const Eigen::Matrix2d form = jacobian.transpose() * jacobian;
  const double mean = 0.5 * form.trace(), half = 0.5 * (form(0, 0) - form(1, 1)),
               apart = std::hypot(half, form(0, 1));
  const double size = jacobian.col(0).cross(jacobian.col(1)).norm();
  const double first = std::sqrt(mean + apart);
  const Eigen::Vector2d singular(first, size / first);
  if (!(singular(1) > 0.0))
  {
    ++total.Infinite;
    return;
  }
  const DistortionTerms<2> measured = EvaluateDistortion<2>(goal.Measure, goal.Exponent, singular);
  if (!std::isfinite(measured.Value))
  {
    ++total.Infinite;
    return;
  }
  total.Sum += side.Areas[triangle] * measured.Value;
  if (terms == nullptr)
  {
    return;
  }
  const double angle = 0.5 * std::atan2(form(0, 1), half);
  Eigen::Matrix2d right;
  right << std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle);
  const Edges left = jacobian * right * singular.cwiseInverse().asDiagonal();
  // The gradient of the corner's hat function.
  const Eigen::RowVector2d hat = corner == 0 ? Eigen::RowVector2d(-shape.colwise().sum())
                                             : Eigen::RowVector2d(shape.row(corner - 1));
  const double area = side.Areas[triangle];
  terms->Slope +=
    area * left * measured.Gradient.asDiagonal() * right.transpose() * hat.transpose();
  terms->Curvature +=
    2.0 * area * hat.squaredNorm() * (left * measured.Weights.asDiagonal() * left.transpose());
}

MapRelaxation::Star MapRelaxation::StarOf(const Relaxed& side, int point) const
{
  const Relaxed& other = this->OtherOf(side);
  Star star{ side.Flat.CornersAt(point), {}, {} };
  for (const int corner : star.Corners)
  {
    for (const int held : side.Held[corner / 3])
    {
      const ConePlace& place = other.Places[held];
      star.Held.push_back({ held, corner,
        side.Flat.ChartAt(corner).Inverse()(place.Motion(other.Flat.PositionOf(held))), place,
        other.Images.row(held) });
      for (const int around : other.Flat.CornersAt(held))
      {
        star.Others.push_back(around / 3);
      }
    }
  }
  std::sort(star.Others.begin(), star.Others.end());
  star.Others.erase(std::unique(star.Others.begin(), star.Others.end()), star.Others.end());
  return star;
}

MapRelaxation::Total MapRelaxation::EnergyOf(const Relaxed& side, const Star& star) const
{
  Total total;
  for (const int corner : star.Corners)
  {
    AddEnergy(side, corner / 3, this->Lowered, total);
  }
  for (const int triangle : star.Others)
  {
    AddEnergy(this->OtherOf(side), triangle, this->Lowered, total);
  }
  return total;
}

Eigen::RowVector2d MapRelaxation::StepOf(const Relaxed& side, int point, const Star& star) const
{
  const Relaxed& other = this->OtherOf(side);
  const ConePlace& place = side.Places[point];
  const Edges spread = SpaceByFlat(other.Flat, place.Triangle, place.Motion, other.Points);
  Total total;
  Terms own;
  for (const int corner : star.Corners)
  {
    AddEnergy(side, corner / 3, this->Lowered, total, &own, corner % 3);
  }
  Eigen::Vector2d slope = spread.transpose() * own.Slope;
  Eigen::Matrix2d curvature = spread.transpose() * own.Curvature * spread;
  for (const HeldPoint& held : star.Held)
  {
    Terms terms;
    for (const int around : other.Flat.CornersAt(held.Point))
    {
      AddEnergy(other, around / 3, this->Lowered, total, &terms, around % 3);
    }
    // At a fixed place, the image moves against the point, by the share of its corner.
    const int triangle = held.Corner / 3;
    const double share = side.Flat.BarycentricOf(
      triangle, side.Flat.ChartAt(held.Corner)(held.Across))(held.Corner % 3);
    const Edges back =
      -share * SpaceByFlat(side.Flat, triangle, side.Flat.ChartAt(held.Corner), side.Points);
    slope += back.transpose() * terms.Slope;
    curvature += back.transpose() * terms.Curvature * back;
  }
  Eigen::RowVector2d step = -(curvature.inverse() * slope).transpose();
  if (total.Infinite > 0)
  {
    // A triangle whose image has no size: towards the centroid of the points around.
    Eigen::Vector3d centroid = Eigen::Vector3d::Zero();
    for (const int corner : star.Corners)
    {
      centroid +=
        (side.Images.row(side.Flat.PointAt(NextHalfEdge(corner))) - side.Images.row(point))
          .transpose() /
        static_cast<double>(star.Corners.size());
    }
    curvature = spread.transpose() * spread;
    slope = -spread.transpose() * centroid;
    step = -(curvature.inverse() * slope).transpose();
  }
  const std::optional<Eigen::RowVector2d> curve = this->CurveAt(side, point);
  if (curve)
  {
    const Eigen::Vector2d along = curve->transpose();
    step = -along.dot(slope) / along.dot(curvature * along) * *curve;
  }
  return step;
}

std::optional<Eigen::RowVector2d> MapRelaxation::CurveAt(const Relaxed& side, int point) const
{
  if (side.Next[point] < 0)
  {
    return std::nullopt;
  }
  for (const int corner : side.Flat.CornersAt(point))
  {
    const int next = NextHalfEdge(corner);
    if (side.Flat.PointAt(next) == side.Next[point])
    {
      // A side of a patch has one of these directions in any coordinates, exactly.
      const Eigen::RowVector2d along = side.Flat.ChartAt(corner).Inverse().Rotate(
        side.Flat.PositionAt(next) - side.Flat.PositionAt(corner));
      return along.unaryExpr([](double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }).eval();
    }
  }
  return std::nullopt;
}

bool MapRelaxation::Relocate(const Relaxed& side, Star& star)
{
  Relaxed& other = this->OtherOf(side);
  for (HeldPoint& held : star.Held)
  {
    const auto found = std::find_if(star.Corners.begin(), star.Corners.end(),
      [&](int corner)
      { return IsCovered(side.Flat, corner / 3, side.Flat.ChartAt(corner)(held.Across)); });
    if (found == star.Corners.end())
    {
      return false;
    }
    other.Places[held.Point] = { *found / 3,
      Compose(side.Flat.ChartAt(*found),
        Compose(side.Flat.ChartAt(held.Corner).Inverse(), held.Place.Motion)) };
    other.Images.row(held.Point) = this->ImageAt(other, held.Point);
  }
  return true;
}

bool MapRelaxation::Relax(Relaxed& side, int point)
{
  Relaxed& other = this->OtherOf(side);
  Star star = this->StarOf(side, point);
  const Total before = this->EnergyOf(side, star);
  const Eigen::RowVector2d step = this->StepOf(side, point, star);
  if (!step.allFinite())
  {
    return false;
  }
  const ConePlace place = side.Places[point];
  const Eigen::RowVector2d position = side.Flat.PositionOf(point);
  const Eigen::RowVector3d image = side.Images.row(point);
  constexpr int halvings = 10;
  double factor = 1.0;
  for (int trial = 0; trial < halvings; ++trial, factor *= 0.5)
  {
    const Eigen::RowVector2d to =
      position + ((factor * step / BaseGridStep).array().round() * BaseGridStep).matrix();
    side.Flat.MoveTo(point, to);
    const bool isEmbedded = std::all_of(star.Corners.begin(), star.Corners.end(),
      [&](int corner) { return side.Flat.IsCounterClockwise(corner / 3); });
    const std::optional<ConePlace> found =
      isEmbedded ? other.Flat.Walk(place, position, to) : std::nullopt;
    if (found)
    {
      side.Places[point] = *found;
      side.Images.row(point) = this->ImageAt(side, point);
      if (this->Relocate(side, star) && this->EnergyOf(side, star) < before)
      {
        const auto move = [](Relaxed& holder, int held, int from, int into)
        {
          std::vector<int>& old = holder.Held[from];
          old.erase(std::find(old.begin(), old.end(), held));
          holder.Held[into].push_back(held);
        };
        move(other, point, place.Triangle, found->Triangle);
        for (const HeldPoint& held : star.Held)
        {
          move(side, held.Point, held.Place.Triangle, other.Places[held.Point].Triangle);
        }
        return true;
      }
    }
    side.Flat.MoveTo(point, position);
    side.Places[point] = place;
    side.Images.row(point) = image;
    for (const HeldPoint& held : star.Held)
    {
      other.Places[held.Point] = held.Place;
      other.Images.row(held.Point) = held.Image;
    }
  }
  return false;
}

double MapRelaxation::Energy(int side, const Goal& goal) const
{
  Total total;
  for (int t = 0; t < this->Sides[side].Flat.TriangleCount(); ++t)
  {
    if (this->Sides[side].Flat.PointAt(3 * t) >= 0)
    {
      AddEnergy(this->Sides[side], t, goal, total);
    }
  }
  return total.Infinite > 0 ? std::numeric_limits<double>::infinity() : total.Sum;
}

void MapRelaxation::Run(const Goal& goal, const Progress& progress)
{
  this->Lowered = goal;
  constexpr int sweeps = 100, between = 5; // between attempts to remove points
  constexpr int grain = 256;               // points between reports
  constexpr double enough = 1e-6;          // relative decrease in a sweep
  const auto both = [&] { return this->Energy(0, goal) + this->Energy(1, goal); };
  double before = std::numeric_limits<double>::infinity();
  for (int sweep = 0; sweep < sweeps; ++sweep)
  {
    if (sweep % between == 0)
    {
      this->RemoveSplits(this->Sides[0]);
      this->RemoveSplits(this->Sides[1]);
      before = both(); // it may have risen
    }
    bool hasMoved = false;
    for (Relaxed& side : this->Sides)
    {
      for (int point = 0; point < side.Flat.PointCount(); ++point)
      {
        if (point % grain == 0)
        {
          progress(static_cast<double>(sweep) / sweeps);
        }
        if (side.Flat.IsUsed(point) && !side.Flat.IsCone(point))
        {
          hasMoved = this->Relax(side, point) || hasMoved;
        }
      }
    }
    const double energy = both();
    if (!hasMoved || before - energy < enough * energy)
    {
      return;
    }
    before = energy;
  }
}

} // namespace shape
