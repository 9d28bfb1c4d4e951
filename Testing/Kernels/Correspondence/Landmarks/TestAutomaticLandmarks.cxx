#include "Base/Errors.h"
#include "Correspondence/Landmarks/AutomaticLandmarks.h"
#include "Correspondence/Landmarks/Private/FeatureAssignment.h"
#include "Correspondence/Landmarks/Private/PersistentMaxima.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

namespace
{

using shapetest::ReadModel;

/// The farthest that a landmark of `a` is from its partner in `b` turned back, over the size.
double WorstError(const shape::Mesh& a, const shape::Mesh& b, const Eigen::Matrix3d& turn,
  const shape::Landmarks& landmarks)
{
  double worst = 0.0;
  for (const auto& [i, j] : landmarks)
  {
    worst = std::max(worst, (a.Points.row(i) - b.Points.row(j) * turn).norm());
  }
  return worst / shape::ComputeLongestBoxEdge(a.Points);
}

} // namespace

TEST(AutomaticLandmarks, MaximaAreAsPersistentAsTheyAreAboveThePassToAHigherOne)
{
  // 1 4 2 6 5 5.5 0 along a strip: 6 above all, 4 above the pass 2, 5.5 above the pass 5.
  Eigen::VectorXd function(14);
  function << 1, 1, 4, 4, 2, 2, 6, 6, 5, 5, 5.5, 5.5, 0, 0;
  Eigen::MatrixXi triangles(12, 3);
  for (int k = 0; k < 6; ++k)
  {
    triangles.row(2 * k) << 2 * k, 2 * k + 2, 2 * k + 1;
    triangles.row(2 * k + 1) << 2 * k + 1, 2 * k + 2, 2 * k + 3;
  }
  using Points = std::vector<int>;
  EXPECT_EQ(shape::FindPersistentMaxima(triangles, function, 0.1, 9), (Points{ 6, 2, 10 }));
  EXPECT_EQ(shape::FindPersistentMaxima(triangles, function, 0.6, 9), (Points{ 6, 2 }));
  EXPECT_EQ(shape::FindPersistentMaxima(triangles, function, 0.1, 1), Points{ 6 });
  EXPECT_TRUE(shape::FindPersistentMaxima(triangles, function, 6.1, 9).empty());
}

TEST(AutomaticLandmarks, AssignmentKeepsDistancesAndLeavesOutWhatFitsNothing)
{
  // Positions on a line; the second set has them in another order, and one more far away.
  const Eigen::VectorXd a = (Eigen::VectorXd(4) << 0.0, 1.0, 3.0, 7.0).finished();
  const Eigen::VectorXd b = (Eigen::VectorXd(5) << 3.0, 0.0, 40.0, 7.0, 1.0).finished();
  const auto apart = [](const Eigen::VectorXd& x) -> Eigen::MatrixXd
  {
    return (x.rowwise().replicate(x.size()) - x.transpose().colwise().replicate(x.size()))
      .cwiseAbs();
  };
  const auto found = shape::AssignFeatures(
    apart(a), apart(b), Eigen::VectorXd::Ones(4), Eigen::VectorXd::Ones(5), 0.2, 10);
  ASSERT_FALSE(found.empty());
  EXPECT_EQ(found[0].Pairs, (shape::Landmarks{ { 0, 1 }, { 1, 4 }, { 2, 0 }, { 3, 3 } }));
  EXPECT_DOUBLE_EQ(found[0].Score, 6 * 0.5); // six pairs of pairs agree wholly
  for (std::size_t k = 1; k < found.size(); ++k)
  {
    EXPECT_LE(found[k].Score, found[k - 1].Score);
  }
  const auto none = shape::AssignFeatures(
    apart(a), 100.0 * apart(b), Eigen::VectorXd::Ones(4), Eigen::VectorXd::Ones(5), 0.2, 10);
  EXPECT_TRUE(none.empty());
}

TEST(AutomaticLandmarks, FindsTheTipsOfAShapeInOtherTriangles)
{
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 1, 2, 3 });
  const shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  shape::Mesh b = shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3, -1, 1 }));
  b.Points = 5.0 * b.Points * turn.transpose();
  const auto found = shape::FindLandmarks(a, b);
  EXPECT_GE(found.Pairs.size(), 4u);
  b.Points /= 5.0;
  EXPECT_LT(WorstError(a, b, turn, found.Pairs), 0.06); // a bump is 0.3 wide
  EXPECT_LT(found.Distortion, 0.04);
  EXPECT_LT(found.Distortion, 0.8 * found.MirroredDistortion);
  EXPECT_FALSE(found.MirrorImage);
  EXPECT_GT(found.Confidence, 0.2);
}

TEST(AutomaticLandmarks, TellsAMirrorImage)
{
  const shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  const shape::Mesh b =
    shapetest::Mirrored(shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3, -1, 1 })));
  const auto found = shape::FindLandmarks(a, b);
  EXPECT_LT(found.MirroredDistortion, 0.04);
  EXPECT_LT(found.MirroredDistortion, 0.8 * found.Distortion);
  EXPECT_TRUE(found.MirrorImage);
}

TEST(AutomaticLandmarks, OrientationTellsTheSidesOfASymmetricAnimal)
{
  const shape::Mesh a = ReadModel("bull");
  const shapetest::Renumbered copy = shapetest::Renumber(a, 7);
  shape::Mesh b = copy.Mesh;
  b.Points = b.Points * shapetest::Rotation(1.0, { 1, 1, 0 }).transpose();
  const auto found = shape::FindLandmarks(a, b);
  EXPECT_GE(found.Pairs.size(), 5u);
  for (const auto& [i, j] : found.Pairs)
  {
    EXPECT_EQ(j, copy.NewOf(i));
  }
  // Its mirror image is the same animal: left goes to left, which is not where mirroring goes.
  const auto other = shape::FindLandmarks(a, shapetest::Mirrored(a));
  EXPECT_NEAR(other.MirroredDistortion, 0.0, 1e-3);
  EXPECT_LT(other.Distortion, 0.06);
  int same = 0;
  for (const auto& [i, j] : other.Pairs)
  {
    same += i == j ? 1 : 0;
  }
  EXPECT_LE(same, static_cast<int>(other.Pairs.size()) / 2); // those in the middle
}

TEST(AutomaticLandmarks, AreThoseOfTheRankedMap)
{
  const shape::Mesh a = ReadModel("bull");
  const shapetest::Renumbered copy = shapetest::Renumber(a, 7);
  const auto best = shape::FindLandmarks(a, copy.Mesh);
  EXPECT_LT(best.Error, 1e-3); // the same triangles
  EXPECT_TRUE(best.Certain);
  ASSERT_GE(best.Alternatives, 2);
  shape::AutomaticLandmarksOptions options;
  double last = best.Error;
  for (options.Rank = 1; options.Rank < best.Alternatives; ++options.Rank)
  {
    const auto other = shape::FindLandmarks(a, copy.Mesh, options);
    EXPECT_EQ(other.Alternatives, best.Alternatives);
    EXPECT_GE(other.Error, last);
    EXPECT_EQ(other.RivalError, best.Error);
    EXPECT_EQ(other.Rival, best.Pairs);
    EXPECT_EQ(other.Confidence, 0.0);
    EXPECT_FALSE(other.Certain);
    EXPECT_NE(other.Pairs, best.Pairs);
    if (options.Rank == 1)
    {
      EXPECT_EQ(best.Rival, other.Pairs);
      EXPECT_EQ(best.RivalError, other.Error);
    }
    last = other.Error;
  }
  EXPECT_REFUSED(shape::FindLandmarks(a, copy.Mesh, options), "Rank is",
    "set Rank to at most " + std::to_string(best.Alternatives - 1));
  options.Rank = -1;
  EXPECT_REFUSED(shape::FindLandmarks(a, copy.Mesh, options), "Rank is -1");
}

TEST(AutomaticLandmarks, WorksOnAnyTopology)
{
  for (const char* name : { "elephant", "elk", "head" }) // of genus 3 and 1; with three borders
  {
    const shape::Mesh a = ReadModel(name);
    const shapetest::Renumbered copy = shapetest::Renumber(a, 3);
    const auto found = shape::FindLandmarks(a, copy.Mesh);
    EXPECT_LT(found.Distortion, 0.035) << name; // the samples differ
    EXPECT_LT(WorstError(a, copy.Mesh, Eigen::Matrix3d::Identity(), found.Pairs), 0.02) << name;
  }
}

TEST(AutomaticLandmarks, FindsAPartInTheWholeAndHowLargeItIs)
{
  using Which = shape::SurfacePart::WhichType;
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 1, 2, 3 });
  const shapetest::Cut cut =
    shapetest::Above(shapetest::BumpySphere(4, Eigen::Matrix3d::Identity()), -0.45);
  shape::Mesh whole = shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3, -1, 1 }));
  whole.Points = whole.Points * turn.transpose();
  const double share =
    shape::ComputePointAreas(cut.Surface).sum() / shape::ComputePointAreas(whole).sum();
  ASSERT_LT(share, 0.82);
  const auto found = shape::FindLandmarks(cut.Surface, whole);
  EXPECT_EQ(found.Part, Which::SurfaceA);
  EXPECT_NEAR(found.Share, share, 0.1 * share);
  EXPECT_LT(found.Distortion, 0.05);
  EXPECT_LT(WorstError(cut.Surface, whole, turn, found.Pairs), 0.08);
  const auto other = shape::FindLandmarks(whole, cut.Surface);
  EXPECT_EQ(other.Part, Which::SurfaceB);
  EXPECT_NEAR(other.Share, share, 0.1 * share);

  // A surface with a border is whole beside another one that is cut as it is, or if told so.
  EXPECT_EQ(shape::FindLandmarks(cut.Surface, cut.Surface).Part, Which::None);
  shape::AutomaticLandmarksOptions options;
  options.PartA = false;
  const auto told = shape::FindLandmarks(cut.Surface, whole, options);
  EXPECT_EQ(told.Part, Which::None);
  EXPECT_GT(told.Distortion, found.Distortion);
}

TEST(AutomaticLandmarks, OfNearlyRoundShapesFollowTheirPositions)
{
  // The dents differ in depth, and so do the points and triangles. Features pair up within a fifth
  // of the root of the area; a wrong rotation moves points by a third, or more.
  const auto dented = [](const Eigen::Matrix3d& turn, double depth)
  {
    shape::Mesh mesh = shapetest::Icosphere(3);
    mesh.Points = mesh.Points * turn.transpose();
    for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
    {
      const double x = mesh.Points(i, 0), y = mesh.Points(i, 1), z = mesh.Points(i, 2);
      mesh.Points.row(i) *=
        1.0 + depth * std::sin(3.0 * x + y) - 0.05 * std::cos(2.0 * z - x) + 0.05 * y * z;
    }
    return mesh;
  };
  for (int i = 0; i < 4; ++i)
  {
    const shape::Mesh a = dented(shapetest::Rotation(0.3 * i, { 1, 2, 3 }), 0.05),
                      b = dented(shapetest::Rotation(1.0 + i, { 3, -1, 2 }), 0.06);
    const shape::Landmarks pairs = shape::FindLandmarks(a, b).Pairs;
    double mean = 0.0;
    for (const auto& [k, l] : pairs)
    {
      mean += (a.Points.row(k) - b.Points.row(l)).norm() / static_cast<double>(pairs.size());
    }
    EXPECT_LT(mean, 0.2 * std::sqrt(shape::ComputeArea(a))) << i;
  }
}

TEST(AutomaticLandmarks, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Eigen::Index n = sphere.Points.rows();
  const shape::Mesh both = shapetest::Twice(sphere);
  EXPECT_REFUSED(shape::FindLandmarks(sphere, both), "surface B");
  EXPECT_REFUSED(shape::FindLandmarks(both, sphere), "surface A");
  shape::Mesh loose = sphere;
  loose.Points.conservativeResize(n + 1, 3);
  loose.Points.row(n).setZero();
  EXPECT_THROW(shape::FindLandmarks(sphere, loose), shape::InvalidInput);
  EXPECT_REFUSED(
    shape::FindLandmarks(sphere, sphere, { 3, 12, 10, true, true, true }), "Samples is 3");
}

TEST(AutomaticLandmarks, OfAnOctahedronAreAGuess)
{
  const shape::Mesh whole = ReadModel("octahedron"); // few points, each like every other
  const auto found = shape::FindLandmarks(whole, whole);
  EXPECT_NEAR(found.Distortion, found.RivalDistortion, 1e-9);
  EXPECT_NEAR(found.Distortion, found.MirroredDistortion, 1e-9);
  EXPECT_NEAR(found.Confidence, 0.0, 1e-6);
}
