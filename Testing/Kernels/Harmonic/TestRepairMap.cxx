#include "Harmonic/RepairMap.h"

#include "Base/Errors.h"
#include "Geometry/Sampling.h"
#include "Harmonic/ApplyVolumeMap.h"
#include "Harmonic/PiecewiseInverseMap.h"
#include "Harmonic/Private/RingCertificate.h"
#include "Harmonic/Private/TetrahedronBox.h"
#include "Harmonic/Private/WholeRepair.h"
#include "Harmonic/VolumeTransform.h"
#include "Support/RandomPoints.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <set>
#include <string>

namespace
{

using shapetest::RandomPoints;

using shape::ChargeSet;
using shape::MapRepair;
using shape::RepairMap;
using shape::RepairMapResult;

/// The identity plus the field of a charge whose direction is `up`:
/// det J = 1 + strength up . (x - y) / (4 pi r^3), so the map folds below the charge, up to the
/// distance `radius`.
ChargeSet OneFold(const Eigen::RowVector3d& position, const Eigen::RowVector3d& up, double radius)
{
  ChargeSet map;
  map.Points = position;
  map.Charges = -4.0 * M_PI * radius * radius * up.normalized();
  return map;
}

/// A ball whose triangles are about as large as the tetrahedra.
shape::Surface Ball()
{
  return shape::Surface(shapetest::Icosphere(4));
}

shape::PiecewiseCharges AsPiecewise(
  const ChargeSet& map, const shape::Surface& domain, const MapRepair& repair)
{
  shape::PiecewiseCharges charges{ { map }, domain, {} };
  charges.Repair = repair;
  return charges;
}

double Determinant(const Eigen::MatrixXd& jacobians, Eigen::Index row)
{
  return shape::GetJacobian(jacobians, row).determinant();
}

/// Random weights of a tetrahedron's corners.
Eigen::RowVector4d RandomWeights(std::mt19937& random)
{
  std::exponential_distribution<double> exponential;
  const Eigen::RowVector4d weights =
    Eigen::RowVector4d::NullaryExpr([&] { return exponential(random); });
  return weights / weights.sum();
}

/// Random positions in the tetrahedra of a repair, `each` in every one.
Eigen::MatrixXd PositionsIn(const MapRepair& repair, int each, std::mt19937& random)
{
  const Eigen::Index count = repair.Elements.Tetrahedra.rows();
  Eigen::MatrixXd positions(each * count, 3);
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    const Eigen::RowVector4i corners = repair.Elements.Tetrahedra.row(i % count);
    positions.row(i) = RandomWeights(random) * repair.Elements.Points(corners, Eigen::all);
  }
  return positions;
}

/// Expects what holds for every repaired map of the ball.
void ExpectRepaired(const ChargeSet& map, const RepairMapResult& result)
{
  EXPECT_GE(result.CertifiedShare, 0.999);
  EXPECT_NEAR(result.CertifiedShare + result.InvertedShare + result.UndecidedShare, 1.0, 1e-12);
  const auto repaired =
    std::make_shared<const shape::PiecewiseHarmonicMap>(AsPiecewise(map, Ball(), result.Repair));
  std::mt19937 random(5);

  // Away from the repair, f is unchanged.
  Eigen::MatrixXd away = 0.95 * RandomPoints(2000, random).rowwise().normalized();
  away.array().colwise() *= RandomPoints(2000, random).col(0).array();
  const shape::PiecewiseHarmonicMap::RepairPositions at = repaired->LocateInRepair(away);
  std::vector<int> outside;
  for (int i = 0; i < at.Cells.size(); ++i)
  {
    if (at.Cells(i) < 0)
    {
      outside.push_back(i);
    }
  }
  ASSERT_GT(outside.size(), 500u);
  const Eigen::MatrixXd unchanged = away(outside, Eigen::all);
  EXPECT_EQ(repaired->Evaluate(unchanged), shape::Evaluate(map, unchanged));

  // Where it is certified, the determinant is positive, in the repair, too.
  const Eigen::MatrixXd inside = PositionsIn(result.Repair, 4, random);
  const Eigen::MatrixXd jacobians = repaired->Jacobians(inside);
  int inverted = 0;
  for (Eigen::Index i = 0; i < inside.rows(); ++i)
  {
    inverted += !(Determinant(jacobians, i) > 0.0);
  }
  EXPECT_EQ(inverted, 0);

  // The map is continuous: across any short segment it changes by no more than its derivative
  // allows, also at the faces of core and ring.
  constexpr double step = 1e-8;
  const Eigen::MatrixXd faces = [&]
  {
    Eigen::MatrixXd positions(4 * result.Repair.Elements.Tetrahedra.rows(), 3);
    for (Eigen::Index i = 0; i < positions.rows(); ++i)
    {
      Eigen::RowVector4d weights = RandomWeights(random);
      weights(i % 4) = 0.0;
      positions.row(i) = weights / weights.sum() *
        result.Repair.Elements.Points(result.Repair.Elements.Tetrahedra.row(i / 4), Eigen::all);
    }
    return positions;
  }();
  const Eigen::MatrixXd steps = step * RandomPoints(static_cast<int>(faces.rows()), random);
  const Eigen::VectorXd jumps =
    (repaired->Evaluate(faces + steps) - repaired->Evaluate(faces - steps)).rowwise().norm();
  const double steepest = jacobians.rowwise().norm().maxCoeff();
  EXPECT_LT(jumps.maxCoeff(), 4.0 * step * (steepest + 1.0));

  // The inverse finds each position again.
  Eigen::MatrixXd all(inside.rows() / 4 + unchanged.rows(), 3);
  all << inside.topRows(inside.rows() / 4), unchanged;
  const shape::PiecewiseInverseMap inverse(repaired);
  const shape::InverseMap::Result found = inverse.Find(repaired->Evaluate(all));
  EXPECT_EQ(found.States.maxCoeff(), 0);
  EXPECT_LT((found.Points - all).rowwise().norm().maxCoeff(), 1e-7);
}

} // namespace

// A fold inside the ball is repaired, and the rest of the map stays.
TEST(RepairMap, RepairsAFoldInside)
{
  for (const double radius : { 1e-2, 1e-3 })
  {
    const ChargeSet map = OneFold({ 0.21, -0.13, 0.34 }, { 0.3, -0.5, 0.8 }, radius);
    shape::RepairMapOptions options;
    options.Tetrahedra = 20000;
    const RepairMapResult result = RepairMap(map, Ball(), {}, options);
    EXPECT_LT(result.CertifiedBefore, 1.0);
    EXPECT_GT(result.CoreShare, 0.0);
    EXPECT_LT(result.CoreShare + result.RingShare, 0.05);
    EXPECT_EQ(result.CertifiedShare, 1.0);
    ExpectRepaired(map, result);
  }
}

// A fold at the surface is repaired, and the boundary of the core gets the images that are given.
TEST(RepairMap, RepairsAFoldAtTheSurface)
{
  const shape::Surface ball = Ball();
  const Eigen::RowVector3d pole = ball.Points().row(77);
  const ChargeSet map = OneFold(1.005 * pole, pole, 1e-2);
  shape::RepairMapOptions options;
  options.Tetrahedra = 20000;
  const RepairMapResult result = RepairMap(map, ball, ball.Points(), options);
  EXPECT_GT(result.InvertedBefore, 0.0);
  ExpectRepaired(map, result);
  const shape::PiecewiseHarmonicMap repaired(AsPiecewise(map, ball, result.Repair));
  EXPECT_LT((repaired.Evaluate(pole) - pole).norm(), 1e-12);
}

// Around the charge, f errs by much more than the thickness of the image. Only few of the points
// that lie outside of it by f are moved one by one.
TEST(RepairMap, RepairsAThinImage)
{
  const shape::Surface ball = Ball();
  ChargeSet map = OneFold({ 0.21, -0.13, 0.34 }, { 0.3, -0.5, 0.8 }, 2e-2);
  map.Affine.leftCols<3>() = Eigen::Vector3d(1.0, 1.0, 1e-3).asDiagonal();
  Eigen::MatrixXd targets = ball.Points();
  targets.col(2) *= 1e-3;
  shape::RepairMapOptions options;
  options.Tetrahedra = 20000;
  const RepairMapResult result = RepairMap(map, ball, targets, options);
  EXPECT_LT(result.CertifiedBefore, 0.99);
  EXPECT_EQ(result.CertifiedShare, 1.0);
  EXPECT_EQ(result.UndecidedShare, 0.0);
  EXPECT_EQ(result.ImageCrossings, 0);
}

// No map without folds has images that cross. The repair says so, and inverts little.
TEST(RepairMap, CountsCrossingImages)
{
  const shape::Surface ball = Ball();
  const Eigen::RowVector3d pole = ball.Points().row(77);
  Eigen::MatrixXd targets = ball.Points();
  targets.row(77) *= -1.5;
  shape::RepairMapOptions options;
  options.Tetrahedra = 20000;
  const RepairMapResult result =
    RepairMap(OneFold(1.005 * pole, pole, 1e-2), ball, targets, options);
  EXPECT_GT(result.ImageCrossings, 0);
  EXPECT_GT(result.InvertedShare, 0.0);
  EXPECT_LT(result.InvertedShare, 0.01);
  EXPECT_EQ(result.UndecidedShare, 0.0);
}

// A fold at a dent elsewhere is repaired as if no images crossed. The part that crosses, through
// the whole ball, does not grow again and again.
TEST(RepairMap, RepairsAFoldBesideCrossingImages)
{
  const shape::Surface ball = Ball();
  const Eigen::RowVector3d pole = ball.Points().row(77);
  Eigen::MatrixXd targets = ball.Points();
  targets.row(77) *= -1.5;
  ChargeSet map = OneFold(1.005 * pole, pole, 1e-2);
  int aside = 0;
  (ball.Points() * pole.transpose()).cwiseAbs().minCoeff(&aside);
  const Eigen::RowVector3d place = ball.Points().row(aside);
  targets.row(aside) *= 0.7;
  const ChargeSet other = OneFold(1.005 * place, place, 1e-2);
  map.Points.conservativeResize(2, 3);
  map.Points.row(1) = other.Points;
  map.Charges.conservativeResize(2, 3);
  map.Charges.row(1) = other.Charges;
  shape::RepairMapOptions options;
  options.Tetrahedra = 20000;
  const RepairMapResult result = RepairMap(map, ball, targets, options);
  EXPECT_GT(result.ImageCrossings, 0);
  EXPECT_GT(result.InvertedShare, 0.0);
  EXPECT_EQ(result.Rounds, 1);
  int near = 0;
  for (const auto& corners : result.Repair.Elements.Tetrahedra.rowwise())
  {
    const Eigen::MatrixXd points = result.Repair.Elements.Points(corners, Eigen::all);
    const Eigen::MatrixXd images = result.Repair.Elements.Images(corners, Eigen::all);
    if ((points.colwise().mean() - place).norm() < 0.3)
    {
      ++near;
      EXPECT_GT((images.bottomRows<3>().rowwise() - images.row(0)).determinant(), 0.0);
    }
  }
  EXPECT_GT(near, 10);
}

// The map is replaced in the whole ball, which has no more points than its boundary needs. If the
// images cross, there is no such map.
TEST(RepairWhole, MapsTheBoundaryAsPrescribed)
{
  const shape::Surface ball(shapetest::Icosphere(3));
  const Eigen::RowVector3d pole = ball.Points().row(77);
  const ChargeSet map = OneFold(1.005 * pole, pole, 1e-2);
  Eigen::MatrixXd targets = ball.Points() * Eigen::Vector3d(1.0, 2.0, 0.1).asDiagonal();
  const MapRepair whole = shape::RepairWhole(map, ball, targets, {});
  const shape::PiecewiseHarmonicMap repaired(AsPiecewise(map, ball, whole));
  EXPECT_LT((repaired.Evaluate(ball.Points()) - targets).cwiseAbs().maxCoeff(), 1e-12);
  double volume = 0.0, least = 1.0;
  for (const auto& corners : whole.Elements.Tetrahedra.rowwise())
  {
    const Eigen::MatrixXd points = whole.Elements.Points(corners, Eigen::all);
    const Eigen::MatrixXd images = whole.Elements.Images(corners, Eigen::all);
    volume += (points.bottomRows<3>().rowwise() - points.row(0)).determinant() / 6.0;
    least = std::min(least, (images.bottomRows<3>().rowwise() - images.row(0)).determinant());
  }
  EXPECT_GT(least, 0.0);
  EXPECT_NEAR(volume, shape::ComputeEnclosedVolume(ball), 1e-9);

  targets.row(77) *= -1.5;
  EXPECT_EQ(shape::RepairWhole(map, ball, targets, {}).Elements.Tetrahedra.rows(), 0);
}

// TetGen fills no ball with an edge of a few roundings. The map stays, with what is proven of it.
TEST(RepairMap, LeavesAMapWhoseSolidIsNotFilled)
{
  shape::Mesh mesh = shapetest::Icosphere(4);
  const int fixed = mesh.Triangles(0, 0), moved = mesh.Triangles(0, 1);
  const Eigen::RowVector3d edge = mesh.Points.row(moved) - mesh.Points.row(fixed);
  mesh.Points.row(moved) = mesh.Points.row(fixed) + 1e-14 * edge.normalized();
  shape::RepairMapOptions options;
  options.Tetrahedra = 20000;
  const RepairMapResult result = RepairMap(
    OneFold({ 0.21, -0.13, 0.34 }, { 0.3, -0.5, 0.8 }, 1e-2), shape::Surface(mesh), {}, options);
  EXPECT_FALSE(result.Unfilled.empty());
  EXPECT_EQ(result.Repair.Elements.Tetrahedra.rows(), 0);
  EXPECT_LT(result.CertifiedShare, 1.0);
  EXPECT_GT(result.CertifiedShare, 0.99);
  EXPECT_EQ(result.CertifiedShare, result.CertifiedBefore);
}

// The repair ends at the first report that its caller answers with no, in each of its stages.
TEST(RepairMap, Aborts)
{
  const shape::Surface ball = Ball();
  const Eigen::RowVector3d pole = ball.Points().row(77);
  const ChargeSet map = OneFold(1.005 * pole, pole, 1e-2);
  shape::RepairMapOptions options;
  options.Tetrahedra = 20000;
  std::set<std::string> stages;
  RepairMap(map, ball, ball.Points(), options,
    shape::Progress([&](double, const char* stage) { return stages.insert(stage), true; }));
  EXPECT_EQ(stages.count("untangling the core"), 1u);
  for (const std::string& last : stages)
  {
    const shape::Progress abort([&](double, const char* stage) { return stage != last; });
    EXPECT_THROW(RepairMap(map, ball, ball.Points(), options, abort), shape::Aborted) << last;
  }
}

// A map without folds gets no repair.
TEST(RepairMap, LeavesAMapWithoutFolds)
{
  const ChargeSet map = OneFold({ 0.0, 0.0, 1.5 }, { 0.0, 0.0, 1.0 }, 0.2);
  const RepairMapResult result = RepairMap(map, Ball());
  EXPECT_EQ(result.Repair.Elements.Tetrahedra.rows(), 0);
  EXPECT_EQ(result.CertifiedShare, 1.0);
}

// The result does not depend on the rigid motion and the scale of the solid, up to the mesh.
TEST(RepairMap, FarFromTheOrigin)
{
  const Eigen::RowVector3d shift(2000.0, -300.0, 40.0);
  shape::Mesh mesh = shapetest::Icosphere(4);
  mesh.Points *= 10.0;
  mesh.Points.rowwise() += shift;
  const ChargeSet map =
    OneFold(shift + Eigen::RowVector3d(2.1, -1.3, 3.4), { 0.3, -0.5, 0.8 }, 0.1);
  shape::RepairMapOptions options;
  options.Tetrahedra = 20000;
  EXPECT_EQ(RepairMap(map, shape::Surface(mesh), {}, options).CertifiedShare, 1.0);
}

// The transform evaluates the same map and its derivative, which finite differences confirm.
TEST(RepairMap, TransformsAgree)
{
  const ChargeSet map = OneFold({ 0.21, -0.13, 0.34 }, { 0.3, -0.5, 0.8 }, 1e-2);
  shape::RepairMapOptions options;
  options.Tetrahedra = 20000;
  const RepairMapResult result = RepairMap(map, Ball(), {}, options);
  const shape::PiecewiseCharges charges = AsPiecewise(map, Ball(), result.Repair);
  const shape::PiecewiseHarmonicMap repaired(charges);
  const shape::VolumeTransform transform(charges, true);
  std::mt19937 random(9);
  const Eigen::MatrixXd positions = PositionsIn(result.Repair, 1, random);
  const Eigen::MatrixXd values = repaired.Evaluate(positions);
  const Eigen::MatrixXd jacobians = repaired.Jacobians(positions);
  constexpr double step = 1e-7;
  int places = 0, within = 0;
  for (Eigen::Index i = 0; i < positions.rows(); i += 7)
  {
    const auto forward = transform.Forward(Eigen::Vector3d(positions.row(i).transpose()));
    EXPECT_LT((forward.Position - values.row(i).transpose()).norm(), 1e-12);
    const Eigen::Matrix3d jacobian = shape::GetJacobian(jacobians, i);
    EXPECT_LT((forward.Jacobian - jacobian).norm(), 1e-9 * (1.0 + jacobian.norm()));
    const auto backward = transform.Backward(forward.Position);
    EXPECT_EQ(backward.State, shape::InverseMap::State::Found);
    EXPECT_LT((backward.Position - positions.row(i).transpose()).norm(), 1e-7);
    // Both ends of the difference must be in the same tetrahedron.
    Eigen::MatrixXd ends(2, 3);
    ends << positions.row(i), positions.row(i);
    ends(0, 0) += step;
    ends(1, 0) -= step;
    const Eigen::VectorXi cells = repaired.LocateInRepair(ends).Cells;
    ++places;
    if (cells(0) >= 0 && cells(0) == cells(1))
    {
      ++within;
      const Eigen::MatrixXd moved = repaired.Evaluate(ends);
      EXPECT_LT(((moved.row(0) - moved.row(1)).transpose() / (2.0 * step) - jacobian.col(0)).norm(),
        1e-4 * (1.0 + jacobian.norm()));
    }
  }
  EXPECT_GT(within, 0.9 * places);
}

// Random maps, images and shares: no sample contradicts a certified tetrahedron.
TEST(RingCertificate, IsNeverWrong)
{
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int certified = 0, undecided = 0, wrong = 0;
  for (int trial = 0; trial < 500; ++trial)
  {
    ChargeSet map;
    map.Points = RandomPoints(40, random).rowwise().normalized();
    map.Points.array().colwise() *=
      1.02 + Eigen::ArrayXd::NullaryExpr(40, [&] { return uniform(random); });
    map.Charges = 0.5 * RandomPoints(40, random);
    map.Affine.leftCols<3>() += 0.2 * RandomPoints(3, random);
    MapRepair repair;
    repair.Elements.Points = 0.3 * RandomPoints(4, random);
    repair.Elements.Points.rowwise() += 0.6 * RandomPoints(1, random).row(0);
    repair.Elements.Tetrahedra = Eigen::RowVector4i(0, 1, 2, 3);
    const Eigen::Matrix3d edges =
      repair.Elements.Points.bottomRows<3>().rowwise() - repair.Elements.Points.row(0);
    if (edges.determinant() < 0.0)
    {
      std::swap(repair.Elements.Tetrahedra(2), repair.Elements.Tetrahedra(3));
    }
    repair.Elements.Images = shape::Evaluate(map, repair.Elements.Points) +
      0.1 * uniform(random) * RandomPoints(4, random);
    repair.Shares = Eigen::Vector4d(0.0, 0.0, 1.0, 1.0);
    repair.Shares(1) = trial % 2;
    if (!shape::FindUncertified(map, repair, { 0 }).empty())
    {
      ++undecided;
      continue;
    }
    ++certified;
    const shape::PiecewiseHarmonicMap repaired(AsPiecewise(map, Ball(), repair));
    const Eigen::MatrixXd jacobians = repaired.Jacobians(PositionsIn(repair, 300, random));
    for (Eigen::Index i = 0; i < jacobians.rows(); ++i)
    {
      wrong += !(Determinant(jacobians, i) > 0.0);
    }
  }
  EXPECT_EQ(wrong, 0);
  // Both kinds occur.
  EXPECT_GT(certified, 50);
  EXPECT_GT(undecided, 50);
}

// A tetrahedron that has a point in a box is never left out, and most others are.
TEST(TetrahedronBox, FindsWhatMeets)
{
  std::mt19937 random(4);
  int met = 0, missed = 0, apart = 0;
  for (int trial = 0; trial < 3000; ++trial)
  {
    const Eigen::Matrix<double, 4, 3> corners = RandomPoints(4, random);
    const Eigen::Vector3d centre = RandomPoints(1, random).transpose();
    const Eigen::Vector3d half = 0.2 * RandomPoints(1, random).cwiseAbs().transpose();
    const Eigen::AlignedBox3d box(centre - half, centre + half);
    bool meets = false;
    for (int sample = 0; sample < 200 && !meets; ++sample)
    {
      meets = box.contains((RandomWeights(random) * corners).transpose());
    }
    const bool found = shape::MayMeet(corners, box);
    met += meets;
    missed += meets && !found;
    apart += !found;
  }
  EXPECT_EQ(missed, 0);
  EXPECT_GT(met, 100);
  EXPECT_GT(apart, 1000);
}

TEST(RepairMap, RejectsWhatItCannotUse)
{
  const ChargeSet map = OneFold({ 0.2, 0.1, 0.3 }, { 0.0, 0.0, 1.0 }, 1e-2);
  EXPECT_THROW(RepairMap(map, Ball(), Eigen::MatrixXd::Zero(3, 3)), shape::InvalidInput);
  shape::RepairMapOptions options;
  options.MaximumRounds = 0;
  EXPECT_THROW(RepairMap(map, Ball(), {}, options), shape::InvalidInput);
  options = {};
  options.MaximumInvertedShare = std::nan("");
  EXPECT_THROW(RepairMap(map, Ball(), {}, options), shape::InvalidInput);
  // A boundary that crosses itself.
  shape::Mesh crossing = Ball();
  crossing.Points.row(77) *= -1.5;
  EXPECT_THROW(RepairMap(map, shape::Surface(crossing)), shape::InvalidInput);
  // A repair of the wrong shape, or of a map of several regions.
  MapRepair repair;
  repair.Elements.Points = RandomPoints(4, *std::make_unique<std::mt19937>(1));
  repair.Elements.Images = repair.Elements.Points;
  repair.Elements.Tetrahedra = Eigen::RowVector4i(0, 1, 2, 3);
  EXPECT_THROW(shape::PiecewiseHarmonicMap(AsPiecewise(map, Ball(), repair)), shape::InvalidInput);
}
