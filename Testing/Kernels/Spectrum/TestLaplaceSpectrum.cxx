#include "Base/Errors.h"
#include "Laplacian/CotangentWeights.h"
#include "Laplacian/IntrinsicDelaunay.h"
#include "Spectrum/LaplaceEigenproblem.h"
#include "Support/TestShapes.h"

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace
{

/// How far the pairs are from solving L f = lambda M f, relative to (lambda + 1 / area) M f.
double Residual(const shape::Mesh& mesh, const shape::LaplaceEigenpairs& spectrum)
{
  const shape::IntrinsicTriangles flat = shape::BuildIntrinsicDelaunay(mesh);
  const Eigen::SparseMatrix<double> stiffness = shape::BuildCotangentStiffness(
    flat.Triangles, shape::ComputeAnglesFromLengths(flat.Sides).Cotangents, mesh.Points.rows());
  double worst = 0.0;
  for (Eigen::Index k = 0; k < spectrum.Eigenvalues.size(); ++k)
  {
    const Eigen::VectorXd weighted = spectrum.Masses.cwiseProduct(spectrum.Eigenfunctions.col(k));
    const double value = spectrum.Eigenvalues(k);
    worst = std::max(worst,
      (stiffness * spectrum.Eigenfunctions.col(k) - value * weighted).norm() /
        ((value + 1.0 / spectrum.Masses.sum()) * weighted.norm()));
  }
  return worst;
}

} // namespace

TEST(LaplaceSpectrum, OfASphereIsThatOfSphericalHarmonics)
{
  Eigen::VectorXd exact(49);
  for (int degree = 0; degree < 7; ++degree)
  {
    exact.segment(degree * degree, 2 * degree + 1).setConstant(degree * (degree + 1.0));
  }
  double error = 1.0;
  shape::Mesh sphere;
  shape::LaplaceEigenpairs spectrum;
  for (const int level : { 3, 4, 5 })
  {
    sphere = shapetest::Icosphere(level);
    spectrum = shape::SolveLaplaceEigenproblem(sphere, 49);
    EXPECT_EQ(spectrum.Eigenvalues(0), 0.0);
    const Eigen::ArrayXd errors = (spectrum.Eigenvalues - exact).tail(48).array().abs();
    const double next = (errors / exact.tail(48).array()).maxCoeff();
    EXPECT_LT(next, level == 3 ? 0.07 : error / 3.5); // of second order in the sides
    error = next;
  }
  const Eigen::MatrixXd gram =
    spectrum.Eigenfunctions.transpose() * spectrum.Masses.asDiagonal() * spectrum.Eigenfunctions;
  EXPECT_LT((gram - Eigen::MatrixXd::Identity(49, 49)).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(Residual(sphere, spectrum), 1e-6);
}

TEST(LaplaceSpectrum, OfAPlateIsThatOfCosines)
{
  // Sides 1 and 2, free at the border.
  shape::Mesh plate = shapetest::FlatSquare(80, 0.0);
  plate.Points.col(0) *= 0.5;
  std::vector<double> exact;
  for (int i = 0; i < 6; ++i)
  {
    for (int j = 0; j < 12; ++j)
    {
      exact.push_back(M_PI * M_PI * (i * i + 0.25 * j * j));
    }
  }
  std::sort(exact.begin(), exact.end());
  const shape::LaplaceEigenpairs spectrum = shape::SolveLaplaceEigenproblem(plate, 20);
  for (int k = 0; k < 20; ++k)
  {
    EXPECT_NEAR(spectrum.Eigenvalues(k), exact[k], 0.01 * exact[k] + 1e-9);
  }
  EXPECT_LT(Residual(plate, spectrum), 1e-6);
}

TEST(LaplaceSpectrum, EachComponentHasAConstant)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::Index n = sphere.Points.rows(), m = sphere.Triangles.rows();
  constexpr int copies = 20; // more than a block of the iteration
  shape::Mesh many{ Eigen::MatrixXd(copies * n, 3), Eigen::MatrixXi(copies * m, 3) };
  for (int c = 0; c < copies; ++c)
  {
    many.Points.middleRows(c * n, n) = sphere.Points.rowwise() + Eigen::RowVector3d(3.0 * c, 0, 0);
    many.Triangles.middleRows(c * m, m) = sphere.Triangles.array() + static_cast<int>(c * n);
  }
  const shape::LaplaceEigenpairs spectrum = shape::SolveLaplaceEigenproblem(many, 4 * copies);
  EXPECT_EQ(spectrum.Eigenvalues.head(copies), Eigen::VectorXd::Zero(copies));
  // Three of each sphere follow: more equal ones than a block has columns.
  EXPECT_GT(spectrum.Eigenvalues(copies), 1.9);
  EXPECT_LT(spectrum.Eigenvalues(4 * copies - 1), 2.1);
  EXPECT_LT(Residual(many, spectrum), 1e-6);
}

TEST(LaplaceSpectrum, ComponentsMixTheirEigenvaluesInOrder)
{
  // Radii 1 and 3: l (l + 1) and l (l + 1) / 9. And a tetrahedron, whose spectrum ends.
  const shape::Mesh small = shapetest::Icosphere(3);
  const Eigen::Index n = small.Points.rows(), m = small.Triangles.rows();
  shape::Mesh both{ Eigen::MatrixXd(2 * n + 4, 3), Eigen::MatrixXi(2 * m + 4, 3) };
  both.Points << small.Points, 3.0 * small.Points, 0, 0, 0, 0.1, 0, 0, 0, 0.1, 0, 0, 0, 0.1;
  const int first = static_cast<int>(2 * n);
  both.Triangles << small.Triangles, small.Triangles.array() + static_cast<int>(n), first,
    first + 2, first + 1, first, first + 1, first + 3, first, first + 3, first + 2, first + 1,
    first + 2, first + 3;
  const shape::LaplaceEigenpairs spectrum = shape::SolveLaplaceEigenproblem(both, 3 + 24 + 3);
  EXPECT_EQ(spectrum.Eigenvalues.head(3), Eigen::Vector3d::Zero());
  std::vector<double> exact = { 2, 2, 2 };
  for (int degree = 1; degree < 5; ++degree)
  {
    exact.insert(exact.end(), 2 * degree + 1, degree * (degree + 1.0) / 9.0);
  }
  std::sort(exact.begin(), exact.end());
  for (int k = 0; k < 27; ++k)
  {
    EXPECT_NEAR(spectrum.Eigenvalues(3 + k), exact[k], 0.04 * exact[k]);
    const Eigen::VectorXd function = spectrum.Eigenfunctions.col(3 + k);
    EXPECT_EQ(function.head(n).norm() > 0.0, function.tail(n + 4).norm() == 0.0);
  }
  EXPECT_LT(Residual(both, spectrum), 1e-6);
}

TEST(LaplaceSpectrum, ATurnOfASymmetricSurfaceChangesNoSign)
{
  // Mirrored in three planes: an eigenfunction that is odd in one of them has its greatest
  // magnitude twice, with both signs.
  shape::Mesh ellipsoid = shapetest::Icosphere(3);
  ellipsoid.Points *= Eigen::Vector3d(1.0, 1.3, 1.7).asDiagonal();
  const shape::LaplaceEigenpairs spectrum = shape::SolveLaplaceEigenproblem(ellipsoid, 12);
  for (int k = 1; k < 8; ++k)
  {
    shape::Mesh turned = ellipsoid;
    turned.Points *=
      Eigen::AngleAxisd(0.7 * k, Eigen::Vector3d(1, k, -2).normalized()).toRotationMatrix();
    const shape::LaplaceEigenpairs other = shape::SolveLaplaceEigenproblem(turned, 12);
    EXPECT_LT((other.Eigenfunctions - spectrum.Eigenfunctions).cwiseAbs().maxCoeff(), 1e-6) << k;
  }
}

TEST(LaplaceSpectrum, NamesWhatIsWrong)
{
  shape::Mesh mesh = shapetest::Icosphere(1); // 42 points
  EXPECT_EQ(shape::SolveLaplaceEigenproblem(mesh, 42).Eigenvalues.size(), 42);
  EXPECT_THROW(shape::SolveLaplaceEigenproblem(mesh, 43), shape::InvalidInput);
  EXPECT_THROW(shape::SolveLaplaceEigenproblem(mesh, 0), shape::InvalidInput);
  mesh.Triangles(0, 0) = mesh.Triangles(0, 1);
  EXPECT_THROW(shape::SolveLaplaceEigenproblem(mesh, 10), shape::InvalidInput);
}
