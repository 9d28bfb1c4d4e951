#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <cmath>

TEST(LaplacianSmoothing, SpreadsTheStrainEvenly)
{
  const shape::Mesh tube = shapetest::Tube(40, 40, 4.0);
  const shape::BoundaryHandle loop = shape::BuildCurveHandle(tube.Points.topRows(40), true);
  Eigen::MatrixXd target = loop.Positions;
  target.leftCols(2) *= 1.4;
  const shape::HandlePose pose = shape::PoseHandle(loop, target);
  const shape::PointGraph graph = shape::BuildPointGraph(tube);
  const auto largestStrain = [&](bool smooth)
  {
    shape::DeformOptions options;
    options.LaplacianSmoothing = smooth;
    const Eigen::MatrixXd moved = shape::ShapeDeformation(graph, loop, options).Deform(pose).Points;
    EXPECT_LT(shapetest::Largest(moved.topRows(40) - target), 1e-13); // the handle stays
    double largest = 0.0;
    for (const auto& [a, b] : shape::ListLinks(graph))
    {
      const double before = (graph.Positions.row(a) - graph.Positions.row(b)).norm();
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
  const shape::BoundaryHandle loop = shapetest::LoopOf(disk);
  shape::HandlePose pose = shape::GetRestPose(loop);
  const Eigen::RowVector3d slope(0.1, 0.2, -0.3);
  pose.Positions += loop.Positions.col(0) * slope;
  shape::DeformOptions options;
  options.LaplacianSmoothing = true;
  const Eigen::MatrixXd moved =
    shape::ShapeDeformation(shape::BuildPointGraph(disk), loop, options).Deform(pose).Points;
  EXPECT_LT(shapetest::Largest(moved - disk.Points - disk.Points.col(0) * slope), 0.02);
}
