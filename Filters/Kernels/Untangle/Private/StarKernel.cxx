#include "Untangle/Private/StarKernel.h"

#include "Geometry/Orientation.h"
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
/// close to each other are exact, and so are their products in long double but for the last bits.
Eigen::Vector3d FindNormal(const Eigen::MatrixXd& points, const StarFace& face)
{
  using Vector = Eigen::Matrix<long double, 3, 1>;
  const Vector a = (points.row(face[1]) - points.row(face[0])).transpose().cast<long double>(),
               b = (points.row(face[2]) - points.row(face[0])).transpose().cast<long double>();
  const Vector normal = a.cross(b);
  const long double length = normal.norm();
  return length > 0.0L ? Eigen::Vector3d((normal / length).cast<double>())
                       : Eigen::Vector3d::Zero();
}

} // namespace

StarFace FindFaceOpposite(const std::vector<int>& tetrahedron, int point)
{
  static constexpr int opposite[4][3] = { { 1, 3, 2 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 1, 2 } };
  const auto at = std::find(tetrahedron.begin(), tetrahedron.end(), point) - tetrahedron.begin();
  return { tetrahedron[opposite[at][0]], tetrahedron[opposite[at][1]],
    tetrahedron[opposite[at][2]] };
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
  StarPlacement placement;
  placement.Position = origin;
  const double size = MeasureStar(points, faces, origin);
  std::vector<HalfSpace> halfSpaces;
  halfSpaces.reserve(faces.size());
  for (const StarFace& face : faces)
  {
    const Eigen::Vector3d normal = FindNormal(points, face);
    if (normal.isZero(0.0))
    {
      return placement;
    }
    const Eigen::Vector3d corner = (points.row(face[0]) - origin).transpose() / size;
    halfSpaces.push_back({ normal, -normal.dot(corner) });
  }
  const InscribedBall ball = FindInscribedBall(halfSpaces, 1.0);
  placement.Clearance = ball.Radius;
  placement.Position = origin + size * ball.Centre.transpose();
  placement.IsValid = ball.Radius > 0.0 &&
    std::all_of(faces.begin(), faces.end(),
      [&](const StarFace& face) { return SeesFace(points, face, placement.Position); });
  return placement;
}

} // namespace shape
