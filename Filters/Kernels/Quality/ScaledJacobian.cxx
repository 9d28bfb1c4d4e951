#include "Quality/ScaledJacobian.h"

#include "Base/Parallel.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shape
{
namespace
{

double Scaled(const Eigen::RowVector3d& a, const Eigen::RowVector3d& b, const Eigen::RowVector3d& c)
{
  // The determinant of the edges at unit length. An edge without length is the worst case.
  const double lengths = a.norm() * b.norm() * c.norm();
  return lengths > 0.0 ? std::clamp(a.dot(b.cross(c)) / lengths, -1.0, 1.0) : -1.0;
}

} // namespace

double ComputeScaledJacobian(const Eigen::Matrix<double, 8, 3>& corners)
{
  double minimum = 1.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const int* ends = HexNeighbours[corner];
    const auto edge = [&](int k) -> Eigen::RowVector3d
    { return corners.row(ends[k]) - corners.row(corner); };
    minimum = std::min(minimum, Scaled(edge(0), edge(1), edge(2)));
  }
  // At the centre the edges are replaced by the axes between opposite faces.
  const auto between = [&](const int* low, const int* high)
  {
    Eigen::RowVector3d axis = Eigen::RowVector3d::Zero();
    for (int k = 0; k < 4; ++k)
    {
      axis += corners.row(high[k]) - corners.row(low[k]);
    }
    return axis;
  };
  return std::min(minimum,
    Scaled(between(HexFaces[0], HexFaces[1]), between(HexFaces[2], HexFaces[3]),
      between(HexFaces[4], HexFaces[5])));
}

Eigen::VectorXd ComputeScaledJacobians(const HexMesh& mesh)
{
  Eigen::VectorXd values(mesh.Hexahedra.rows());
  ParallelFor(static_cast<int>(values.size()), 1024,
    [&](int begin, int end)
    {
      Eigen::Matrix<double, 8, 3> corners;
      for (int hex = begin; hex < end; ++hex)
      {
        for (int k = 0; k < 8; ++k)
        {
          corners.row(k) = mesh.Points.row(mesh.Hexahedra(hex, k));
        }
        values(hex) = ComputeScaledJacobian(corners);
      }
    });
  return values;
}

double FindMinimumScaledJacobianAwayFrom(const std::vector<int>& points, const HexMesh& mesh)
{
  const Eigen::VectorXd values = ComputeScaledJacobians(mesh);
  std::vector<char> isGiven(mesh.Points.rows(), 0);
  for (const int point : points)
  {
    isGiven[point] = 1;
  }
  double minimum = 1.0;
  for (Eigen::Index hex = 0; hex < values.size(); ++hex)
  {
    const auto corners = mesh.Hexahedra.row(hex);
    if (std::none_of(
          corners.begin(), corners.end(), [&](int point) { return isGiven[point] != 0; }))
    {
      minimum = std::min(minimum, values(hex));
    }
  }
  return minimum;
}

std::vector<char> MarkPointsOfBadHexahedra(const HexMesh& mesh, double bad)
{
  return MarkPointsOfBadHexahedra(
    mesh.Hexahedra, ComputeScaledJacobians(mesh), mesh.Points.rows(), bad);
}

} // namespace shape
