#include "Base/Errors.h"
#include "Correspondence/Conformal/MoebiusVoting.h"
#include "Correspondence/Conformal/Private/MidEdgeMap.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <string>

namespace
{

using shapetest::ReadModel;

using Complex = std::complex<double>;

/// The largest difference between z and the Moebius map of the stereographic projection of the unit
/// sphere that agrees with z at three points. Both are compared on the sphere.
double DifferenceFromStereographic(int level)
{
  const shape::Mesh sphere = shapetest::Icosphere(level);
  const shape::MidEdgeMap map = shape::FlattenMidEdges(sphere, 0, 3);
  // Seen from outside, stereographic projection from the north pole reverses orientation.
  Eigen::MatrixXd turned = sphere.Points;
  turned.col(1) *= -1.0;
  const shape::ComplexPoints exact = shape::ToComplexPoints(turned);
  const Eigen::Vector3i three(40, 7, 111);
  const Eigen::Matrix2cd moebius =
    shape::SolveMoebiusTransform(exact(three, Eigen::all), map.Points(three, Eigen::all));
  return (
    shape::ToSphere(shape::ApplyMoebiusTransform(exact, moebius)) - shape::ToSphere(map.Points))
    .rowwise()
    .norm()
    .mean();
}

/// The midpoint of corner k and the next corner of triangle t, in the plane before exp.
Complex MidPoint(const shape::MidEdgeMap& map, int t, int k)
{
  return { map.Harmonic(map.EdgeOf(t, k)), map.Conjugate(map.EdgeOf(t, k)) };
}

} // namespace

TEST(MoebiusVoting, EachTriangleOfMidpointsIsMappedByASimilarity)
{
  const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(4));
  const shape::MidEdgeMap map = shape::FlattenMidEdges(mesh, 5, 200);
  double worst = 0.0;
  for (int t = 0; t < static_cast<int>(mesh.Triangles.rows()); ++t)
  {
    // The triangle between midpoints has the shape of its triangle. Its sides in the plane and in
    // space have the same ratios and the same angle, which is positive.
    const Eigen::Matrix3d corners = shape::GetCorners(mesh, t);
    Complex first = MidPoint(map, t, 1) - MidPoint(map, t, 0),
            second = MidPoint(map, t, 2) - MidPoint(map, t, 0);
    first -= Complex(0.0, std::round(first.imag()));
    second -= Complex(0.0, std::round(second.imag()));
    const Eigen::RowVector3d one = 0.5 * (corners.row(2) - corners.row(0)),
                             other = 0.5 * (corners.row(2) - corners.row(1));
    const Complex inSpace(
      one.dot(other) / one.squaredNorm(), one.cross(other).norm() / one.squaredNorm());
    worst = std::max(worst, std::abs(second / first - inSpace) / std::abs(inSpace));
  }
  EXPECT_LT(worst, 1e-8);
}

TEST(MoebiusVoting, TheConjugateFunctionGrowsByTheFluxAroundTheSource)
{
  const shape::Mesh mesh = shapetest::Pebble(shapetest::Icosphere(3));
  const shape::MidEdgeMap map = shape::FlattenMidEdges(mesh, 5, 200);
  // Around each point the differences across the triangles, each within half a turn, add up to a
  // whole number: 1 in size at the source and the sink, and 0 elsewhere.
  Eigen::VectorXd around = Eigen::VectorXd::Zero(mesh.Points.rows());
  for (int t = 0; t < static_cast<int>(mesh.Triangles.rows()); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double step = (MidPoint(map, t, (k + 2) % 3) - MidPoint(map, t, k)).imag();
      around(mesh.Triangles(t, k)) += step - std::round(step);
    }
  }
  EXPECT_NEAR(around(5), 1.0, 1e-9);
  EXPECT_NEAR(around(200), -1.0, 1e-9);
  around(5) = around(200) = 0.0;
  EXPECT_LT(around.cwiseAbs().maxCoeff(), 1e-9);
}

TEST(MoebiusVoting, TheMapOfTheSphereConvergesToStereographicProjection)
{
  const double coarse = DifferenceFromStereographic(3), fine = DifferenceFromStereographic(4),
               finer = DifferenceFromStereographic(5);
  EXPECT_LT(fine, 0.5 * coarse);
  EXPECT_LT(finer, 0.5 * fine);
}

TEST(MoebiusVoting, ARenumberedCopyGetsTheVotesOfTheIdentity)
{
  for (const std::string name : { "pebble", "bull", "homer" })
  {
    const bool isRound = name == "pebble";
    const shape::Mesh a = isRound ? shapetest::Pebble(shapetest::Icosphere(4)) : ReadModel(name);
    const shapetest::Renumbered copy = shapetest::Renumber(a, 5);
    shape::Mesh b = copy.Mesh;
    b.Points = 3.0 * b.Points * shapetest::Rotation(1.0, { 2, -1, 3 }).transpose();
    const shape::MoebiusVotes votes = shape::VoteByMoebiusMaps(a, b);
    EXPECT_NEAR(votes.Votes.sum(), 1.0, 1e-12);
    // In thin extremities, places differ by rounding only, so not every sample has a partner.
    EXPECT_GE(static_cast<double>(votes.Pairs.size()),
      (isRound ? 1.0 : 0.9) * static_cast<double>(votes.SamplesOfA.size()))
      << name;
    for (const auto& [pointA, pointB] : votes.Pairs)
    {
      EXPECT_EQ(copy.NewOf(pointA), pointB) << name;
    }
  }
}

TEST(MoebiusVoting, AMirroredCopyIsNotMistakenForTheSurface)
{
  // Moebius maps keep orientation, so fewer samples find partners on the mirror image.
  const shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  const shape::MoebiusVotes same = shape::VoteByMoebiusMaps(a, a),
                            mirrored = shape::VoteByMoebiusMaps(a, shapetest::Mirrored(a));
  int fixed = 0;
  for (const auto& [pointA, pointB] : mirrored.Pairs)
  {
    fixed += pointA == pointB ? 1 : 0;
  }
  EXPECT_EQ(same.Pairs.size(), same.SamplesOfA.size());
  EXPECT_LT(2 * fixed, static_cast<int>(mirrored.Pairs.size()));
}

TEST(MoebiusVoting, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 24, 12);
  EXPECT_REFUSED(shape::VoteByMoebiusMaps(sphere, torus), "surface B has genus 1");
  EXPECT_REFUSED(shape::VoteByMoebiusMaps(shapetest::Twice(sphere), sphere), "2 components");
  shape::MoebiusVotingOptions options;
  options.Share = 1.5;
  EXPECT_REFUSED(shape::VoteByMoebiusMaps(sphere, sphere, options), "VotingShare");
  options = {};
  options.Tolerance = 0.0;
  EXPECT_REFUSED(shape::VoteByMoebiusMaps(sphere, sphere, options), "TripleTolerance");
  EXPECT_REFUSED(shape::FlattenMidEdges(sphere, 3, 3), "both point 3");
}
