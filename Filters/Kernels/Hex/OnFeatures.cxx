#include "Hex/OnFeatures.h"

#include <Eigen/Geometry>

namespace shape
{
namespace
{

/// A polyline as triangles without area.
Mesh Polyline(const Mesh& surface, const FeatureCurve& curve)
{
  const auto count = static_cast<int>(curve.Points.size());
  Mesh line{ surface.Points(curve.Points, Eigen::all),
    Eigen::MatrixXi(curve.Closed ? count : count - 1, 3) };
  for (int i = 0; i < static_cast<int>(line.Triangles.rows()); ++i)
  {
    line.Triangles.row(i) << i, (i + 1) % count, (i + 1) % count;
  }
  return line;
}

} // namespace

OnFeatures::OnFeatures(const Mesh& surface, const SurfaceFeatures& features,
  const PatchedBoundary& boundary, Eigen::Index points)
  : PlaceOf(points, Free)
  , FreedomOf(points, 3)
  , Guesses(points, -1)
{
  for (const Mesh& patch : PatchMeshes(surface, features))
  {
    this->Places.emplace_back(patch);
    this->Normals.emplace_back(AreaVectors(patch).rowwise().normalized());
  }
  for (const FeatureCurve& curve : features.Curves)
  {
    this->Places.emplace_back(Polyline(surface, curve));
  }
  for (const int corner : features.Corners)
  {
    this->Places.emplace_back(Mesh{ surface.Points.row(corner), Eigen::MatrixXi::Zero(1, 3) });
  }
  const int firstCurve = features.Patches;
  const int firstCorner = firstCurve + static_cast<int>(features.Curves.size());
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    for (const int point : boundary.Quads.row(q))
    {
      const int corner = boundary.CornerOf[point], curve = boundary.CurveOf[point];
      this->FreedomOf[point] = corner >= 0 ? 0 : (curve >= 0 ? 1 : 2);
      this->PlaceOf[point] = corner >= 0 ? firstCorner + corner
        : curve >= 0                     ? firstCurve + curve
                                         : boundary.PatchOf(q);
    }
  }
}

int OnFeatures::Freedom(int point) const
{
  return this->FreedomOf[point];
}

PointDirections OnFeatures::Directions(int point, const Eigen::RowVector3d& place) const
{
  const int id = this->PlaceOf[point];
  const SurfaceLocator& locator = this->Places[id];
  const int triangle = this->Find(point, place).Triangle;
  if (this->FreedomOf[point] == 1)
  {
    const Eigen::Matrix3d corners = Corners(locator.Surface(), triangle);
    return (corners.row(1) - corners.row(0)).normalized().transpose();
  }
  const Eigen::Vector3d normal = this->Normals[id].row(triangle).transpose();
  const Eigen::Vector3d one = normal.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> directions;
  directions << one, normal.cross(one);
  return directions;
}

Eigen::RowVector3d OnFeatures::Nearest(int point, const Eigen::RowVector3d& place) const
{
  return this->Find(point, place).Position;
}

ClosestPlace OnFeatures::Find(int point, const Eigen::RowVector3d& place) const
{
  const ClosestPlace found =
    this->Places[this->PlaceOf[point]].FindOne(place, this->Guesses[point]);
  this->Guesses[point] = found.Triangle;
  return found;
}

} // namespace shape
