#include "Correspondence/Landmarks/LandmarkEmbedding.h"

#include "Geodesics/HeatGeodesics.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace shape
{
namespace
{

/// The gradients of functions (n x k) at points of a mesh, and the normals there: means over the
/// triangles around.
struct PointGradients
{
  std::vector<Eigen::Matrix3Xd> Gradients; ///< s of 3 x k, of unit length; 0 if there is none
  Eigen::Matrix3Xd Normals;                ///< 3 x s, of unit length
};

PointGradients GradientsAt(
  const Mesh& mesh, const Eigen::MatrixXd& functions, const std::vector<int>& points)
{
  std::vector<int> position(mesh.Points.rows(), -1);
  for (int s = 0; s < static_cast<int>(points.size()); ++s)
  {
    position[points[s]] = s;
  }
  PointGradients at;
  at.Gradients.assign(points.size(), Eigen::Matrix3Xd::Zero(3, functions.cols()));
  at.Normals = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i triangle = mesh.Triangles.row(t);
    const Eigen::Matrix3d corners = GetCorners(mesh, t).transpose();
    const Eigen::Vector3d normal =
      (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const double area = normal.norm();
    if (!(area > 0.0))
    {
      continue;
    }
    Eigen::Matrix3Xd gradients =
      Eigen::Matrix3Xd::Zero(3, functions.cols()); // multiplied by twice the area
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::Vector3d opposite = corners.col((c + 2) % 3) - corners.col((c + 1) % 3);
      // The gradient of a linear function is the sum over corners of value times n x opposite edge,
      // over twice the area.
      gradients += (normal / area).cross(opposite) * functions.row(triangle(c));
    }
    for (const int corner : triangle)
    {
      if (position[corner] >= 0)
      {
        // Weighted by area, as the length of the cross product is.
        at.Normals.col(position[corner]) += normal;
        at.Gradients[position[corner]] += gradients;
      }
    }
  }
  at.Normals.colwise().normalize();
  for (Eigen::Matrix3Xd& gradients : at.Gradients)
  {
    gradients.colwise().normalize();
  }
  return at;
}

} // namespace

Eigen::MatrixXd ComputeGradientOrientations(
  const Mesh& mesh, const Eigen::MatrixXd& functions, const std::vector<int>& points)
{
  const PointGradients at = GradientsAt(mesh, functions, points);
  const Eigen::Index features = functions.cols();
  Eigen::MatrixXd turns(at.Normals.cols(), features * features);
  for (Eigen::Index s = 0; s < turns.rows(); ++s)
  {
    const Eigen::Matrix3Xd& gradients = at.Gradients[s];
    for (Eigen::Index i = 0; i < features; ++i)
    {
      // The dot product with n x g_i is the sine of the angle from g_i to g_j.
      const Eigen::Vector3d across = at.Normals.col(s).cross(gradients.col(i));
      turns.row(s).segment(i * features, features) = across.transpose() * gradients;
    }
  }
  return turns;
}

Eigen::MatrixXd EmbedByDistances(const Eigen::MatrixXd& distances, const Eigen::MatrixXd& turns,
  const std::vector<int>& chosen, double turnSign)
{
  // A right angle has the weight of about a seventh of the surface's size, the root of its area.
  constexpr double weight = 0.15;
  const auto functions = static_cast<int>(std::lround(std::sqrt(turns.cols())));
  const auto count = static_cast<int>(chosen.size());
  std::vector<int> columns;
  for (int i = 0; i < std::min(count, functions); ++i)
  {
    for (int j = 0; j < i; ++j)
    {
      columns.push_back(chosen[i] * functions + chosen[j]);
    }
  }
  const auto pairs = static_cast<int>(columns.size());
  Eigen::MatrixXd positions(distances.rows(), count + pairs);
  // Divided by the roots of their numbers, so that distances of rows do not grow with the number of
  // landmarks.
  positions.leftCols(count) = distances(Eigen::all, chosen) / std::sqrt(count);
  positions.rightCols(pairs) =
    turnSign * weight / std::sqrt(std::max(pairs, 1)) * turns(Eigen::all, columns);
  return positions;
}

Eigen::MatrixXd EmbedByLandmarks(
  const Surface& surface, const std::vector<int>& landmarks, const Progress& progress)
{
  return EmbedByLandmarks(
    surface, landmarks, std::sqrt(ComputePointAreas(surface).sum()), progress);
}

Eigen::MatrixXd EmbedByLandmarks(const Surface& surface, const std::vector<int>& landmarks,
  double length, const Progress& progress)
{
  const Eigen::MatrixXd distances = ComputeHeatDistances(surface, landmarks, progress) / length;
  std::vector<int> all(surface.Points().rows()), chosen(landmarks.size());
  std::iota(all.begin(), all.end(), 0);
  std::iota(chosen.begin(), chosen.end(), 0);
  constexpr Eigen::Index maximum = 12; // the number of orientations grows with the square
  const Eigen::Index count = std::min(maximum, distances.cols());
  return EmbedByDistances(
    distances, ComputeGradientOrientations(surface, distances.leftCols(count), all), chosen, 1.0);
}

} // namespace shape
