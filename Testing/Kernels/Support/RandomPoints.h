#pragma once

#include <Eigen/Core>

#include <random>

// The same random points on every machine.
namespace shapetest
{

/// In the cube [-halfEdge, halfEdge]^3.
inline Eigen::MatrixXd RandomPointsInCube(int count, double halfEdge, unsigned int seed)
{
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd points(count, 3);
  for (double& value : points.reshaped())
  {
    value = halfEdge * (2.0 * static_cast<double>(generator() >> 11) * 0x1p-53 - 1.0);
  }
  return points;
}

/// In the cube [-1, 1]^3: the next of a sequence.
inline Eigen::MatrixXd RandomPoints(int count, std::mt19937& random)
{
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(count, 3, [&] { return uniform(random); });
}

/// Entries in [-1, 1].
inline Eigen::MatrixXd RandomMatrix(int rows, int columns, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  return Eigen::MatrixXd::NullaryExpr(
    rows, columns, [&](Eigen::Index, Eigen::Index) { return uniform(generator); });
}

/// In the square [0, 1)^2.
inline Eigen::MatrixXd RandomPointsInSquare(int count, unsigned int seed)
{
  std::mt19937 generator(seed);
  Eigen::MatrixXd points(count, 2);
  for (double& value : points.reshaped())
  {
    value = static_cast<double>(generator()) / 4294967296.0;
  }
  return points;
}

} // namespace shapetest
