#include "Base/Errors.h"
#include "Harmonic/Private/RegistrationEnergy.h"
#include "Harmonic/RegisterVolume.h"
#include "Remesh/LongestEdgeBisection.h"
#include "Support/ProgressChecks.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

namespace
{

/// A ball with a dent beside its top: it has no symmetry but a mirror.
shape::Mesh DentedBall(int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  for (auto p : mesh.Points.rowwise())
  {
    const double far = (p - Eigen::RowVector3d(0.3, 0.0, 0.954)).squaredNorm();
    p *= Eigen::RowVector3d(1.3, 1.1, 1.0).asDiagonal();
    p *= 1.0 - 0.3 * std::exp(-far / 0.3);
  }
  return mesh;
}

shape::RegisterVolumeOptions InPlace()
{
  shape::RegisterVolumeOptions options;
  options.Align = false;
  return options;
}

/// Returns the smallest volume of the images of the tetrahedra.
double SmallestVolume(const shape::RegisterVolumeResult& result)
{
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto corners : result.Solid.Tetrahedra.rowwise())
  {
    Eigen::Matrix3d edges;
    for (int k = 0; k < 3; ++k)
    {
      edges.row(k) = result.SolidTargets.row(corners(k + 1)) - result.SolidTargets.row(corners(0));
    }
    smallest = std::min(smallest, edges.determinant() / 6.0);
  }
  return smallest;
}

} // namespace

// Image and target are convex and apart, so that all closest points are unique.
TEST(RegisterVolume, GradientAgreesWithFiniteDifferences)
{
  const shape::Mesh ball = shapetest::Icosphere(2);
  shape::TetrahedralizeOptions fill;
  fill.MaximumVolume = 0.003;
  const shape::TetrahedralizeResult solid = shape::Tetrahedralize(ball, {}, fill);
  shape::FilledSolid filled{ solid.Points, solid.Tetrahedra, {} };
  for (int i = 0; i < ball.Points.rows(); ++i)
  {
    filled.Boundary.push_back(i);
  }
  ASSERT_GT(solid.SteinerPoints, 100); // the gradient goes through inner points
  shape::Mesh target = shapetest::Icosphere(2);
  target.Points *= Eigen::RowVector3d(1.3, 1.0, 0.8).asDiagonal();
  target.Points.rowwise() += Eigen::RowVector3d(3.0, 1.0, 0.5);
  const shape::RegistrationEnergy energy(filled, ball.Triangles, target);
  Eigen::MatrixXd images = ball.Points;
  for (int c = 0; c < 3; ++c)
  {
    images.col(c) += 0.05 * ball.Points.col((c + 1) % 3).cwiseAbs2();
  }
  const shape::RegistrationEnergy::Terms terms = energy.Evaluate(images);
  std::srand(3);
  for (int trial = 0; trial < 5; ++trial)
  {
    const Eigen::MatrixXd direction = Eigen::MatrixXd::Random(images.rows(), 3);
    constexpr double h = 1e-5; // distances have a kink in their second derivative
    const auto at = [&](double step) { return energy.Evaluate(images + step * direction); };
    const auto more = at(h), less = at(-h), most = at(2.0 * h), least = at(-2.0 * h);
    const auto expectSlope =
      [&](double shape::RegistrationEnergy::Terms::*value, const Eigen::MatrixXd& gradient)
    {
      const double slope =
        (8.0 * (more.*value - less.*value) - (most.*value - least.*value)) / (12.0 * h);
      EXPECT_NEAR(gradient.cwiseProduct(direction).sum(), slope, 1e-6 * std::abs(slope));
    };
    expectSlope(&shape::RegistrationEnergy::Terms::Distance, terms.ByDistance);
    expectSlope(&shape::RegistrationEnergy::Terms::Distortion, terms.ByDistortion);
  }
}

TEST(RegisterVolume, LeavesASolidThatIsInPlace)
{
  const shape::Mesh ball = DentedBall(2);
  const shape::RegisterVolumeResult result = shape::RegisterVolume(ball, ball, InPlace());
  EXPECT_LT((result.Targets - ball.Points).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT((result.SolidTargets - result.Solid.Points).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(result.After.Distortion, 6.0, 1e-9);
  EXPECT_LT(result.After.MaximumDistance, 1e-9);
}

TEST(RegisterVolume, FindsASimilarity)
{
  const shape::Mesh ball = DentedBall(3);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.0, Eigen::Vector3d(1.0, 2.0, 0.5).normalized()).toRotationMatrix();
  const Eigen::MatrixXd truth =
    (2.0 * ball.Points * turn.transpose()).rowwise() + Eigen::RowVector3d(3.0, 2.0, 1.0);
  const shape::RegisterVolumeResult result =
    shape::RegisterVolume(ball, shape::Mesh{ truth, ball.Triangles });
  EXPECT_NEAR(result.After.Distortion, 6.0, 1e-3);
  EXPECT_LT((result.Targets - truth).rowwise().norm().maxCoeff(),
    0.01 * shape::ComputeLongestBoxEdge(truth));
}

// The stress of a stretch along the axes is normal to the sides, so no sliding lowers the energy.
TEST(RegisterVolume, FindsTheStretchOfABox)
{
  shape::Mesh box = shapetest::Box({ -0.5, -0.4, -0.3 }, { 0.5, 0.4, 0.3 });
  for (int i = 0; i < 3; ++i)
  {
    shape::BisectLongestEdges(box, std::vector<char>(box.Triangles.rows(), 1));
  }
  const Eigen::MatrixXd truth = box.Points * Eigen::RowVector3d(1.2, 1.0, 0.9).asDiagonal();
  const shape::RegisterVolumeResult result =
    shape::RegisterVolume(box, shape::Mesh{ truth, box.Triangles }, InPlace());
  EXPECT_LT((result.Targets - truth).rowwise().norm().maxCoeff(), 0.01 * 1.2);
}

// The affine map has the distance 0. Sliding along the ellipsoid distorts less.
TEST(RegisterVolume, DistortsAnEllipsoidLessThanTheAffineMap)
{
  const shape::Mesh ball = shapetest::Icosphere(3);
  const Eigen::RowVector3d axes(1.3, 1.0, 0.8);
  const shape::RegisterVolumeResult result =
    shape::RegisterVolume(ball, { ball.Points * axes.asDiagonal(), ball.Triangles }, InPlace());
  EXPECT_LT(result.After.MeanDistance, 1e-3);
  EXPECT_LT(result.After.MaximumDistance, 5e-3);
  EXPECT_LT(result.After.Distortion, axes.squaredNorm() + axes.cwiseInverse().squaredNorm());
}

TEST(RegisterVolume, MapsABallOntoADentedBallWithoutInvertedTetrahedra)
{
  const shape::Mesh ball = shapetest::Icosphere(3), target = DentedBall(3);
  const shape::RegisterVolumeResult result = shape::RegisterVolume(ball, target, InPlace());
  EXPECT_GT(result.Before.MaximumDistance, 0.1);
  EXPECT_LT(result.After.MaximumDistance, 0.01);
  EXPECT_LT(result.After.MeanDistance, 0.1 * result.Before.MeanDistance);
  EXPECT_GT(SmallestVolume(result), 0.0);
  // The boundary of the mapped solid is the mapped boundary.
  int given = 0;
  for (Eigen::Index i = 0; i < result.Solid.Points.rows(); ++i)
  {
    if (const int point = result.Solid.Provenance.Points(i); point >= 0)
    {
      ++given;
      EXPECT_EQ(result.SolidTargets.row(i), result.Targets.row(point));
    }
  }
  EXPECT_EQ(given, ball.Points.rows());
}

TEST(RegisterVolume, WeighsDistanceAgainstDistortion)
{
  const shape::Mesh ball = shapetest::Icosphere(2), target = DentedBall(3);
  shape::RegisterVolumeOptions stiff = InPlace(), soft = InPlace();
  stiff.DistortionWeight = 1e-3;
  const shape::RegisterVolumeResult rough = shape::RegisterVolume(ball, target, stiff),
                                    near = shape::RegisterVolume(ball, target, soft);
  EXPECT_LT(near.After.MeanDistance, rough.After.MeanDistance);
  EXPECT_GT(near.After.Distortion, rough.After.Distortion);
}

TEST(RegisterVolume, KeepsPointsThatNoTriangleUses)
{
  shape::Mesh ball = shapetest::Icosphere(2);
  shape::RegisterVolumeOptions options = InPlace();
  options.MaximumIterations = 3;
  const Eigen::MatrixXd targets = shape::RegisterVolume(ball, DentedBall(2), options).Targets;
  ball.Points.conservativeResize(ball.Points.rows() + 1, 3);
  ball.Points.bottomRows(1) << 5.0, 6.0, 7.0;
  const Eigen::MatrixXd more = shape::RegisterVolume(ball, DentedBall(2), options).Targets;
  EXPECT_EQ(more.topRows(targets.rows()), targets);
  EXPECT_EQ(more.bottomRows(1), ball.Points.bottomRows(1));
}

TEST(RegisterVolume, RefusesWhatItCannotUse)
{
  const shape::Mesh ball = shapetest::Icosphere(1);
  shape::RegisterVolumeOptions options;
  options.DistortionWeight = 0.0;
  EXPECT_THROW(shape::RegisterVolume(ball, ball, options), shape::InvalidInput);
  options.DistortionWeight = 1e-5;
  options.MaximumIterations = 0;
  EXPECT_THROW(shape::RegisterVolume(ball, ball, options), shape::InvalidInput);
  const shape::Mesh flat{ Eigen::MatrixXd::Zero(3, 3), Eigen::RowVector3i(0, 1, 2) };
  EXPECT_THROW(shape::RegisterVolume(ball, flat), shape::InvalidInput);
  EXPECT_THROW(shape::RegisterVolume(shapetest::FlatDisk(3), ball), shape::InvalidInput);
  shape::Mesh wild = ball;
  wild.Points(0, 0) = std::nan("");
  EXPECT_THROW(shape::RegisterVolume(ball, wild), shape::InvalidInput);
}

TEST(RegisterVolume, ReportsAndCanBeAborted)
{
  const shape::Mesh ball = DentedBall(2);
  const shape::Mesh target{ ball.Points * Eigen::RowVector3d(1.1, 1.0, 0.9).asDiagonal(),
    ball.Triangles };
  shape::RegisterVolumeOptions options;
  options.MaximumIterations = 3;
  const auto call = [&](const shape::Progress& progress)
  { shape::RegisterVolume(ball, target, options, progress); };
  shapetest::ExpectProgressRises(call);
  for (const double until : { 0.05, 0.12, 0.18, 0.5, 0.97 })
  {
    const shape::Progress stop([&](double share) { return share < until; });
    EXPECT_THROW(call(stop), shape::Aborted);
  }
}
