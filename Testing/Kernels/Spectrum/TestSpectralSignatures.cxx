#include "Base/Errors.h"
#include "Spectrum/LaplaceEigenproblem.h"
#include "Spectrum/SpectralSignatures.h"
#include "Support/TestShapes.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>

namespace
{

shape::Mesh Ellipsoid()
{
  shape::Mesh mesh = shapetest::Icosphere(4);
  mesh.Points.col(2) *= 3.0;
  return mesh;
}

using Signature = Eigen::MatrixXd (*)(const shape::LaplaceEigenpairs&, int);

} // namespace

TEST(SpectralSignatures, AreOneEverywhereOnASphere)
{
  // 49: whole degrees of spherical harmonics.
  const shape::LaplaceEigenpairs spectrum =
    shape::SolveLaplaceEigenproblem(shapetest::Icosphere(5), 49);
  for (const Signature signature :
    { shape::ComputeHeatKernelSignature, shape::ComputeWaveKernelSignature })
  {
    const Eigen::MatrixXd values = signature(spectrum, 20);
    EXPECT_LT((values.array() - 1.0).abs().maxCoeff(), 0.02);
  }
  // The first three harmonics are the coordinates: 3 / (4 pi) together, divided by the
  // eigenvalue 2.
  const Eigen::VectorXd radii = shape::ComputeSpectralEmbedding(spectrum, 3).rowwise().norm();
  const double radius = std::sqrt(3.0 / (8.0 * M_PI));
  EXPECT_LT((radii.array() - radius).abs().maxCoeff(), 0.01 * radius);
}

TEST(SpectralSignatures, HaveAMeanOfOneAndNoUnit)
{
  shape::Mesh mesh = Ellipsoid();
  const shape::LaplaceEigenpairs spectrum = shape::SolveLaplaceEigenproblem(mesh, 60);
  mesh.Points *= 1000.0;
  const shape::LaplaceEigenpairs large = shape::SolveLaplaceEigenproblem(mesh, 60);
  const Eigen::VectorXd shares = spectrum.Masses / spectrum.Masses.sum();
  for (const Signature signature :
    { shape::ComputeHeatKernelSignature, shape::ComputeWaveKernelSignature })
  {
    const Eigen::MatrixXd values = signature(spectrum, 30);
    EXPECT_LT(((shares.transpose() * values).array() - 1.0).abs().maxCoeff(), 1e-9);
    EXPECT_GT(values.minCoeff(), 0.0);
    EXPECT_LT((signature(large, 30) - values).cwiseAbs().maxCoeff(), 1e-6 * values.maxCoeff());
  }
}

TEST(SpectralSignatures, HeatStaysWhereASurfaceIsCurved)
{
  // After a short time it is 1 / (4 pi t) + K / (12 pi), with the curvature K; times the area over
  // the mean, 1 + (K - 4 pi / area) t / 3.
  const shape::Mesh mesh = Ellipsoid();
  const shape::LaplaceEigenpairs spectrum = shape::SolveLaplaceEigenproblem(mesh, 150);
  const Eigen::VectorXd early = shape::ComputeHeatKernelSignature(spectrum, 100).col(10);
  Eigen::Index top = 0, low = 0;
  mesh.Points.col(2).maxCoeff(&top);
  mesh.Points.col(2).cwiseAbs().minCoeff(&low);
  EXPECT_GT(early(top), 1.2);
  EXPECT_LT(early(low), 1.0);
}

TEST(SpectralSignatures, SayHowManyEigenpairsAreNeeded)
{
  const shape::LaplaceEigenpairs constant =
    shape::SolveLaplaceEigenproblem(shapetest::Icosphere(2), 1);
  EXPECT_THROW(shape::ComputeHeatKernelSignature(constant, 10), shape::InvalidInput);
  EXPECT_THROW(shape::ComputeWaveKernelSignature(constant, 10), shape::InvalidInput);
  const shape::LaplaceEigenpairs few = shape::SolveLaplaceEigenproblem(shapetest::Icosphere(2), 3);
  EXPECT_THROW(shape::ComputeSpectralEmbedding(few, 3), shape::InvalidInput);
  EXPECT_EQ(shape::ComputeSpectralEmbedding(few, 2).cols(), 2);
  // All energies are the same then.
  EXPECT_TRUE(shape::ComputeWaveKernelSignature(
    shape::SolveLaplaceEigenproblem(shapetest::Icosphere(2), 2), 10)
                .allFinite());
}
