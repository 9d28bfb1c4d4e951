#include "Harmonic/Certificate.h"

#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "Harmonic/Private/DeterminantSign.h"
#include "Harmonic/Private/TaylorExpansion.h"
#include "Mesh/UsedPoints.h"
#include "Support/RandomPoints.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/LU>

#include <cmath>
#include <numeric>
#include <random>

namespace
{

using shapetest::RandomPoints;

using shape::CertifyMap;
using shape::ChargeSet;
using shape::MapCertificate;
using shape::MapCertificateOptions;
using shape::Mesh;
using shape::TaylorExpansion;

constexpr int Inverted = static_cast<int>(MapCertificate::BoxState::Inverted);
constexpr int Certified = static_cast<int>(MapCertificate::BoxState::Certified);

/// The identity plus the field of one charge at height `distance` over the north pole of the unit
/// sphere in the direction `up`: det J = 1 + strength up . (x - y) / (4 pi r^3), which is
/// 1 - strength / (4 pi distance^2) at the pole.
ChargeSet OneCharge(const Eigen::RowVector3d& up, double distance, double strength)
{
  ChargeSet map;
  map.Points = (1.0 + distance) * up;
  map.Charges = -strength * up;
  return map;
}

double Determinant(const ChargeSet& map, const Eigen::RowVector3d& position)
{
  return shape::GetJacobian(shape::EvaluateJacobians(map, position), 0).determinant();
}

double WorstAtPoints(const ChargeSet& map, const Eigen::MatrixXd& points)
{
  const Eigen::MatrixXd jacobians = shape::EvaluateJacobians(map, points);
  double worst = std::numeric_limits<double>::infinity();
  for (Eigen::Index i = 0; i < jacobians.rows(); ++i)
  {
    worst = std::min(worst, shape::GetJacobian(jacobians, i).determinant());
  }
  return worst;
}

/// The charges as TaylorExpansion takes them.
shape::ChargeColumns AsColumns(const ChargeSet& map)
{
  shape::ChargeColumns columns(6, map.Points.rows());
  columns << map.Points.transpose(), map.Charges.transpose() / (4.0 * M_PI);
  return columns;
}

/// Expects that the boxes cover the domain once, and that the shares are those of the volumes.
void ExpectCover(const MapCertificate& result, const Mesh& domain)
{
  const double volume = shape::ComputeEnclosedVolume(domain);
  EXPECT_NEAR(result.Volumes.sum(), volume, 1e-9 * volume);
  EXPECT_NEAR(result.CertifiedShare + result.InvertedShare + result.UndecidedShare, 1.0, 1e-12);
}

} // namespace

// The bounds of the remainder hold, and are not far from the errors.
TEST(TaylorExpansion, BoundsItsError)
{
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial)
  {
    ChargeSet map;
    map.Points = RandomPoints(3, random);
    map.Points.rowwise() += Eigen::RowVector3d(3.0, 0.0, 0.0);
    map.Charges = RandomPoints(3, random);
    map.Affine.setZero();
    const Eigen::RowVector3d centre = RandomPoints(1, random);
    const double radius = 0.5 * (map.Points.rowwise() - centre).rowwise().norm().minCoeff();
    const Eigen::RowVector3d step = radius * RandomPoints(1, random).normalized();
    const int degree = 1 + trial % TaylorExpansion::Degree;
    TaylorExpansion expansion;
    expansion.Add(AsColumns(map), { 0, 1, 2 }, centre.transpose(), radius, degree);
    const TaylorExpansion near = expansion.GetLowTerms(0.5 * step.transpose());
    TaylorExpansion all = expansion;
    all.Shift(0.5 * step.transpose());
    EXPECT_TRUE(near.Coefficients.topRows<35>().isApprox(all.Coefficients.topRows<35>(), 1e-12));
    expansion.Shift(step.transpose());
    const Eigen::MatrixXd exact = shape::EvaluateJacobians(map, centre + step);
    for (int c = 0; c < 3; ++c)
    {
      const double error =
        (expansion.Coefficients.col(c).segment<3>(1).transpose() - exact.row(0).segment<3>(3 * c))
          .norm();
      EXPECT_LE(error, expansion.Remainder(c) + 1e-14);
      EXPECT_LE(exact.row(0).segment<3>(3 * c).norm(), expansion.Magnitude(c) + 1e-14);
    }
  }
  // Towards a single charge, the bound is the error.
  ChargeSet map;
  map.Points = Eigen::RowVector3d(2.0, 0.0, 0.0);
  map.Charges = Eigen::RowVector3d(1.0, 0.0, 0.0);
  TaylorExpansion expansion;
  map.Charges *= 4.0 * M_PI;
  expansion.Add(AsColumns(map), { 0 }, Eigen::Vector3d::Zero(), 1.0, 5);
  expansion.Shift(Eigen::Vector3d(1.0, 0.0, 0.0));
  EXPECT_NEAR(1.0 - expansion.Coefficients(1, 0), expansion.Remainder(0), 1e-13);
}

// In a smaller cube, the low terms and the bound of the others hold together.
TEST(TaylorExpansion, BoundsItsHighTerms)
{
  std::mt19937 random(8);
  double closest = 0.0;
  for (int trial = 0; trial < 200; ++trial)
  {
    ChargeSet map;
    map.Points = 2.5 * RandomPoints(3, random).rowwise().normalized();
    map.Charges = RandomPoints(3, random);
    constexpr double half = 0.5, smaller = 0.1;
    TaylorExpansion expansion;
    expansion.Add(
      AsColumns(map), { 0, 1, 2 }, Eigen::Vector3d::Zero(), 2.0 * half, TaylorExpansion::Degree);
    const Eigen::Vector3d step = (half - smaller) * RandomPoints(1, random).transpose();
    const Eigen::Vector3d rest = smaller * RandomPoints(1, random).transpose().cwiseSign();
    TaylorExpansion low = expansion.GetLowTerms(step), all = expansion;
    low.Shift(rest);
    all.Shift(step + rest);
    const Eigen::Matrix3d bound = expansion.BoundHighTerms(half) * std::pow(smaller, 4);
    const Eigen::Matrix3d error =
      (low.Coefficients.middleRows<3>(1) - all.Coefficients.middleRows<3>(1))
        .transpose()
        .cwiseAbs();
    EXPECT_TRUE((error.array() <= bound.array() + 1e-14).all());
    closest = std::max(closest, (error.array() / bound.array()).maxCoeff());
  }
  EXPECT_GT(closest, 0.02);
}

// Random Jacobians, whose singular values differ by up to 1000: no sample of the box contradicts
// the sign or the bound. Boxes are as large as the expansion allows, and of any proportions.
TEST(DeterminantSign, IsNeverWrong)
{
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  int positive = 0, negative = 0, wrong = 0;
  double closest = std::numeric_limits<double>::infinity();
  for (int trial = 0; trial < 3000; ++trial)
  {
    ChargeSet map;
    map.Points = 2.0 * RandomPoints(6, random).rowwise().normalized();
    map.Charges = std::exp2(-6.0 * uniform(random)) * 20.0 * RandomPoints(6, random);
    const Eigen::Vector3d scales =
      Eigen::Array3d::NullaryExpr([&] { return std::pow(10.0, -3.0 * uniform(random)); });
    map.Affine.leftCols<3>() = RandomPoints(3, random);
    // Scaled images, so that one component may be nearly constant.
    map.Affine = scales.asDiagonal() * map.Affine;
    map.Charges = map.Charges * scales.asDiagonal();
    const Eigen::Vector3d half = std::exp2(-3.0 * uniform(random)) *
      Eigen::Array3d::NullaryExpr([&] { return 0.05 + uniform(random); });
    TaylorExpansion expansion;
    expansion.Coefficients.middleRows<3>(1) = map.Affine.leftCols<3>().transpose();
    constexpr int degree = TaylorExpansion::LowDegree;
    expansion.Add(AsColumns(map), { 0, 1, 2, 3, 4, 5 }, Eigen::Vector3d::Zero(),
      std::min(1.9, half.norm() * (1.0 + 1e-12)), degree);
    if (half.norm() > 1.9)
    {
      continue;
    }
    const shape::DeterminantSign verdict = shape::BoundDeterminant(expansion, half, degree);
    if (verdict.Sign == 0)
    {
      continue;
    }
    (verdict.Sign > 0 ? positive : negative) += 1;
    // At random positions, half of them on edges and at corners.
    Eigen::MatrixXd samples = RandomPoints(600, random);
    samples.topRows(300) = samples.topRows(300).cwiseSign();
    samples.topRows(150).col(trial % 3) = samples.middleRows(300, 150).col(0);
    const Eigen::MatrixXd jacobians = shape::EvaluateJacobians(map, samples * half.asDiagonal());
    double lowest = std::numeric_limits<double>::infinity();
    for (Eigen::Index i = 0; i < jacobians.rows(); ++i)
    {
      lowest = std::min(lowest, verdict.Sign * shape::GetJacobian(jacobians, i).determinant());
    }
    wrong += lowest < verdict.Bound || verdict.Bound <= 0.0;
    closest = std::min(closest, lowest / verdict.Bound);
  }
  EXPECT_EQ(wrong, 0);
  EXPECT_GT(positive, 300);
  EXPECT_GT(negative, 300);
  // The bounds are not idle.
  EXPECT_LT(closest, 1.2);
}

// An affine map is certified by one box; its determinant is known. A reflection is inverted.
TEST(MapCertificate, DecidesAffineMapsAtOnce)
{
  Mesh mesh = shapetest::Torus(1.0, 0.3, 24, 12);
  mesh.Points.rowwise() += Eigen::RowVector3d(1000.0, -20.0, 5.0);
  ChargeSet map;
  map.Affine << 2, 0.3, 0, 7, -0.5, 1, 0.2, 8, 0, 0.1, 3, 9;
  const double determinant = map.Affine.leftCols<3>().determinant();
  const MapCertificate result = CertifyMap(map, mesh);
  ASSERT_EQ(result.States.size(), 1);
  EXPECT_EQ(result.States(0), Certified);
  EXPECT_NEAR(result.Determinants(0), determinant, 1e-9 * determinant);
  EXPECT_LE(result.Determinants(0), determinant);
  EXPECT_EQ(result.CertifiedShare, 1.0);
  EXPECT_TRUE(result.Bijective);
  ExpectCover(result, mesh);

  map.Affine.row(1) *= -1.0;
  const MapCertificate mirrored = CertifyMap(map, mesh);
  EXPECT_EQ(mirrored.InvertedShare, 1.0);
  EXPECT_FALSE(mirrored.Bijective);
  ASSERT_EQ(mirrored.Witnesses.rows(), 1);
  EXPECT_NEAR(mirrored.WitnessDeterminants(0), -determinant, 1e-9 * determinant);
  EXPECT_LT(
    shape::SignedDistance(shape::Surface(mesh)).Evaluate(mirrored.Witnesses).Distances.maxCoeff(),
    1e-9);
}

// Diffeomorphisms with the known minimum 1 - share of det J at the pole, for charges at any
// distance. The nearer the charge, the smaller are the boxes that decide all of the domain.
TEST(MapCertificate, CertifiesKnownDiffeomorphisms)
{
  Mesh mesh = shapetest::Icosphere(3);
  for (const double distance : { 1.0, 0.1, 0.01 })
  {
    for (const double share : { 0.5, 0.95 })
    {
      const ChargeSet map =
        OneCharge(mesh.Points.row(37), distance, share * 4.0 * M_PI * distance * distance);
      EXPECT_GE(CertifyMap(map, mesh).CertifiedShare, 0.999) << distance << ' ' << share;
      MapCertificateOptions options;
      options.Tolerance = 0.002 * distance;
      const MapCertificate result = CertifyMap(map, mesh, options);
      EXPECT_EQ(result.CertifiedShare, 1.0) << distance << ' ' << share;
      EXPECT_TRUE(result.Bijective);
      EXPECT_EQ(result.Witnesses.rows(), 0);
      EXPECT_LE(result.Determinants.minCoeff(), 1.0 - share);
      EXPECT_GT(result.Determinants.minCoeff(), 0.0);
      ExpectCover(result, mesh);
    }
  }
}

// A charge at the distance 5e-4 from the sphere inverts what is nearer to it than 1e-3: a fold of
// radius 1e-3 in one of all directions.
TEST(MapCertificate, FindsEachSmallFold)
{
  const Mesh mesh = shapetest::Icosphere(4);
  std::mt19937 random(3);
  std::uniform_int_distribution<int> point(0, static_cast<int>(mesh.Points.rows()) - 1);
  for (int trial = 0; trial < 40; ++trial)
  {
    const Eigen::RowVector3d up = mesh.Points.row(point(random));
    constexpr double distance = 5e-4, radius = 1e-3;
    const ChargeSet map = OneCharge(up, distance, 4.0 * M_PI * radius * radius);
    const MapCertificate result = CertifyMap(map, mesh);
    EXPECT_FALSE(result.Bijective);
    ASSERT_GT(result.Witnesses.rows(), 0);
    EXPECT_LT(WorstAtPoints(map, result.Witnesses), 0.0);
    EXPECT_LT((result.Witnesses.rowwise() - map.Points.row(0)).rowwise().norm().maxCoeff(), radius);
    EXPECT_GT(result.CertifiedShare, 0.999);
    ExpectCover(result, mesh);
  }
}

// The slab |x| < width of the map with det J = 3 x^2 - 3 width^2 (after Wood, "Lewy's theorem fails
// in higher dimensions", 1991), which is a harmonic polynomial: charges on a sphere around the
// domain represent it.
TEST(MapCertificate, FindsAFoldInside)
{
  constexpr double width = 0.3, radius = 3.0;
  const auto wood = [&](const Eigen::RowVector3d& p)
  {
    return Eigen::RowVector3d(
      std::pow(p(0), 3) - 3.0 * p(0) * p(2) * p(2) + p(1) * p(2) - 3.0 * width * width * p(0),
      p(1) - 3.0 * p(0) * p(2), p(2));
  };
  // A single layer with the density (2 n + 1) / radius times a harmonic of degree n on the sphere
  // has this harmonic as its potential inside; the degrees of wood are 1, 2 and 3.
  Mesh sphere = shapetest::Icosphere(4);
  ChargeSet map;
  map.Affine.setZero();
  map.Points = radius * sphere.Points;
  map.Charges.resize(sphere.Points.rows(), 3);
  const Eigen::VectorXd areas = shape::ComputePointAreas(sphere) * radius * radius;
  const double total = 4.0 * M_PI * radius * radius / areas.sum();
  for (Eigen::Index i = 0; i < sphere.Points.rows(); ++i)
  {
    const Eigen::RowVector3d p = map.Points.row(i);
    const Eigen::RowVector3d all = wood(p), linear(-3.0 * width * width * p(0), p(1), p(2)),
                             square(p(1) * p(2), -3.0 * p(0) * p(2), 0.0);
    map.Charges.row(i) =
      total * areas(i) / radius * (3.0 * linear + 5.0 * square + 7.0 * (all - linear - square));
  }
  const Mesh domain = shapetest::Icosphere(3);
  MapCertificateOptions options;
  options.Tolerance = 1.0 / 64.0;
  const MapCertificate result = CertifyMap(map, domain, options);
  ExpectCover(result, domain);
  // The volume of the slab in the ball.
  const double expected = 0.75 * 2.0 * (width - std::pow(width, 3) / 3.0);
  EXPECT_GE(result.InvertedShare + result.UndecidedShare, expected * 0.99);
  EXPECT_LE(result.InvertedShare, expected * 1.1);
  ASSERT_GT(result.Witnesses.rows(), 10);
  for (Eigen::Index i = 0; i < result.Witnesses.rows(); ++i)
  {
    EXPECT_LE(result.WitnessDeterminants(i), 0.0);
    EXPECT_NEAR(result.WitnessDeterminants(i), Determinant(map, result.Witnesses.row(i)), 1e-9);
  }
  // What is neither certified nor in the slab is a layer of boxes, which become thinner.
  const double layer = 1.0 - expected - result.CertifiedShare;
  options.Tolerance *= 0.5;
  EXPECT_GT(layer, 0.0);
  EXPECT_LT(1.0 - expected - CertifyMap(map, domain, options).CertifiedShare, 0.6 * layer);
  EXPECT_FALSE(result.Bijective);
  EXPECT_LT(WorstAtPoints(map, result.Witnesses), 0.0);
}

// A thousand random maps: no sample contradicts a box.
TEST(MapCertificate, IsNeverWrong)
{
  const Mesh mesh = shapetest::Icosphere(1);
  const shape::SignedDistance inside{ shape::Surface(mesh) };
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  MapCertificateOptions options;
  options.Tolerance = 1.0 / 32.0;
  int certified = 0, folded = 0, wrong = 0;
  for (int trial = 0; trial < 1000; ++trial)
  {
    ChargeSet map;
    map.Points = RandomPoints(8, random).rowwise().normalized();
    map.Points.array().colwise() *=
      Eigen::ArrayXd::NullaryExpr(8, [&] { return 1.02 + uniform(random); });
    map.Charges = 3.0 * std::pow(uniform(random), 2) * RandomPoints(8, random);
    map.Affine.leftCols<3>() += 0.3 * RandomPoints(3, random);
    const MapCertificate result = CertifyMap(map, mesh, options);
    certified += result.Bijective;
    folded += result.Witnesses.rows() > 0;
    if (result.Witnesses.rows() > 0 && WorstAtPoints(map, result.Witnesses) > 0.0)
    {
      ++wrong;
    }
    // Samples in the domain, half of them at its surface, and the boxes that they are in.
    Eigen::MatrixXd samples(400, 3);
    samples << RandomPoints(200, random), shape::SampleRandomly(mesh, 200, trial);
    const Eigen::VectorXd distances = inside.Evaluate(samples).Distances;
    const Eigen::MatrixXd jacobians = shape::EvaluateJacobians(map, samples);
    for (Eigen::Index i = 0; i < samples.rows(); ++i)
    {
      if (distances(i) > 1e-12)
      {
        continue;
      }
      const double determinant = shape::GetJacobian(jacobians, i).determinant();
      int boxes = 0;
      for (Eigen::Index box = 0; box < result.Edges.size(); ++box)
      {
        if (((samples.row(i) - result.Centres.row(box)).array().abs() <= 0.5 * result.Edges(box))
              .all())
        {
          ++boxes;
          wrong += result.States(box) == Certified && determinant < result.Determinants(box);
        }
      }
      wrong += boxes == 0;
    }
  }
  EXPECT_EQ(wrong, 0);
  // Both kinds occur.
  EXPECT_GT(certified, 100);
  EXPECT_GT(folded, 100);
}

// A dipole between two balls draws them together. det J stays positive in both, but their images
// overlap.
TEST(MapCertificate, SeesABoundaryWhoseImageCrosses)
{
  const Mesh ball = shapetest::Icosphere(3);
  Mesh other = ball;
  other.Points.col(0).array() += 2.4;
  const Mesh both = shape::JoinMeshes({ ball, other });
  ChargeSet map;
  map.Points.resize(2, 3);
  map.Points << 1.15, 0.0, 0.0, 1.25, 0.0, 0.0;
  for (const bool overlap : { false, true })
  {
    // On the axis, the dipole p moves points at the distance 0.2 by p / (4 pi 0.04), nearly.
    const double charge = (overlap ? 1.5 : 0.5) * 4.0 * M_PI * std::pow(0.2, 3) / 0.1;
    map.Charges.setZero(2, 3);
    map.Charges.col(0) << charge, -charge;
    const MapCertificate result = CertifyMap(map, both);
    EXPECT_EQ(result.CertifiedShare, 1.0);
    EXPECT_EQ(result.BoundaryCrossings > 0, overlap);
    EXPECT_EQ(result.Bijective, !overlap);
  }
}

// A mirrored boundary encloses a negative volume, wherever it lies. A fold at the surface leaves it
// positive.
TEST(MapCertificate, TellsAMirroredBoundary)
{
  const Mesh mesh = shapetest::Icosphere(2);
  ChargeSet map = OneCharge(mesh.Points.row(5), 0.1, 4.0 * M_PI * 0.04);
  const MapCertificate folded = CertifyMap(map, mesh);
  EXPECT_GT(folded.InvertedShare, 0.0);
  EXPECT_FALSE(folded.BoundaryReversed);
  map.Affine.row(2) *= -1.0;
  map.Affine(2, 3) = 50.0;
  map.Charges.col(2) *= -1.0;
  const MapCertificate mirrored = CertifyMap(map, mesh);
  EXPECT_TRUE(mirrored.BoundaryReversed);
  EXPECT_FALSE(mirrored.BoundaryInjective);
  EXPECT_NEAR(mirrored.CertifiedShare, folded.InvertedShare, 0.01);
}

TEST(MapCertificate, StopsAtTheMaximumOfBoxes)
{
  const Mesh mesh = shapetest::Icosphere(3);
  const ChargeSet map = OneCharge(mesh.Points.row(5), 0.01, 4.0 * M_PI * 4e-4);
  MapCertificateOptions options;
  options.MaximumBoxes = 200;
  const MapCertificate result = CertifyMap(map, mesh, options);
  EXPECT_FALSE(result.Complete);
  EXPECT_LE(result.ExaminedBoxes, 200);
  EXPECT_GT(result.UndecidedShare, 0.0);
  ExpectCover(result, mesh);
  options.MaximumBoxes = 1000000;
  EXPECT_TRUE(CertifyMap(map, mesh, options).Complete);
}

TEST(MapCertificate, RejectsWhatItCannotUse)
{
  const Mesh mesh = shapetest::Icosphere(1);
  MapCertificateOptions options;
  options.Tolerance = 0.0;
  EXPECT_THROW(CertifyMap({}, mesh, options), shape::InvalidInput);
  options = {};
  options.MaximumBoxes = 0;
  EXPECT_THROW(CertifyMap({}, mesh, options), shape::InvalidInput);
  Mesh open = mesh;
  open.Triangles = mesh.Triangles.topRows(mesh.Triangles.rows() - 1).eval();
  EXPECT_THROW(CertifyMap({}, open), shape::InvalidInput);
}
