#include "Laplacian/CotangentWeights.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include <cmath>

namespace
{

/// An icosphere with two points at one place and a triangle flattened to a line.
shape::Mesh Degenerate()
{
  shape::Mesh mesh = shapetest::Icosphere(1);
  mesh.Points.row(mesh.Triangles(3, 1)) = mesh.Points.row(mesh.Triangles(3, 0));
  const Eigen::RowVector3i flat = mesh.Triangles.row(40);
  mesh.Points.row(flat(2)) = 0.3 * mesh.Points.row(flat(0)) + 0.7 * mesh.Points.row(flat(1));
  return mesh;
}

Eigen::SparseMatrix<double> StiffnessOf(const shape::Mesh& mesh)
{
  return shape::BuildCotangentStiffness(
    mesh.Triangles, shape::ComputeTriangleAngles(mesh).Cotangents, mesh.Points.rows());
}

} // namespace

TEST(CotangentWeights, TheDirichletEnergyOfThePlaceIsTheArea)
{
  shape::Mesh mesh = shapetest::Icosphere(3);
  mesh.Points.col(0) *= 5.0;
  mesh.Points.col(1).array() += mesh.Points.col(0).array().sin();
  const double energy = 0.5 * mesh.Points.cwiseProduct(StiffnessOf(mesh) * mesh.Points).sum();
  EXPECT_NEAR(energy / shape::ComputePointAreas(mesh).sum(), 1.0, 1e-12);
  EXPECT_NEAR(shape::ComputeTriangleAngles(mesh).Areas.sum() / shape::ComputePointAreas(mesh).sum(),
    1.0, 1e-12);
}

TEST(CotangentWeights, AnEquilateralTriangleHasItsCotangentsAtAnyScale)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    shape::Mesh mesh = shapetest::Icosphere(0);
    mesh.Points *= scale;
    EXPECT_LT((shape::ComputeTriangleAngles(mesh).Cotangents.array() - 1.0 / std::sqrt(3.0))
                .abs()
                .maxCoeff(),
      1e-12);
  }
}

TEST(CotangentWeights, TrianglesWithoutAreaStayFiniteAndPositiveSemidefinite)
{
  const Eigen::SparseMatrix<double> stiffness = StiffnessOf(Degenerate());
  const Eigen::MatrixXd dense = stiffness;
  ASSERT_TRUE(dense.allFinite());
  EXPECT_LT(dense.cwiseAbs().maxCoeff(), 1e7);
  const Eigen::VectorXd values =
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(dense, Eigen::EigenvaluesOnly).eigenvalues();
  EXPECT_GT(values(0), -1e-8);
  EXPECT_GT(values(1), 1e-3); // only constants have no energy
  EXPECT_LT((dense.rowwise().sum()).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(CotangentWeights, PositiveStiffnessHasNoWeightBelowTheLeast)
{
  const Eigen::MatrixXd dense = shape::BuildPositiveStiffness(StiffnessOf(Degenerate()), 0.01);
  EXPECT_LT(dense.rowwise().sum().cwiseAbs().maxCoeff(), 1e-9);
  for (Eigen::Index i = 0; i < dense.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < dense.cols(); ++j)
    {
      EXPECT_TRUE(i == j || dense(i, j) == 0.0 || dense(i, j) <= -0.01);
    }
  }
}
