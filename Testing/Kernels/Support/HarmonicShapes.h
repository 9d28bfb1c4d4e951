#pragma once

#include "Harmonic/HarmonicVolumeMap.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

// What the tests of harmonic maps share.
namespace shapetest
{

/// A sphere with soft bumps and a dent.
inline shape::Mesh DentedSphere(int level)
{
  shape::Mesh mesh = Icosphere(level);
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = mesh.Points.row(i);
    mesh.Points.row(i) *= 1.3 - 0.4 * std::exp(-6.0 * (1.0 - p(0))) +
      0.08 * std::sin(3.0 * p(1)) * std::cos(2.0 * p(2));
  }
  return mesh;
}

/// With these options an affine map of a boundary far from the origin is met to 1e-12 of its size.
inline void ExpectAffineMapIsExact(
  shape::Mesh boundary, const shape::HarmonicVolumeMapOptions& options)
{
  boundary.Points.rowwise() += Eigen::RowVector3d(10, -20, 5);
  Eigen::Matrix3d matrix;
  matrix << 2, 0.3, 0, -0.5, 1, 0.2, 0, 0.1, 3;
  const Eigen::MatrixXd targets =
    (boundary.Points * matrix.transpose()).rowwise() + Eigen::RowVector3d(7, 8, 9);
  const auto result = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
  const Eigen::MatrixXd error = shape::Evaluate(result.Map, boundary.Points) - targets;
  EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-12 * shape::ComputeLongestBoxEdge(targets));
}

} // namespace shapetest
