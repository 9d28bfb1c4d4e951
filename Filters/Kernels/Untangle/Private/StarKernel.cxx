#include "Untangle/Private/StarKernel.h"

#include "Geometry/Orientation.h"
#include "Geometry/TwoDoubles.h"
#include "Untangle/Private/InscribedBall.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shape
{
namespace
{

double MeasureStar(const Eigen::MatrixXd& points, const std::vector<StarFace>& faces,
  const Eigen::RowVector3d& origin)
{
  double size = 0.0;
  for (const StarFace& face : faces)
  {
    for (const int point : face)
    {
      size = std::max(size, (points.row(point) - origin).norm());
    }
  }
  return size;
}

/// Returns the unit normal of a face, or 0 if it has no area. Differences of positions that are
/// close to each other cancel in doubles.
Eigen::Matrix<TwoDoubles, 3, 1> FindNormal(const Eigen::MatrixXd& points, const StarFace& face)
{
  using Vector = Eigen::Matrix<TwoDoubles, 3, 1>;
  const Vector corner = points.row(face[0]).transpose().cast<TwoDoubles>();
  const Vector a = points.row(face[1]).transpose().cast<TwoDoubles>() - corner,
               b = points.row(face[2]).transpose().cast<TwoDoubles>() - corner;
  const Vector normal = a.cross(b);
  const TwoDoubles length = sqrt(normal.dot(normal));
  return length > 0.0 ? Vector(normal / length) : Vector::Zero();
}

/// Computes FindKernelCentre in doubles or in TwoDoubles.
template <typename Scalar>
StarPlacement FindKernelCentreIn(const Eigen::MatrixXd& points, const std::vector<StarFace>& faces,
  const Eigen::RowVector3d& origin, double size)
{
  using Vector = Eigen::Matrix<Scalar, 3, 1>;
  StarPlacement placement;
  placement.Position = origin;
  std::vector<HalfSpaceOf<Scalar>> halfSpaces;
  halfSpaces.reserve(faces.size());
  const Vector centre = origin.transpose().cast<Scalar>();
  for (const StarFace& face : faces)
  {
    const Vector normal = FindNormal(points, face).cast<Scalar>();
    if (normal == Vector::Zero())
    {
      placement.Clearance = -1.0;
      return placement;
    }
    const Vector corner =
      (points.row(face[0]).transpose().cast<Scalar>() - centre) / static_cast<Scalar>(size);
    halfSpaces.push_back({ normal, -normal.dot(corner) });
  }
  const InscribedBallOf<Scalar> ball = FindInscribedBall(halfSpaces, 1.0);
  placement.Clearance = static_cast<double>(ball.Radius);
  const Vector position = centre + ball.Centre * static_cast<Scalar>(size);
  placement.Position = position.transpose().template cast<double>();
  placement.IsValid = ball.Radius > 0.0 &&
    std::all_of(faces.begin(), faces.end(),
      [&](const StarFace& face) { return SeesFace(points, face, placement.Position); });
  return placement;
}

} // namespace

StarFace FindFaceOpposite(const std::vector<int>& tetrahedron, int point)
{
  static constexpr int opposite[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };
  const auto at = std::find(tetrahedron.begin(), tetrahedron.end(), point) - tetrahedron.begin();
  return { tetrahedron[opposite[at][0]], tetrahedron[opposite[at][1]],
    tetrahedron[opposite[at][2]] };
}

std::vector<StarFace> FindFacesAround(const SolidCells& solid, int point)
{
  std::vector<StarFace> faces;
  for (const int cell : solid.CellsOf(point))
  {
    faces.push_back(FindFaceOpposite(solid.PointsOf(cell), point));
  }
  return faces;
}

bool SeesFace(
  const Eigen::MatrixXd& points, const StarFace& face, const Eigen::RowVector3d& position)
{
  return EvaluateOrientation(
           points.row(face[0]), points.row(face[1]), points.row(face[2]), position) > 0;
}

StarPlacement FindKernelCentre(const Eigen::MatrixXd& points, const std::vector<StarFace>& faces,
  const Eigen::RowVector3d& origin)
{
  /// Doubles tell a kernel that is this much wider from none, relative to the size of the star.
  constexpr double certain = 1e-10;
  const double size = MeasureStar(points, faces, origin);
  const StarPlacement placement = FindKernelCentreIn<double>(points, faces, origin, size);
  return placement.IsValid || placement.Clearance < -certain
    ? placement
    : FindKernelCentreIn<TwoDoubles>(points, faces, origin, size);
}

} // namespace shape
