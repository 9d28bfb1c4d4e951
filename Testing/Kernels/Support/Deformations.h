#pragma once

#include "Deform/Private/NodeDeformation.h"
#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"

#include <gtest/gtest.h>

#include <vector>

// What the tests of deformations compute alike.
namespace shapetest
{

/// The points of a surface whose longest boundary loop is bent to a cylinder of radius 1.
inline Eigen::MatrixXd DeformWithBentLoop(const shape::Mesh& mesh,
  const shape::DeformOptions& options, const shape::DeformFields& fields = {})
{
  const shape::BoundaryHandle loop = LoopOf(mesh);
  return shape::ShapeDeformation(shape::BuildPointGraph(mesh), loop, options, fields)
    .Deform(shape::PoseHandle(loop, Bent(loop.Positions, 1.0)))
    .Points;
}

/// A deformation of nodes gives the same bits whether it keeps its weights or computes them again.
template <class Deformation>
void ExpectStreamedWeightsAreTheKeptOnes(double power)
{
  const shape::Mesh cap = Cap(10);
  shape::NodeProblem problem;
  problem.Graph = shape::BuildPointGraph(cap);
  problem.Sources = shape::FindManifoldBoundaryLoops(cap).front();
  problem.Powers = Eigen::VectorXd::Constant(cap.Points.rows(), power);
  problem.Scales = Eigen::VectorXd::Ones(cap.Points.rows());
  const auto sources = static_cast<Eigen::Index>(problem.Sources.size());
  const shape::NodeTransforms motions{ Eigen::MatrixXd::Random(3, sources),
    std::vector<Eigen::Matrix3d>(sources, SomeRotation()) };
  const Deformation kept(problem);
  problem.MaximumWeights = 0;
  const Deformation streamed(problem);
  EXPECT_TRUE(streamed.IsStreamed() && !kept.IsStreamed());
  EXPECT_EQ(streamed.Move(motions, 1e9).Shifts, kept.Move(motions, 1e9).Shifts);
}

} // namespace shapetest
