#include "Hex/Features/FeatureConstraint.h"

#include "Geometry/SegmentProjection.h"

#include <Eigen/Geometry>

namespace shape
{
namespace
{

struct PolylinePosition
{
  Eigen::RowVector3d Position;
  Eigen::Index Segment;
};

/// Returns the position on a polyline (k x 3, k >= 1) closest to a given one.
PolylinePosition NearestOn(const Eigen::MatrixXd& line, const Eigen::RowVector3d& position)
{
  PolylinePosition nearest{ line.row(0), 0 };
  double minimum = (line.row(0) - position).squaredNorm();
  for (Eigen::Index i = 0; i + 1 < line.rows(); ++i)
  {
    const double share = ProjectOntoSegment(position, line.row(i), line.row(i + 1));
    const Eigen::RowVector3d candidate = line.row(i) + share * (line.row(i + 1) - line.row(i));
    if (const double distance = (candidate - position).squaredNorm(); distance < minimum)
    {
      minimum = distance;
      nearest = { candidate, i };
    }
  }
  return nearest;
}

} // namespace

FeatureConstraint::FeatureConstraint(const Surface& surface, const SurfaceFeatures& features,
  const PatchedBoundary& boundary, Eigen::Index points)
  : PositionOf(points, Free)
  , FreedomOf(points, 3)
  , Guesses(points, -1)
{
  for (const Surface& patch : boundary.Patches)
  {
    this->Positions.emplace_back(patch);
    this->Normals.emplace_back(patch.AreaVectors().rowwise().normalized());
  }
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    for (const int point : boundary.Quads.row(q))
    {
      this->FreedomOf[point] = 2;
      this->PositionOf[point] = boundary.PatchOf(q);
    }
  }
  // Curves override patches, and corners override both: a point gets the lowest freedom.
  const auto put = [&](int point, const Eigen::MatrixXd& span)
  {
    this->FreedomOf[point] = span.rows() > 1 ? 1 : 0;
    this->PositionOf[point] = static_cast<int>(this->Spans.size());
    this->Spans.push_back(span);
  };
  for (const auto& [point, span] : boundary.Spans)
  {
    put(point, span);
  }
  for (int point = 0; point < static_cast<int>(boundary.CornerOf.size()); ++point)
  {
    if (const int corner = boundary.CornerOf[point]; corner >= 0)
    {
      put(point, surface.Points().row(features.Corners[corner]));
    }
  }
}

int FeatureConstraint::Freedom(int point) const
{
  return this->FreedomOf[point];
}

PointDirections FeatureConstraint::Directions(int point, const Eigen::RowVector3d& position) const
{
  const int id = this->PositionOf[point];
  if (this->FreedomOf[point] == 1)
  {
    const Eigen::MatrixXd& span = this->Spans[id];
    const Eigen::Index segment = NearestOn(span, position).Segment;
    return (span.row(segment + 1) - span.row(segment)).normalized().transpose();
  }
  const Eigen::Vector3d normal =
    this->Normals[id].row(this->FindOnPatch(point, position).Triangle).transpose();
  // Any two orthonormal tangents.
  const Eigen::Vector3d one = normal.unitOrthogonal();
  Eigen::Matrix<double, 3, 2> directions;
  directions << one, normal.cross(one);
  return directions;
}

Eigen::RowVector3d FeatureConstraint::Nearest(int point, const Eigen::RowVector3d& position) const
{
  const int id = this->PositionOf[point];
  return this->FreedomOf[point] < 2 ? NearestOn(this->Spans[id], position).Position
                                    : this->FindOnPatch(point, position).Position;
}

ClosestPoint FeatureConstraint::FindOnPatch(int point, const Eigen::RowVector3d& position) const
{
  const ClosestPoint found =
    this->Positions[this->PositionOf[point]].FindOne(position, this->Guesses[point]);
  this->Guesses[point] = found.Triangle;
  return found;
}

} // namespace shape
