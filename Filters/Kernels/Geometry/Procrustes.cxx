#include "Geometry/Procrustes.h"

#include "Geometry/FitRotation.h"

#include <cmath>
#include <utility>

namespace shape
{

Eigen::MatrixXd MoveToCentre(const Eigen::MatrixXd& points, const Eigen::VectorXd& weights)
{
  return points.rowwise() - (weights.transpose() * points).eval() / weights.sum();
}

Eigen::Matrix3d FitRotation(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& target, const Eigen::VectorXd& weights)
{
  return FitRotation(target.transpose() * weights.asDiagonal() * points);
}

double RootMeanSquare(const Eigen::MatrixXd& rows, const Eigen::VectorXd& weights)
{
  return std::sqrt(weights.dot(rows.rowwise().squaredNorm()) / weights.sum());
}

Superimposed Superimpose(std::vector<Eigen::MatrixXd> shapes, const Eigen::VectorXd& weights,
  bool scale, const Progress& progress)
{
  Superimposed result;
  const auto count = static_cast<Eigen::Index>(shapes.size());
  result.Sizes.resize(count);
  result.Scales.setOnes(count);
  result.Rotations.assign(count, Eigen::Matrix3d::Identity());
  for (Eigen::Index i = 0; i < count; ++i)
  {
    shapes[i] = MoveToCentre(shapes[i], weights);
    result.Sizes(i) = RootMeanSquare(shapes[i], weights);
  }
  if (scale)
  {
    result.Scales = result.Sizes.cwiseInverse() * result.Sizes.mean();
    for (Eigen::Index i = 0; i < count; ++i)
    {
      shapes[i] *= result.Scales(i);
    }
  }
  const auto turn = [&](Eigen::Index i, const Eigen::Matrix3d& rotation)
  {
    shapes[i] *= rotation.transpose();
    result.Rotations[i] = rotation * result.Rotations[i];
  };
  const Eigen::MatrixXd first = shapes[0];
  result.Mean = first;
  constexpr int rounds = 100;
  constexpr double fixed = 1e-12;
  for (int round = 0; round < rounds; ++round)
  {
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(first.rows(), 3);
    for (Eigen::Index i = 0; i < count; ++i)
    {
      progress((round + static_cast<double>(i) / static_cast<double>(count)) / rounds);
      turn(i, FitRotation(shapes[i], result.Mean, weights));
      mean += shapes[i] / static_cast<double>(count);
    }
    const double change = RootMeanSquare(mean - result.Mean, weights);
    result.Mean = std::move(mean);
    if (change <= fixed * RootMeanSquare(result.Mean, weights))
    {
      break;
    }
  }
  const Eigen::Matrix3d back = FitRotation(result.Mean, first, weights);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    turn(i, back);
  }
  result.Mean *= back.transpose();
  result.Shapes = std::move(shapes);
  progress(1.0);
  return result;
}

} // namespace shape
