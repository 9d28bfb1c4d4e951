#include "Base/Errors.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/NearSurfaceCharges.h"
#include "Support/ForkedProcesses.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

/// A ball with a dent, mapped to a ball: not harmonic, so several levels refine the boundary.
shape::Mesh Dented(int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  for (auto p : mesh.Points.rowwise())
  {
    p *= 1.0 - 0.4 * std::exp(-4.0 * (p - Eigen::RowVector3d(0.0, 0.0, 1.0)).squaredNorm());
  }
  return mesh;
}

} // namespace

TEST(DistributedMap, IsTheMapOfOneProcessToTheLastBit)
{
  const shape::Mesh boundary = Dented(4);
  const Eigen::MatrixXd targets = boundary.Points.rowwise().normalized();
  shape::HarmonicVolumeMapOptions options;
  options.Tolerance = 1e-7; // not reached by the first levels
  options.MaximumLevels = 3;
  const auto alone = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
  ASSERT_GT(alone.Levels.size(), 2U); // the affine part, the boundary, refinements of it
  const Eigen::MatrixXd inside = 0.9 * boundary.Points;
  const Eigen::MatrixXd expected = shape::Evaluate(alone.Map, inside);
  for (const int count : { 2, 3, 4 })
  {
    shape::HarmonicVolumeMapResult shared;
    Eigen::MatrixXd values, sums;
    const int failures = shapetest::ForkedProcesses::Run(count,
      [&](const shape::Processes& processes)
      {
        shape::AcceleratedSetup setup;
        setup.Processes = processes;
        shared = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options, {}, &setup);
        values = sums = shape::Evaluate(shared.Map, inside);
        processes.Sum(sums);
      });
    EXPECT_EQ(failures, 0);
    EXPECT_EQ(values, expected);
    // All processes have the same map: their sum is a multiple up to rounding.
    EXPECT_LT((sums - count * values).cwiseAbs().maxCoeff(), 1e-14);
    ASSERT_EQ(shared.Levels.size(), alone.Levels.size());
    EXPECT_EQ(shared.Iterations, alone.Iterations);
    EXPECT_EQ(shared.RefinedPoints, alone.RefinedPoints);
    const auto &ours = shared.Levels.back(), &its = alone.Levels.back();
    EXPECT_EQ(ours.RMSEInside, its.RMSEInside);
    EXPECT_EQ(ours.RMSEVertices, its.RMSEVertices);
    EXPECT_EQ(ours.RMSECollocations, its.RMSECollocations);
    EXPECT_EQ(ours.Maximum, its.Maximum);
  }
}

TEST(DistributedMap, HasMoreProcessesThanPoints)
{
  const shape::Mesh boundary = shapetest::Icosphere(0);
  Eigen::MatrixXd targets = boundary.Points;
  targets.col(0) += targets.col(1).cwiseAbs2();
  const auto alone = shape::ComputeHarmonicVolumeMap(boundary, targets);
  shape::HarmonicVolumeMapResult shared;
  const int failures = shapetest::ForkedProcesses::Run(14,
    [&](const shape::Processes& processes)
    {
      shape::AcceleratedSetup setup;
      setup.Processes = processes;
      shared = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, {}, {}, &setup);
    });
  EXPECT_EQ(failures, 0);
  const Eigen::MatrixXd inside = 0.5 * boundary.Points;
  EXPECT_EQ(shape::Evaluate(shared.Map, inside), shape::Evaluate(alone.Map, inside));
}

TEST(DistributedMap, FailsOnAllProcesses)
{
  const shape::Mesh boundary = shapetest::Icosphere(3);
  Eigen::MatrixXd targets = boundary.Points;
  targets.col(0) += targets.col(1).cwiseAbs2();
  // One process is stopped while it solves; no other waits for it.
  bool failed = false;
  const int failures = shapetest::ForkedProcesses::Run(3,
    [&](const shape::Processes& processes)
    {
      shape::AcceleratedSetup setup;
      setup.Processes = processes;
      const shape::Progress progress(
        [&](double share) { return processes.Number != 1 || share < 0.1; });
      try
      {
        shape::ComputeHarmonicVolumeMap(boundary, targets, {}, {}, progress, &setup);
      }
      catch (const std::exception&)
      {
        if (processes.Number == 0)
        {
          failed = true; // this process has the test
          return;
        }
        throw;
      }
    });
  EXPECT_TRUE(failed);
  EXPECT_EQ(failures, 2);
}

TEST(DistributedMap, SharesOnlyTheAcceleratedMethodWithoutFeatures)
{
  const shape::Mesh boundary = shapetest::Icosphere(1);
  shape::AcceleratedSetup setup;
  setup.Processes = { 2, 0, [](double*, Eigen::Index) {} };
  shape::HarmonicVolumeMapOptions options;
  options.Method = shape::HarmonicVolumeMapOptions::MethodType::MultiLevel;
  EXPECT_THROW(shape::ComputeHarmonicVolumeMap(boundary, boundary.Points, {}, options, {}, &setup),
    shape::InvalidInput);
}
