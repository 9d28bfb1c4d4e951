#include "Deform/Private/CoarseShape.h"
#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

using Options = shape::DeformOptions;
using shapetest::Largest;

Options With(Options::MultiresolutionType resolution)
{
  Options options;
  options.Multiresolution = resolution;
  return options;
}

} // namespace

TEST(CoarseShape, IsCoarseEvenAndSmooth)
{
  // A sphere with noise of a tenth of its edges: the base is nearer to the sphere, and no smaller.
  shape::Mesh sphere = shapetest::Icosphere(5);
  for (int i = 0; i < sphere.Points.rows(); ++i)
  {
    sphere.Points.row(i) *= 1.0 + 0.004 * std::sin(1e4 * i);
  }
  const shape::PointGraph graph = shape::BuildPointGraph(sphere);
  const std::vector<int> kept = { 3, 1000, 7 };
  const shape::CoarseShape base = shape::BuildCoarseShape(graph, kept, 1000);
  EXPECT_EQ(base.Graph.Size(), 1003);
  EXPECT_NEAR(base.Graph.Weights.sum(), graph.Weights.sum(), 0.05 * graph.Weights.sum());
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(base.Graph.Positions.row(base.Sources[k]), graph.Positions.row(kept[k]));
    EXPECT_EQ(base.BaseOf[kept[k]], base.Sources[k]);
  }
  const Eigen::ArrayXd radii = base.Graph.Positions.rowwise().norm();
  EXPECT_NEAR(radii.mean(), 1.0, 0.01);
  EXPECT_LT(std::sqrt((radii - radii.mean()).square().mean()), 0.004);
  // Even: no link is much longer than the mean, and each fine node is near its base node.
  EXPECT_LT(*std::max_element(base.Graph.Lengths.begin(), base.Graph.Lengths.end()),
    3.0 * base.Graph.MeanLength);
  for (int i = 0; i < graph.Size(); ++i)
  {
    EXPECT_LT((graph.Positions.row(i) - base.Graph.Positions.row(base.BaseOf[i])).norm(),
      2.0 * base.Graph.MeanLength);
  }
}

TEST(MultiresolutionDeformation, IsCloseToTheFullOne)
{
  const shape::Mesh cap = shapetest::Cap(60); // 10981 points
  const shape::BoundaryHandle loop = shapetest::LoopOf(cap);
  const shape::PointGraph graph = shape::BuildPointGraph(cap);
  const shape::HandlePose pose = shape::PoseHandle(loop, shapetest::Bent(loop.Positions, 1.0));
  const shape::ShapeDeformation full(graph, loop, With(Options::MultiresolutionType::Off));
  const shape::ShapeDeformation coarse(graph, loop, With(Options::MultiresolutionType::Automatic));
  EXPECT_EQ(full.Facts().BasePoints, 0);
  EXPECT_EQ(coarse.Facts().BasePoints, 1000 + loop.Positions.rows());
  const shape::DeformedShape one = full.Deform(pose), other = coarse.Deform(pose);
  EXPECT_GT(Largest(one.Points - cap.Points), 0.5);
  EXPECT_LT(Largest(one.Points - other.Points), 0.03 * shape::ComputeBoxDiagonal(cap.Points));
  // Beside the handle, which is exact, no edge is stretched more than in full.
  const auto largestStrain = [&](const shape::DeformedShape& shape)
  {
    double strain = 0.0;
    for (const auto& [i, j] : shape::ListLinks(graph))
    {
      if (std::min(full.Arrivals()(i), full.Arrivals()(j)) == 0.0)
      {
        const double rest = (graph.Positions.row(i) - graph.Positions.row(j)).norm();
        strain = std::max(
          strain, std::abs((shape.Points.row(i) - shape.Points.row(j)).norm() / rest - 1.0));
      }
    }
    return strain;
  };
  EXPECT_LT(largestStrain(other), largestStrain(one) + 0.02);
  // Small detail is as sharp: the triangles' normals differ as little as the places do.
  const Eigen::MatrixXd a =
    shape::ComputeAreaVectors({ one.Points, cap.Triangles }).rowwise().normalized();
  const Eigen::MatrixXd b =
    shape::ComputeAreaVectors({ other.Points, cap.Triangles }).rowwise().normalized();
  std::vector<double> angles;
  for (Eigen::Index t = 0; t < a.rows(); ++t)
  {
    angles.push_back(std::acos(std::clamp(a.row(t).dot(b.row(t)), -1.0, 1.0)));
  }
  std::sort(angles.begin(), angles.end());
  EXPECT_LT(angles[angles.size() / 2], 0.05);
  EXPECT_LT(angles[angles.size() * 95 / 100], 0.15);
}

TEST(MultiresolutionDeformation, AnEvenStretchLeavesNoTraceOfTheBase)
{
  // A flat disk whose rim is stretched along x: in full, a smooth field. What the base adds to it
  // is seen as differences between neighbours.
  const shape::Mesh disk = shapetest::FlatDisk(50);
  const shape::BoundaryHandle loop = shapetest::LoopOf(disk);
  Eigen::MatrixXd target = loop.Positions;
  target.col(0) *= 1.3;
  const shape::HandlePose pose = shape::PoseHandle(loop, target);
  const shape::PointGraph graph = shape::BuildPointGraph(disk);
  const auto roughness = [&](Options::MultiresolutionType resolution)
  {
    const Eigen::MatrixXd shifts =
      shape::ShapeDeformation(graph, loop, With(resolution)).Deform(pose).Points - disk.Points;
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < graph.Size(); ++i)
    {
      const int degree = graph.First[i + 1] - graph.First[i];
      if (degree == 6 && disk.Points.row(i).norm() < 0.8)
      {
        Eigen::RowVector3d mean = Eigen::RowVector3d::Zero();
        for (int k = graph.First[i]; k < graph.First[i + 1]; ++k)
        {
          mean += shifts.row(graph.Neighbours[k]) / degree;
        }
        sum += (shifts.row(i) - mean).squaredNorm();
        ++count;
      }
    }
    return std::sqrt(sum / count);
  };
  EXPECT_LT(roughness(Options::MultiresolutionType::On), 5e-4); // edges are 0.02
  EXPECT_LT(roughness(Options::MultiresolutionType::Off), 5e-4);
}
