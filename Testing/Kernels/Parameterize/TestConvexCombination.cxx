#include "Parameterize/ConvexCombination.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <vector>

using shape::CombinationWeights;

TEST(ConvexCombination, CotangentAndMeanValueReproduceAFlatSurfaceWithAnyFlatRim)
{
  // Linear precision: an affine image of the rim gives the affine image of the whole.
  const shape::Mesh mesh = shapetest::FlatSquare(12, 0.35);
  std::vector<int> loop;
  for (int i = 0; i < mesh.Points.rows(); ++i)
  {
    if (mesh.Points.row(i).cwiseAbs().maxCoeff() == 1.0)
    {
      loop.push_back(i);
    }
  }
  const Eigen::Matrix2d linear = (Eigen::Matrix2d() << 1.3, -0.4, 0.9, 0.2).finished();
  const Eigen::MatrixXd expected =
    (mesh.Points.leftCols(2) * linear).rowwise() + Eigen::RowVector2d(5.0, -3.0);
  Eigen::MatrixXd positions(loop.size(), 2);
  for (std::size_t k = 0; k < loop.size(); ++k)
  {
    positions.row(k) = expected.row(loop[k]);
  }
  const auto error = [&](CombinationWeights weights)
  {
    return (shape::SolveConvexCombination(mesh, weights, loop, positions) - expected)
      .cwiseAbs()
      .maxCoeff();
  };
  EXPECT_LT(error(CombinationWeights::Cotangent), 1e-13);
  EXPECT_LT(error(CombinationWeights::MeanValue), 1e-13);
  EXPECT_GT(error(CombinationWeights::Uniform), 1e-3);
}
