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
    const Eigen::Vector3d p = (points.row(face[0]) - origin).transpose() / size,
                          q = (points.row(face[1]) - origin).transpose() / size,
                          r = (points.row(face[2]) - origin).transpose() / size;
    const Eigen::Vector3d normal = (q - p).cross(r - p);
    const double length = normal.norm();
    if (!(length > 0.0))
    {
      return placement;
    }
    halfSpaces.push_back({ normal / length, -normal.dot(p) / length });
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
