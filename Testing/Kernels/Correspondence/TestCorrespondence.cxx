#include "Correspondence/Correspondence.h"
#include "Correspondence/Landmarks/LandmarkPairs.h"
#include "Remesh/Coarsening.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

using Options = shape::CorrespondenceOptions;
using Method = Options::MethodType;

/// A bumpy sphere and a copy of it in another pose and size, with other triangles.
struct Pair
{
  shape::Mesh A = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  shape::Mesh B = shapetest::BumpySphere(3, shapetest::Rotation(0.6, { 0.3, 1.0, -0.4 }));
  Eigen::Matrix3d Pose = 2.0 * shapetest::Rotation(1.2, { 1.0, 0.2, 0.5 });

  Pair() { this->B.Points = this->B.Points * this->Pose.transpose(); }
  Eigen::MatrixXd Wanted() const { return this->A.Points * this->Pose.transpose(); }

  /// The ends of the bumps and places between them.
  shape::Landmarks SomeLandmarks() const
  {
    std::vector<int> points;
    for (int i = 10; i < this->A.Points.rows(); i += 90)
    {
      points.push_back(i);
    }
    return shape::PairLandmarks(
      this->A, this->A.Points(points, Eigen::all), this->B, this->Wanted()(points, Eigen::all));
  }

  double MeanError(const shape::CorrespondenceResult& result) const
  {
    return shapetest::MapErrors(result.Maps.AToB, this->B, this->Wanted()).mean();
  }
};

TEST(Correspondence, EveryMethodFindsAShapeAgainWithOtherTriangles)
{
  const Pair pair;
  const shape::Landmarks landmarks = pair.SomeLandmarks();
  for (const Method method :
    { Method::ReversibleHarmonic, Method::FunctionalMap, Method::GromovWasserstein,
      Method::HeatKernel, Method::BlendedIntrinsic, Method::CommonSphere })
  {
    Options options;
    options.Method = method;
    options.Samples = 200;
    const shape::CorrespondenceResult result =
      shape::ComputeCorrespondence(pair.A, pair.B, landmarks, options);
    EXPECT_LT(pair.MeanError(result), 0.05) << static_cast<int>(method);
    EXPECT_LT(result.Facts.ReversedArea, 0.2) << static_cast<int>(method);
    EXPECT_EQ(result.Used, landmarks);
    EXPECT_FALSE(result.Found);
  }
}

TEST(Correspondence, WithoutLandmarksItFindsThem)
{
  const Pair pair;
  Options options;
  options.Method = Method::FunctionalMap;
  const shape::CorrespondenceResult result =
    shape::ComputeCorrespondence(pair.A, pair.B, {}, options);
  EXPECT_TRUE(result.Found);
  EXPECT_GE(result.Used.size(), 3U);
  EXPECT_LT(pair.MeanError(result), 0.03);
}

TEST(Correspondence, FindsAPartWithLandmarksAndWithout)
{
  using Which = shape::SurfacePart::WhichType;
  Pair pair;
  pair.A = shapetest::Above(pair.A, -0.45).Surface;
  const double share =
    4.0 * shape::ComputePointAreas(pair.A).sum() / shape::ComputePointAreas(pair.B).sum();
  Options options;
  options.Method = Method::FunctionalMap;
  for (const shape::Landmarks& landmarks : { pair.SomeLandmarks(), shape::Landmarks() })
  {
    const shape::CorrespondenceResult result =
      shape::ComputeCorrespondence(pair.A, pair.B, landmarks, options);
    EXPECT_EQ(result.Part.Which, Which::SurfaceA);
    EXPECT_NEAR(result.Part.Scale, 2.0, 0.12); // B is twice as large
    EXPECT_NEAR(result.Part.Share, share, 0.1);
    EXPECT_LT(pair.MeanError(result), 0.04);
    const shape::CorrespondenceResult turned =
      shape::ComputeCorrespondence(pair.B, pair.A, {}, options);
    EXPECT_EQ(turned.Part.Which, Which::SurfaceB);
    EXPECT_NEAR(turned.Part.Scale, 0.5, 0.03);
    EXPECT_GT(turned.Facts.CoverageOfB, 0.9);
  }
  options.Method = Method::ReversibleHarmonic;
  const shape::CorrespondenceResult kept =
    shape::ComputeCorrespondence(pair.A, pair.B, pair.SomeLandmarks(), options);
  EXPECT_EQ(kept.Iterations, 0);
  EXPECT_LT(pair.MeanError(kept), 0.04);
  options.Method = Method::FunctionalMap;
  options.Part = Options::PartType::None;
  const shape::CorrespondenceResult whole =
    shape::ComputeCorrespondence(pair.A, pair.B, pair.SomeLandmarks(), options);
  EXPECT_EQ(whole.Part.Which, Which::None);
  EXPECT_GT(pair.MeanError(whole), 0.08);
  options.Part = Options::PartType::SurfaceB; // is larger than A
  EXPECT_THROW(shape::ComputeCorrespondence(pair.A, pair.B, pair.SomeLandmarks(), options),
    shape::InvalidInput);
}

TEST(Correspondence, AnIdentityIsHarmonicComesBackAndTurnsNothingOver)
{
  const shape::Mesh mesh = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  Eigen::VectorXi all(mesh.Points.rows());
  for (int i = 0; i < static_cast<int>(all.size()); ++i)
  {
    all(i) = i;
  }
  const shape::SurfacePoints identity = shape::MakeSurfacePointsAtVertices(all, mesh);
  const shape::SurfaceMapFacts same = shape::EvaluateMaps(mesh, mesh, { identity, identity });
  EXPECT_LT(same.RoundTrip, 1e-12);
  EXPECT_EQ(same.ReversedArea, 0.0);
  // Negative cotangents are raised, which can only add.
  EXPECT_GE(same.DirichletEnergy, 1.0 - 1e-12);
  EXPECT_LT(same.DirichletEnergy, 1.1);

  // The mirror image, mapped to the mesh point by point, is turned over everywhere.
  const shape::SurfaceMapFacts mirrored =
    shape::EvaluateMaps(shapetest::Mirrored(mesh), mesh, { identity, identity });
  EXPECT_GT(mirrored.ReversedArea, 0.99);
  EXPECT_TRUE(mirrored.Mirrored);
  EXPECT_FALSE(same.Mirrored);
}

TEST(Correspondence, AMapFromLandmarksOnTheWrongSidesIsCalledMirrored)
{
  const shape::Mesh bull = shape::CoarsenSurface(shapetest::ReadModel("bull"), 1500).Surface;
  const shape::Mesh other = shapetest::Mirrored(bull);
  Options options;
  options.Method = Method::FunctionalMap;
  shape::Landmarks landmarks;
  for (int i = 0; i < bull.Points.rows(); i += static_cast<int>(bull.Points.rows()) / 12)
  {
    landmarks.push_back({ i, i });
  }
  // Left goes to left, which is right in a mirror.
  EXPECT_TRUE(shape::ComputeCorrespondence(bull, other, landmarks, options).Facts.Mirrored);
  EXPECT_FALSE(shape::ComputeCorrespondence(bull, bull, landmarks, options).Facts.Mirrored);
  // Without landmarks orientation decides.
  EXPECT_FALSE(shape::ComputeCorrespondence(bull, other, {}, options).Facts.Mirrored);
}

TEST(Correspondence, PointsWithoutATriangleGoWithTheNearest)
{
  const Pair pair;
  shape::Mesh loose = pair.A;
  loose.Points.conservativeResize(loose.Points.rows() + 1, 3);
  loose.Points.bottomRows(1) = 1.001 * loose.Points.row(7);
  Options options;
  options.Method = Method::FunctionalMap;
  const shape::SurfacePoints map =
    shape::ComputeCorrespondence(loose, pair.B, pair.SomeLandmarks(), options).Maps.AToB;
  EXPECT_EQ(map.Triangles.tail(1)(0), map.Triangles(7));
  EXPECT_EQ(map.Barycentrics.bottomRows(1), map.Barycentrics.row(7));
}

TEST(LandmarkPairs, AreTheNearestPointsAndNoneTwice)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  Eigen::MatrixXd positions = 1.01 * sphere.Points(std::vector<int>{ 4, 9, 4 }, Eigen::all);
  const shape::Landmarks pairs = shape::PairLandmarks(
    sphere, positions, sphere, sphere.Points(std::vector<int>{ 8, 3, 2 }, Eigen::all));
  EXPECT_EQ(pairs, (shape::Landmarks{ { 4, 8 }, { 9, 3 } }));
  Eigen::MatrixXd bad = positions;
  bad(0, 1) = std::nan("");
  EXPECT_THROW(shape::PairLandmarks(sphere, bad, sphere, positions), shape::InvalidInput);
  // In millimetres beside a surface in metres.
  EXPECT_THROW(
    shape::PairLandmarks(sphere, positions, sphere, 1000.0 * positions), shape::InvalidInput);
}

TEST(Correspondence, RefusesWhatAMethodCannotDo)
{
  const Pair pair;
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 24, 12);
  Options options;
  for (const Method method :
    { Method::BlendedIntrinsic, Method::CommonSphere, Method::CommonOrbifold })
  {
    options.Method = method;
    EXPECT_REFUSED(
      shape::ComputeCorrespondence(torus, pair.B, { { 0, 0 }, { 50, 50 }, { 99, 99 } }, options),
      "genus 1", "take CommonBase, ReversibleHarmonic");
  }
  options = {};
  options.NumberOfEigenpairs = 3;
  EXPECT_REFUSED(
    shape::ComputeCorrespondence(pair.A, pair.B, {}, options), "NumberOfEigenpairs is 3");
}

} // namespace
