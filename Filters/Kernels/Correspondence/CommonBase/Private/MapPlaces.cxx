#include "Correspondence/CommonBase/Private/MapPlaces.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/LU>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace shape
{
namespace
{

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

/// Returns the piece that contains a position, or to which it is nearest within rounding. corners:
/// the barycentric coordinates of a piece's corners, one per row.
template <typename Corners>
int NearestPiece(
  const std::vector<int>& pieces, const Eigen::RowVector3d& barycentric, const Corners& corners)
{
  int nearest = -1;
  double best = -std::numeric_limits<double>::infinity();
  for (const int piece : pieces)
  {
    const double least = (barycentric * corners(piece).inverse()).minCoeff();
    if (least > best)
    {
      best = least;
      nearest = piece;
    }
  }
  return nearest;
}

} // namespace

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
      const Eigen::RowVector2d position = place.Motion(surface.PositionOf(point));
      Eigen::RowVector3d barycentric = other.BarycentricOf(place.Triangle, position);
      for (int k = 0; k < 3; ++k)
      {
        // On the opposite edge, exactly, as the points of curves are.
        const int side = NextHalfEdge(3 * place.Triangle + k);
        if (EvaluateOrientation(
              other.PositionAt(side), other.PositionAt(NextHalfEdge(side)), position) == 0)
        {
          barycentric(k) = 0.0;
        }
      }
      set(point, other.OnGiven(place.Triangle, Cleaned(barycentric)));
    }
  }
  for (std::size_t path = 0; path < from.Paths.size(); ++path)
  {
    for (const auto& [point, partner] :
      { std::pair(from.Paths[path].front(), to.Paths[path].front()),
        std::pair(from.Paths[path].back(), to.Paths[path].back()) })
    {
      if (point < points) // otherwise, a curve is divided there
      {
        set(point, AtCone(other, partner));
      }
    }
  }
  return images;
}

SurfacePieces::SurfacePieces(const PatchedSurface& surface)
  : Divided(surface)
  , Pieces(surface.GivenTriangles.maxCoeff() + 1)
  , CornerOf(surface.Surface.Points.rows(), -1)
{
  for (int t = 0; t < static_cast<int>(surface.GivenTriangles.size()); ++t)
  {
    this->Pieces[surface.GivenTriangles(t)].push_back(t);
    for (int k = 0; k < 3; ++k)
    {
      this->CornerOf[surface.Surface.Triangles(t, k)] = 3 * t + k;
    }
  }
}

int SurfacePieces::Find(const SurfacePoint& position) const
{
  return NearestPiece(this->Pieces[position.Triangle], position.Barycentric,
    [this](int piece) -> const Eigen::Matrix3d& { return this->Divided.GivenBarycentrics[piece]; });
}

SurfacePoint SurfacePieces::PlaceOf(int point) const
{
  const int corner = this->CornerOf[point];
  return this->Divided.OnGiven(corner / 3, Eigen::RowVector3d::Unit(corner % 3));
}

PositionMap::PositionMap(const ConeSurface& surface, const std::vector<ConePlace>& places,
  const ConeSurface& other, const PatchedSurface& to)
  : From(surface)
  , Places(places)
  , Other(other)
  , To(to)
{
  for (int t = 0; t < surface.TriangleCount(); ++t)
  {
    if (surface.PointAt(3 * t) >= 0)
    {
      const auto given = static_cast<std::size_t>(surface.Given(t).first);
      this->Pieces.resize(std::max(this->Pieces.size(), given + 1));
      this->Pieces[given].push_back(t);
    }
  }
}

std::optional<Eigen::RowVector3d> PositionMap::ImageOf(const SurfacePoint& position) const
{
  const int triangle = NearestPiece(this->Pieces[position.Triangle], position.Barycentric,
    [this](int piece) -> const Eigen::Matrix3d& { return this->From.Given(piece).second; });
  const Eigen::RowVector3d here =
    position.Barycentric * this->From.Given(triangle).second.inverse();
  Eigen::RowVector2d flat = Eigen::RowVector2d::Zero();
  for (int k = 0; k < 3; ++k)
  {
    flat += here(k) * this->From.PositionAt(3 * triangle + k);
  }
  flat = (flat / BaseGridStep).array().round() * BaseGridStep;
  for (int side = 3 * triangle; side < 3 * triangle + 3; ++side)
  {
    const int point = this->From.PointAt(side);
    if (this->From.IsCone(point))
    {
      continue;
    }
    const Eigen::RowVector2d to = this->From.ChartAt(side).Inverse()(flat);
    const std::optional<ConePlace> place =
      this->Other.Walk(this->Places[point], this->From.PositionOf(point), to);
    if (place)
    {
      const Eigen::RowVector3d weights =
        Cleaned(this->Other.BarycentricOf(place->Triangle, place->Motion(to)));
      Eigen::RowVector3d image = Eigen::RowVector3d::Zero();
      for (int k = 0; k < 3; ++k)
      {
        image +=
          weights(k) * this->To.Surface.Points.row(this->Other.PointAt(3 * place->Triangle + k));
      }
      return image;
    }
  }
  return std::nullopt;
}

} // namespace shape
