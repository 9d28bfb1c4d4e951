#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(LaplacianSmoothing, SpreadsTheStrainEvenly)
{
  const shape::Mesh tube = shapetest::Tube(40, 40, 4.0);
  const shape::BoundaryHandle rim = shape::CurveHandle(tube.Points.topRows(40), true);
  Eigen::MatrixXd target = rim.Places;
  target.leftCols(2) *= 1.4;
  const shape::HandlePose pose = shape::PoseHandle(rim, target);
  const shape::PointGraph graph = shape::MakePointGraph(tube);
  const auto largestStrain = [&](bool smooth)
  {
    shape::DeformOptions options;
    options.LaplacianSmoothing = smooth;
    const Eigen::MatrixXd moved = shape::ShapeDeformation(graph, rim, options).Deform(pose).Points;
    EXPECT_LT(shapetest::Largest(moved.topRows(40) - target), 1e-13); // the handle stays
    double largest = 0.0;
    for (const auto& [a, b] : shape::LinksOf(graph))
    {
      const double before = (graph.Places.row(a) - graph.Places.row(b)).norm();
      const bool inner = a >= 40 || b >= 40;
      largest = std::max(
        largest, inner ? std::abs((moved.row(a) - moved.row(b)).norm() / before - 1.0) : 0.0);
    }
    return largest;
  };
  EXPECT_LT(largestStrain(true), 0.97 * largestStrain(false));
}

TEST(LaplacianSmoothing, IsOneSolutionForAllPlaces)
{
  // On a flat disk whose frames stay, equation 3 says: the shift is harmonic. A linear shift of the
  // rim is one of all.
  const shape::Mesh disk = shapetest::FlatDisk(12);
  const shape::BoundaryHandle rim = shapetest::RimOf(disk);
  shape::HandlePose pose = shape::RestPose(rim);
  const Eigen::RowVector3d slope(0.1, 0.2, -0.3);
  pose.Places += rim.Places.col(0) * slope;
  shape::DeformOptions options;
  options.LaplacianSmoothing = true;
  const Eigen::MatrixXd moved =
    shape::ShapeDeformation(shape::MakePointGraph(disk), rim, options).Deform(pose).Points;
  EXPECT_LT(shapetest::Largest(moved - disk.Points - disk.Points.col(0) * slope), 0.02);
}
