#include "Deform/Private/SegmentHierarchy.h"
#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using shapetest::Largest;

/// A strip along x with two tall bumps that are near each other; labels: 0, and 1 and 2 on the
/// bumps.
struct TwoBumps
{
  TwoBumps()
    : Surface(shapetest::FlatSquare(60, 0.0))
    , Labels(Eigen::VectorXi::Zero(Surface.Points.rows()))
    , Tips{ 0, 0 }
  {
    this->Surface.Points.col(1) *= 0.4;
    for (int i = 0; i < this->Surface.Points.rows(); ++i)
    {
      for (const int side : { -1, 1 })
      {
        const Eigen::RowVector2d centre(Position * side, 0.0);
        const double r = (this->Surface.Points.row(i).head<2>() - centre).norm();
        int& tip = this->Tips[side > 0 ? 0 : 1];
        if (r < 0.25)
        {
          this->Surface.Points(i, 2) = 0.8 * std::pow(std::cos(0.5 * M_PI * r / 0.25), 2.0);
          this->Labels(i) = side > 0 ? 1 : 2;
          tip = this->Surface.Points(i, 2) > this->Surface.Points(tip, 2) ? i : tip;
        }
      }
    }
  }

  static constexpr double Position = 0.3; ///< of the bumps' middles, on both sides
  shape::Mesh Surface;
  Eigen::VectorXi Labels;
  int Tips[2];
};

} // namespace

TEST(SegmentHierarchy, NeighbouringBumpsDoNotStickTogether)
{
  // The strip is bent: each bump ought to lean outwards with the strip below it. The front climbs
  // both at the same time, and so keeps them side by side; segments let them go.
  constexpr double radius = 0.8;
  const TwoBumps bumps;
  const shape::BoundaryHandle loop = shapetest::LoopOf(bumps.Surface);
  const shape::HandlePose pose = shape::PoseHandle(loop, shapetest::Bent(loop.Positions, radius));
  const shape::PointGraph graph = shape::BuildPointGraph(bumps.Surface);
  shape::DeformFields fields;
  fields.Segments = bumps.Labels;
  for (const auto resolution : { shape::DeformOptions::MultiresolutionType::On,
         shape::DeformOptions::MultiresolutionType::Off })
  {
    shape::DeformOptions options;
    options.Multiresolution = resolution;
    const shape::DeformedShape together =
      shape::ShapeDeformation(graph, loop, options).Deform(pose);
    const shape::ShapeDeformation parts(graph, loop, options, fields);
    EXPECT_EQ(parts.Facts().Segments, 3);
    const shape::DeformedShape apart = parts.Deform(pose);
    const auto leaning = [&](const shape::DeformedShape& shape, int tip)
    {
      const Eigen::Vector3d up = shape.Rotations[bumps.Tips[tip]].col(2);
      return (tip == 0 ? 1.0 : -1.0) * std::atan2(up(0), up(2));
    };
    constexpr double ideal = TwoBumps::Position / radius;
    for (const int tip : { 0, 1 })
    {
      EXPECT_LT(leaning(together, tip), 0.3 * ideal);
      EXPECT_NEAR(leaning(apart, tip), ideal, 0.4 * ideal);
    }
    const auto gap = [&](const Eigen::MatrixXd& points)
    { return (points.row(bumps.Tips[0]) - points.row(bumps.Tips[1])).norm(); };
    EXPECT_GT(gap(apart.Points), 1.3 * gap(together.Points));
  }
}

TEST(SegmentHierarchy, OneLabelIsNoLabel)
{
  const shape::Mesh cap = shapetest::Cap(12);
  const shape::BoundaryHandle loop = shapetest::LoopOf(cap);
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  const shape::HandlePose pose = shape::PoseHandle(loop, shapetest::Bent(loop.Positions, 1.0));
  shape::DeformFields fields;
  fields.Segments = Eigen::VectorXi::Constant(cap.Points.rows(), 7);
  const shape::ShapeDeformation one(graph, loop, {}, fields);
  EXPECT_EQ(one.Facts().Segments, 1);
  EXPECT_LT(
    Largest(one.Deform(pose).Points - shape::ShapeDeformation(graph, loop).Deform(pose).Points),
    1e-13);
}

TEST(SegmentHierarchy, ARigidMotionStaysExactWhateverTheLabels)
{
  const shape::Mesh cap = shapetest::Cap(12);
  const shape::BoundaryHandle loop = shapetest::LoopOf(cap);
  shape::DeformFields fields;
  fields.Segments = Eigen::VectorXi::Zero(cap.Points.rows());
  for (int i = 0; i < fields.Segments.size(); ++i)
  {
    fields.Segments(i) = (i * 2654435761u >> 8) % 3u; // a mess of many parts
  }
  const Eigen::Matrix3d turn = shapetest::SomeRotation();
  const Eigen::MatrixXd target = shapetest::Moved(loop.Positions, turn, 1.0, { 1, 2, 3 });
  const shape::ShapeDeformation parts(shape::BuildPointGraph(cap), loop, {}, fields);
  EXPECT_GT(parts.Facts().Segments, 20);
  EXPECT_LT(Largest(parts.Deform(shape::PoseHandle(loop, target)).Points -
              shapetest::Moved(cap.Points, turn, 1.0, { 1, 2, 3 })),
    1e-12 * shape::ComputeBoxDiagonal(cap.Points));
  EXPECT_EQ(parts.Deform(shape::GetRestPose(loop)).Points, cap.Points);
}
