#include "Correspondence/Functional/FunctionalMapFit.h"
#include "Geometry/VertexNormals.h"
#include "Spectrum/SpectralSignatures.h"
#include "Support/MatchingShapes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

namespace
{

/// A surface of area 1 with its descriptors.
struct Described
{
  shape::Mesh Unit;
  shape::LaplaceEigenpairs Spectrum;
  Eigen::MatrixXd Descriptors;
  std::vector<std::vector<int>> Curves;
  Eigen::MatrixXd Displacements;

  Described(shape::Mesh mesh, int landmark)
    : Unit(std::move(mesh))
    , Curves{ { landmark, landmark + 3, landmark + 11 }, { 4 * landmark, 200 } }
  {
    this->Unit.Points /= std::sqrt(shape::ComputePointAreas(this->Unit).sum());
    this->Spectrum = shape::SolveLaplaceEigenproblem(this->Unit, 12);
    this->Descriptors.resize(this->Unit.Points.rows(), 20);
    this->Descriptors << shape::ComputeWaveKernelSignature(this->Spectrum, 10),
      shape::ComputeWaveKernelFrom(this->Spectrum, landmark, 10);
  }
  shape::SurfaceDescriptors Surface() const
  {
    return { this->Unit, this->Spectrum, this->Descriptors, 0, this->Curves, this->Displacements };
  }
};

/// Two shapes that are not isometric.
struct DescribedPair
{
  Described A{ shapetest::BumpySphere(3, Eigen::Matrix3d::Identity()), 5 };
  Described B{ shapetest::Pebble(shapetest::Icosphere(3)), 70 };
};

shape::FunctionalMapFitOptions Options()
{
  shape::FunctionalMapFitOptions options;
  options.Size = 10;
  return options;
}

shape::FunctionalMaps Random(unsigned int seed)
{
  std::srand(seed);
  return { Eigen::MatrixXd::Random(10, 10), Eigen::MatrixXd::Random(10, 10) };
}

TEST(FunctionalMapEnergy, HasTheGradientAndThePolynomialOfItsValue)
{
  const DescribedPair pair;
  for (const auto mask : { shape::FunctionalMapFitOptions::MaskType::Laplacian,
         shape::FunctionalMapFitOptions::MaskType::Resolvent })
  {
    shape::FunctionalMapFitOptions options = Options();
    options.Mask = mask;
    options.LaplacianWeight = 0.7;
    options.CurveWeight = 0.6;
    options.DisplacementWeight = 0.2;
    options.OrthonormalityWeight = 0.4;
    options.InverseWeight = 0.3;
    const shape::FunctionalMapEnergy energy(pair.A.Surface(), pair.B.Surface(), options);
    const shape::FunctionalMaps maps = Random(1), gradient = energy.Gradient(maps);
    const auto moved = [&](const shape::FunctionalMaps& by, double step) {
      return energy.Value({ maps.AToB + step * by.AToB, maps.BToA + step * by.BToA });
    };
    for (const unsigned int seed : { 2U, 3U, 4U })
    {
      const shape::FunctionalMaps direction = Random(seed);
      constexpr double step = 1e-4;
      const double slope = (moved(direction, step) - moved(direction, -step)) / (2.0 * step),
                   expected = gradient.AToB.cwiseProduct(direction.AToB).sum() +
        gradient.BToA.cwiseProduct(direction.BToA).sum();
      EXPECT_NEAR(slope, expected, 1e-6 * std::abs(expected));
      const std::array<double, 5> p = energy.Along(maps, direction);
      EXPECT_NEAR(p[1], expected, 1e-9 * std::abs(expected));
      for (const double t : { -1.5, 0.7, 2.0 })
      {
        EXPECT_NEAR(p[0] + t * (p[1] + t * (p[2] + t * (p[3] + t * p[4]))), moved(direction, t),
          1e-9 * moved(direction, t));
      }
    }
  }
}

// The rate of change is the limit of the quotient, so the energies converge, linearly.
TEST(FunctionalMapEnergy, OfADisplacementConvergesToThatOfItsRate)
{
  const DescribedPair pair;
  const shape::FunctionalMaps maps = Random(1);
  const auto value = [&](double displacement)
  {
    shape::FunctionalMapFitOptions options = Options();
    options.DisplacementWeight = 1.0;
    options.Displacement = displacement;
    return shape::FunctionalMapEnergy(pair.A.Surface(), pair.B.Surface(), options).Value(maps);
  };
  const double limit = value(0.0), coarse = std::abs(value(1e-3) - limit),
               fine = std::abs(value(1e-4) - limit);
  EXPECT_GT(coarse, 0.0);
  EXPECT_NEAR(fine / coarse, 0.1, 0.02);
}

// Vectors that are the unit normals give the term of the normals. The rate of a rigid motion, here
// a rotation and a shift, changes no Laplacian: there is no term.
TEST(FunctionalMapEnergy, OfGivenDisplacementsIsThatOfTheNormalsAndVanishesForAMotion)
{
  DescribedPair pair;
  const shape::FunctionalMaps maps = Random(1);
  const auto value = [&](double weight)
  {
    shape::FunctionalMapFitOptions options = Options();
    options.DisplacementWeight = weight;
    return shape::FunctionalMapEnergy(pair.A.Surface(), pair.B.Surface(), options).Value(maps);
  };
  const double along = value(1.0), none = value(0.0);
  for (Described* const side : { &pair.A, &pair.B })
  {
    side->Displacements = shape::ComputeVertexNormals(side->Unit, shape::NormalWeight::Area);
  }
  EXPECT_NEAR(value(1.0), along, 1e-9 * along);
  for (Described* const side : { &pair.A, &pair.B })
  {
    const Eigen::Vector3d axis(0.3, -0.2, 0.5);
    side->Displacements = side->Unit.Points.rowwise().cross(axis).rowwise() + axis.transpose();
  }
  EXPECT_NEAR(value(1.0), none, 1e-9 * none);
}

// The energy has the gradient of its value for given displacements, too, and the term falls as its
// weight grows.
TEST(FunctionalMapEnergy, OfGivenDisplacementsHasItsGradientAndFalls)
{
  DescribedPair pair;
  for (Described* const side : { &pair.A, &pair.B })
  {
    const Eigen::ArrayX3d at = side->Unit.Points.array();
    side->Displacements.resize(at.rows(), 3);
    side->Displacements << at.col(0).square(), at.col(0) * at.col(1), (4.0 * at.col(2)).sin();
  }
  const auto energy = [&](double weight, double factor)
  {
    shape::FunctionalMapFitOptions options = Options();
    options.DisplacementWeight = weight;
    options.Displacement = factor;
    return shape::FunctionalMapEnergy(pair.A.Surface(), pair.B.Surface(), options);
  };
  for (const double factor : { 0.0, 0.5 })
  {
    const shape::FunctionalMapEnergy some = energy(0.5, factor), all = energy(1.0, factor),
                                     none = energy(0.0, factor);
    const shape::FunctionalMaps maps = Random(1), gradient = some.Gradient(maps),
                                direction = Random(2);
    constexpr double step = 1e-4;
    const auto moved = [&](double by) {
      return some.Value({ maps.AToB + by * direction.AToB, maps.BToA + by * direction.BToA });
    };
    const double expected = gradient.AToB.cwiseProduct(direction.AToB).sum() +
      gradient.BToA.cwiseProduct(direction.BToA).sum();
    EXPECT_NEAR((moved(step) - moved(-step)) / (2.0 * step), expected, 1e-6 * std::abs(expected));
    double before = 0.0;
    for (const double weight : { 0.0, 0.03, 0.3, 3.0 })
    {
      const shape::FunctionalMaps best = energy(weight, factor).Start();
      const double term = all.Value(best) - none.Value(best);
      EXPECT_GT(term, 0.0);
      if (weight > 0.0)
      {
        EXPECT_LT(term, 0.999 * before) << weight;
      }
      before = term;
    }
  }
}

double Off(const Eigen::MatrixXd& product)
{
  return (product - Eigen::MatrixXd::Identity(product.rows(), product.cols())).squaredNorm();
}

// A minimum of f + w g has a smaller g for a larger w. g is the difference of two energies.
TEST(FitFunctionalMap, HasSmallerCommutatorsForLargerWeights)
{
  using Options = shape::FunctionalMapFitOptions;
  const DescribedPair pair;
  for (double Options::*const weight : { &Options::LaplacianWeight, &Options::DescriptorWeight,
         &Options::OrientationWeight, &Options::CurveWeight, &Options::DisplacementWeight })
  {
    Options without = ::Options(), with = without;
    without.*weight = 0.0;
    with.*weight = 1.0;
    const shape::FunctionalMapEnergy rest(pair.A.Surface(), pair.B.Surface(), without),
      all(pair.A.Surface(), pair.B.Surface(), with);
    double before = 0.0;
    for (const double value : { 0.0, 0.03, 0.3, 3.0 })
    {
      Options options = without;
      options.*weight = value;
      const shape::FunctionalMaps maps =
        shape::FunctionalMapEnergy(pair.A.Surface(), pair.B.Surface(), options).Start();
      const double term = all.Value(maps) - rest.Value(maps);
      EXPECT_GT(term, 0.0);
      if (value > 0.0)
      {
        EXPECT_LT(term, 0.999 * before) << value;
      }
      before = term;
    }
  }
}

// A minimum of f + w g has a smaller g for a larger w.
TEST(FitFunctionalMaps, TermsFallAsTheirWeightsGrowAndWithoutThemTheFitIsAsItWas)
{
  const DescribedPair pair;
  const auto fitted = [&](double orthonormality, double inverse)
  {
    shape::FunctionalMapFitOptions options = Options();
    options.OrthonormalityWeight = orthonormality;
    options.InverseWeight = inverse;
    return shape::FitFunctionalMaps(pair.A.Surface(), pair.B.Surface(), options);
  };
  const shape::FunctionalMaps none = fitted(0.0, 0.0);
  EXPECT_EQ(none.AToB, shape::FitFunctionalMap(pair.A.Surface(), pair.B.Surface(), Options()));
  EXPECT_EQ(none.BToA, none.AToB.transpose());
  const shape::FunctionalMapEnergy free(pair.A.Surface(), pair.B.Surface(), Options());
  shape::FunctionalMaps before = free.Start();
  EXPECT_LT(free.Value(before), free.Value(none) + 1e-12);
  const auto orthonormality = [](const shape::FunctionalMaps& maps)
  { return Off(maps.AToB.transpose() * maps.AToB) + Off(maps.BToA.transpose() * maps.BToA); };
  const auto inverse = [](const shape::FunctionalMaps& maps)
  { return Off(maps.AToB * maps.BToA) + Off(maps.BToA * maps.AToB); };
  const shape::FunctionalMaps start = before;
  for (const double weight : { 0.01, 0.1, 1.0, 10.0 })
  {
    const shape::FunctionalMaps now = fitted(weight, 0.0);
    EXPECT_LT(orthonormality(now), orthonormality(before)) << weight;
    EXPECT_GT(free.Value(now), free.Value(before)) << weight;
    before = now;
  }
  before = start;
  for (const double weight : { 0.01, 0.1, 1.0, 10.0 })
  {
    const shape::FunctionalMaps now = fitted(0.0, weight);
    EXPECT_LT(inverse(now), inverse(before)) << weight;
    EXPECT_GT(free.Value(now), free.Value(before)) << weight;
    before = now;
  }
  // A large weight leaves nothing of its term.
  EXPECT_LT(orthonormality(fitted(1e3, 0.0)), 1e-3 * orthonormality(start));
  EXPECT_LT(inverse(fitted(0.0, 1e3)), 1e-3 * inverse(start));
  // At the minimum, the gradient vanishes.
  shape::FunctionalMapFitOptions options = Options();
  options.OrthonormalityWeight = options.InverseWeight = 0.1;
  const shape::FunctionalMapEnergy both(pair.A.Surface(), pair.B.Surface(), options);
  const shape::FunctionalMaps end =
    shape::FitFunctionalMaps(pair.A.Surface(), pair.B.Surface(), options);
  const auto norm = [](const shape::FunctionalMaps& maps)
  { return std::hypot(maps.AToB.norm(), maps.BToA.norm()); };
  EXPECT_LT(norm(both.Gradient(end)), 1e-3 * norm(both.Gradient(both.Start())));
}

} // namespace
