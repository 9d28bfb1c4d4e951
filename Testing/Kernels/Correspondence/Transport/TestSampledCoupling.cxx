#include "Base/Errors.h"
#include "Correspondence/Transport/GromovWasserstein.h"
#include "Correspondence/Transport/SampledCoupling.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace
{

/// A shape without symmetry, coupled with itself in another order; each point is a sample.
struct SelfCoupling
{
  shape::Mesh Mesh = shapetest::BumpySphere(2, Eigen::Matrix3d::Identity());
  shapetest::Renumbered Copy = shapetest::Renumber(Mesh, 3);
  shape::GromovWassersteinResult Result;

  SelfCoupling()
  {
    shape::Landmarks landmarks;
    for (const int point : { 0, 40, 90, 130 })
    {
      landmarks.push_back({ point, Copy.NewOf(point) });
    }
    shape::GromovWassersteinOptions options;
    options.Samples = 200; // more than the points
    options.Coupling.Entropy = 2e-6;
    options.Coupling.SinkhornIterations = 2000;
    Result = shape::ComputeGromovWassersteinMap(Mesh, Copy.Mesh, landmarks, options);
  }
};

} // namespace

TEST(SampledCoupling, OfAShapeWithItselfIsTheIdentity)
{
  const SelfCoupling self;
  const shape::SampledCoupling& coupling = self.Result.Coupling;
  ASSERT_EQ(coupling.Masses.rows(), self.Mesh.Points.rows());
  ASSERT_EQ(coupling.Masses.cols(), self.Mesh.Points.rows());
  double right = 0.0;
  for (Eigen::Index i = 0; i < coupling.Masses.rows(); ++i)
  {
    for (Eigen::Index j = 0; j < coupling.Masses.cols(); ++j)
    {
      right += coupling.SamplesOfB[j] == self.Copy.NewOf(coupling.SamplesOfA[i])
        ? coupling.Masses(i, j)
        : 0.0;
    }
  }
  EXPECT_GT(right, 0.99);
  EXPECT_LT((coupling.Masses.rowwise().sum() - coupling.WeightsOfA).cwiseAbs().sum(),
    self.Result.Error + 1e-12);
  EXPECT_LT(
    (coupling.Masses.colwise().sum().transpose() - coupling.WeightsOfB).cwiseAbs().sum(), 1e-12);
}

TEST(SampledCoupling, ListsTheEntriesAndWhatIsLeft)
{
  Eigen::MatrixXd masses(2, 3);
  masses << 0.2, 1e-12, 0.3, 1e-10, 0.5, 0.0;
  const shape::CouplingEntries entries = shape::ListEntries(masses, 1e-9);
  EXPECT_EQ(entries.OfA, (std::vector<int>{ 0, 0, 1 }));
  EXPECT_EQ(entries.OfB, (std::vector<int>{ 0, 2, 1 }));
  EXPECT_EQ(entries.Masses, Eigen::Vector3d(0.2, 0.3, 0.5));
  EXPECT_NEAR(entries.Omitted, 1.01e-10, 1e-24);
}

TEST(SampledCoupling, ImagesAreDistributions)
{
  const SelfCoupling self;
  const Eigen::VectorXd areas = shape::ComputePointAreas(self.Copy.Mesh);
  // Every point is a sample, whose cell is itself: nearly all of its image is at its copy.
  for (const int point : { 3, 77, 160 })
  {
    const Eigen::VectorXd density =
      shape::ComputeImageDistribution(self.Mesh, self.Copy.Mesh, self.Result.Coupling, point);
    EXPECT_NEAR(density.dot(areas), 1.0, 1e-12);
    EXPECT_GE(density.minCoeff(), 0.0);
    EXPECT_GT(density(self.Copy.NewOf(point)) * areas(self.Copy.NewOf(point)), 0.9);
  }
  EXPECT_REFUSED(
    shape::ComputeImageDistribution(self.Mesh, self.Copy.Mesh, self.Result.Coupling, 162), "162");
}
