#pragma once

#include "Geometry/Orientation.h"
#include "Quality/ConformalDistortion.h"
#include "Support/TestShapes.h"

#include <cmath>

// What the tests of maps to the plane share.
namespace shapetest
{

/// A bumpy disk of no symmetry, with bumps of this height.
inline shape::Mesh BumpyDisk(int rings, double height)
{
  shape::Mesh mesh = FlatDisk(rings);
  for (auto point : mesh.Points.rowwise())
  {
    const double x = point(0), y = point(1);
    point(2) = height * std::sin(4.0 * x + 1.0) * std::cos(3.0 * y);
    point(0) *= 1.4 + 0.5 * std::sin(3.0 * y);
  }
  return mesh;
}

/// How many triangles an image (n x 2 or n x 3, of which z is ignored) does not keep
/// counter-clockwise.
inline int CountFlips(const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& image)
{
  int flips = 0;
  for (const auto& corners : triangles.rowwise())
  {
    flips += shape::EvaluateOrientation(image.row(corners(0)).head<2>(),
               image.row(corners(1)).head<2>(), image.row(corners(2)).head<2>()) <= 0;
  }
  return flips;
}

/// The conformal distortion of an image (n x 3), averaged over the area.
inline double MeanDistortion(const shape::Mesh& mesh, const Eigen::MatrixXd& image)
{
  const Eigen::VectorXd areas = shape::ComputeAreaVectors(mesh).rowwise().norm();
  return areas.dot(shape::ComputeConformalDistortion(mesh, image)) / areas.sum();
}

} // namespace shapetest
