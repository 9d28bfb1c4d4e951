#include "Mesh/Mesh.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace shape
{

double ComputeLongestBoxEdge(const Eigen::MatrixXd& points)
{
  return points.rows() == 0
    ? 0.0
    : (points.colwise().maxCoeff() - points.colwise().minCoeff()).maxCoeff();
}

double ComputeBoxDiagonal(const Eigen::MatrixXd& points)
{
  return points.rows() == 0 ? 0.0
                            : (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

Eigen::MatrixXd ComputeAreaVectors(const Mesh& mesh)
{
  Eigen::MatrixXd vectors(mesh.Triangles.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = mesh.Points.row(mesh.Triangles(t, 0));
    const Eigen::RowVector3d b = mesh.Points.row(mesh.Triangles(t, 1));
    const Eigen::RowVector3d c = mesh.Points.row(mesh.Triangles(t, 2));
    vectors.row(t) = (b - a).cross(c - a);
  }
  return vectors;
}

double ComputeArea(const Mesh& mesh)
{
  return 0.5 * ComputeAreaVectors(mesh).rowwise().norm().sum();
}

Eigen::VectorXd ComputePointAreas(const Mesh& mesh)
{
  const Eigen::VectorXd sixths = ComputeAreaVectors(mesh).rowwise().norm() / 6.0;
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(mesh.Points.rows());
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    for (int corner = 0; corner < 3; ++corner)
    {
      areas(mesh.Triangles(t, corner)) += sixths(t);
    }
  }
  return areas;
}

double ComputeEnclosedVolume(const Mesh& mesh)
{
  // Tetrahedra over the first point instead of the origin: no cancellation far from the origin.
  if (mesh.Triangles.rows() == 0)
  {
    return 0.0;
  }
  const Eigen::RowVector3d apex = mesh.Points.row(0);
  double sixVolumes = 0.0;
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = mesh.Points.row(mesh.Triangles(t, 0)) - apex;
    const Eigen::RowVector3d b = mesh.Points.row(mesh.Triangles(t, 1)) - apex;
    const Eigen::RowVector3d c = mesh.Points.row(mesh.Triangles(t, 2)) - apex;
    sixVolumes += a.dot(b.cross(c));
  }
  return sixVolumes / 6.0;
}

double ComputeWindingNumber(const Eigen::MatrixXd& points, const Eigen::MatrixXi& triangles,
  const Eigen::RowVector3d& position)
{
  // The formula of Van Oosterom and Strackee 1983 for the solid angle of a triangle: tan of half of
  // it is the quotient below. The angles of all triangles sum to 4 pi times the winding number.
  double halfAngles = 0.0;
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    const Eigen::RowVector3d a = points.row(triangles(t, 0)) - position;
    const Eigen::RowVector3d b = points.row(triangles(t, 1)) - position;
    const Eigen::RowVector3d c = points.row(triangles(t, 2)) - position;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    halfAngles +=
      std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return halfAngles / (2.0 * M_PI);
}

Mesh OrientOutwards(Mesh mesh)
{
  if (ComputeEnclosedVolume(mesh) < 0.0)
  {
    mesh.Triangles.col(1).swap(mesh.Triangles.col(2));
  }
  return mesh;
}

Eigen::MatrixXd ComputeCentroids(const Mesh& mesh)
{
  return AverageAtCorners(mesh.Triangles, mesh.Points);
}

Eigen::MatrixXd ComputeOffCentres(const Mesh& mesh)
{
  return InterpolateAtOffCentres(mesh, mesh.Points);
}

Eigen::MatrixXd InterpolateAtOffCentres(const Mesh& mesh, const Eigen::MatrixXd& values)
{
  constexpr std::array<double, 3> shares = { 0.08, 0.27, 0.65 };
  Eigen::MatrixXd positions(mesh.Triangles.rows(), values.cols());
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    std::array<int, 3> corners = { mesh.Triangles(t, 0), mesh.Triangles(t, 1),
      mesh.Triangles(t, 2) };
    // The order by position does not depend on the indices.
    std::sort(corners.begin(), corners.end(),
      [&](int a, int b)
      {
        const auto p = mesh.Points.row(a), q = mesh.Points.row(b);
        return std::array<double, 3>{ p(0), p(1), p(2) } <
          std::array<double, 3>{ q(0), q(1), q(2) };
      });
    positions.row(t) = shares[0] * values.row(corners[0]) + shares[1] * values.row(corners[1]) +
      shares[2] * values.row(corners[2]);
  }
  return positions;
}

Eigen::MatrixXd SampleRandomly(const Mesh& mesh, int count, unsigned int seed)
{
  const Eigen::VectorXd areas = ComputeAreaVectors(mesh).rowwise().norm();
  std::mt19937 random(seed);
  std::discrete_distribution<int> triangle(areas.begin(), areas.end());
  std::uniform_real_distribution<double> uniform;
  Eigen::MatrixXd positions(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const Eigen::Matrix3d corners = GetCorners(mesh, triangle(random));
    // The square root makes positions uniform in the triangle.
    const double root = std::sqrt(uniform(random)), along = uniform(random);
    positions.row(i) = Eigen::RowVector3d(1.0 - root, root * (1.0 - along), root * along) * corners;
  }
  return positions;
}

Eigen::MatrixXd AverageAtCorners(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values)
{
  Eigen::MatrixXd means(triangles.rows(), values.cols());
  for (Eigen::Index t = 0; t < triangles.rows(); ++t)
  {
    means.row(t) =
      (values.row(triangles(t, 0)) + values.row(triangles(t, 1)) + values.row(triangles(t, 2))) /
      3.0;
  }
  return means;
}

} // namespace shape
