#include "Correspondence/FeaturedSurface.h"

#include "Correspondence/PersistentMaxima.h"
#include "Surface/EdgeGeodesics.h"
#include "Surface/HeatGeodesics.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace shape
{
namespace
{

/// Adds the points farthest along edges from `points` until there are `count`, or all.
void AddFarthest(const Mesh& mesh, std::vector<int>& points, int count, const Progress& progress)
{
  while (static_cast<int>(points.size()) < count)
  {
    const auto size = static_cast<Eigen::Index>(points.size());
    Eigen::Index farthest = 0;
    EdgeGeodesics(mesh, { points, Eigen::VectorXd::Zero(size) }, progress).maxCoeff(&farthest);
    if (std::find(points.begin(), points.end(), static_cast<int>(farthest)) != points.end())
    {
      return;
    }
    points.push_back(static_cast<int>(farthest));
  }
}

/// The gradients of functions (n x k) at points of a mesh, and the normals there: means over the
/// triangles around.
struct PointGradients
{
  std::vector<Eigen::Matrix3Xd> Gradients; ///< s of 3 x k, of unit length; 0 where there is none
  Eigen::Matrix3Xd Normals;                ///< 3 x s, of unit length
};

PointGradients GradientsAt(
  const Mesh& mesh, const Eigen::MatrixXd& functions, const std::vector<int>& points)
{
  std::vector<int> place(mesh.Points.rows(), -1);
  for (int s = 0; s < static_cast<int>(points.size()); ++s)
  {
    place[points[s]] = s;
  }
  PointGradients at;
  at.Gradients.assign(points.size(), Eigen::Matrix3Xd::Zero(3, functions.cols()));
  at.Normals = Eigen::Matrix3Xd::Zero(3, static_cast<Eigen::Index>(points.size()));
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i triangle = mesh.Triangles.row(t);
    const Eigen::Matrix3d corners = Corners(mesh, t).transpose();
    const Eigen::Vector3d normal =
      (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
    const double area = normal.norm();
    if (!(area > 0.0))
    {
      continue;
    }
    Eigen::Matrix3Xd gradients =
      Eigen::Matrix3Xd::Zero(3, functions.cols()); // times twice the area
    for (int c = 0; c < 3; ++c)
    {
      const Eigen::Vector3d opposite = corners.col((c + 2) % 3) - corners.col((c + 1) % 3);
      gradients += (normal / area).cross(opposite) * functions.row(triangle(c));
    }
    for (const int corner : triangle)
    {
      if (place[corner] >= 0)
      {
        at.Normals.col(place[corner]) += normal;
        at.Gradients[place[corner]] += gradients;
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

Eigen::MatrixXd FindTurns(const PointGradients& at)
{
  const Eigen::Index features = at.Gradients[0].cols();
  Eigen::MatrixXd turns(at.Normals.cols(), features * features);
  for (Eigen::Index s = 0; s < turns.rows(); ++s)
  {
    const Eigen::Matrix3Xd& gradients = at.Gradients[s];
    for (Eigen::Index i = 0; i < features; ++i)
    {
      const Eigen::Vector3d across = at.Normals.col(s).cross(gradients.col(i));
      turns.row(s).segment(i * features, features) = across.transpose() * gradients;
    }
  }
  return turns;
}

} // namespace

FeaturedSurface FindFeatures(const Mesh& mesh, int samples, int features, const Progress& progress)
{
  constexpr double least = 0.02; // persistence; less is noise
  constexpr int fewest = 6;
  const SampledSurface sampled = SampleSurface(mesh, samples, progress.Part(0.0, 0.9));
  const Eigen::VectorXd remoteness = sampled.Distances * sampled.Weights;
  FeaturedSurface surface;
  surface.Features = PersistentMaxima(mesh.Triangles, remoteness, least, features);
  AddFarthest(mesh, surface.Features, fewest, progress.Part(0.9, 0.9));
  const Eigen::MatrixXd distances =
    HeatDistances(mesh, surface.Features, progress.Part(0.9, 1.0)) / sampled.Length;
  const Eigen::MatrixXd apart = distances(surface.Features, Eigen::all);
  surface.Remoteness = remoteness(surface.Features);
  surface.Apart = 0.5 * (apart + apart.transpose());
  surface.Weights = sampled.Weights;
  surface.Between = sampled.Between();
  surface.ToFeatures = distances(sampled.Points, Eigen::all);
  surface.Turns = FindTurns(GradientsAt(mesh, distances, sampled.Points));
  return surface;
}

} // namespace shape
