#include "Surface/ClassicalScaling.h"

#include "Core/Errors.h"
#include "Core/Topology.h"
#include "Surface/EdgeGeodesics.h"
#include "Surface/HeatGeodesics.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace shape
{
namespace
{

/// A point that triangles use, each the farthest from those before; fewer where there are no more.
std::vector<int> FarthestPoints(const Mesh& mesh, int count, const Progress& progress)
{
  std::vector<int> samples = { mesh.Triangles.minCoeff() };
  Eigen::VectorXd nearest = Eigen::VectorXd::Constant(mesh.Points.rows(), -1.0);
  for (const int point : mesh.Triangles.reshaped())
  {
    nearest(point) = std::numeric_limits<double>::infinity();
  }
  while (static_cast<int>(samples.size()) < count)
  {
    nearest =
      nearest.cwiseMin(EdgeGeodesics(mesh, { { samples.back() }, Eigen::VectorXd::Zero(1) }));
    Eigen::Index farthest = 0;
    if (nearest.maxCoeff(&farthest) <= 0.0)
    {
      break;
    }
    samples.push_back(static_cast<int>(farthest));
    progress(static_cast<double>(samples.size()) / count);
  }
  return samples;
}

/// n x s: from each sample; 0 at points without a triangle.
Eigen::MatrixXd DistancesFrom(
  const Mesh& mesh, const std::vector<int>& samples, const Progress& progress)
{
  std::vector<int> cornerOf(mesh.Points.rows(), -1);
  for (int corner = 0; corner < static_cast<int>(mesh.Triangles.size()); ++corner)
  {
    cornerOf[mesh.Triangles(corner / 3, corner % 3)] = corner;
  }
  const HeatGeodesics geodesics(mesh, progress.Part(0.0, 0.1));
  Eigen::MatrixXd distances(mesh.Points.rows(), static_cast<Eigen::Index>(samples.size()));
  for (Eigen::Index i = 0; i < distances.cols(); ++i)
  {
    const int corner = cornerOf[samples[i]];
    const ClosestPoints place{ Eigen::VectorXi::Constant(1, corner / 3),
      Eigen::RowVector3d::Unit(corner % 3), mesh.Points.row(samples[i]), Eigen::VectorXd::Zero(1) };
    const Eigen::VectorXd from = geodesics.Distances(place);
    distances.col(i) = from.array().isFinite().select(from, 0.0);
    progress(0.1 + 0.9 * (static_cast<double>(i) + 1.0) / static_cast<double>(distances.cols()));
  }
  return distances;
}

} // namespace

Eigen::MatrixXd ClassicalScaling(
  const Mesh& mesh, int dimensions, int samples, const Progress& progress)
{
  const Topology topology = RequireManifold(mesh, "the surface");
  if (topology.Components > 1)
  {
    throw InvalidInput("the surface has " + std::to_string(topology.Components) +
      " components, between which there are no distances; give one of them, or use the spectral "
      "embedding");
  }
  const std::vector<int> points = FarthestPoints(mesh, samples, progress.Part(0.0, 0.2));
  const Eigen::MatrixXd squares =
    DistancesFrom(mesh, points, progress.Part(0.2, 0.9)).array().square();
  Eigen::MatrixXd between = squares(points, Eigen::all);
  between = 0.5 * (between + between.transpose()).eval();
  const Eigen::VectorXd means = between.rowwise().mean();
  const Eigen::MatrixXd products =
    -0.5 * ((between.colwise() - means).rowwise() - means.transpose()).array() - 0.5 * means.mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(products);
  progress(0.95);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(mesh.Points.rows(), dimensions);
  const int count = std::min<int>(dimensions, static_cast<int>(points.size()));
  for (int k = 0; k < count; ++k)
  {
    const Eigen::Index last = products.cols() - 1 - k;
    constexpr double least = 1e-9; // of the largest; others are of rounding, or there are none
    const double value = axes.eigenvalues()(last);
    if (value > least * axes.eigenvalues().maxCoeff())
    {
      const Eigen::VectorXd pseudo = axes.eigenvectors().col(last) / std::sqrt(value);
      result.col(k) = -0.5 * ((squares.rowwise() - means.transpose()) * pseudo);
      Eigen::Index largest = 0;
      result.col(k).cwiseAbs().maxCoeff(&largest);
      result.col(k) *= result(largest, k) < 0.0 ? -1.0 : 1.0;
    }
  }
  for (Eigen::Index i = 0; i < result.rows(); ++i)
  {
    if (topology.ComponentId(i) < 0)
    {
      result.row(i).setZero();
    }
  }
  progress(1.0);
  return result;
}

} // namespace shape
