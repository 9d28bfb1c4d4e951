#include "Base/Errors.h"
#include "Correspondence/Transport/GromovWasserstein.h"
#include "Correspondence/Transport/Private/Sinkhorn.h"
#include "Support/MatchingShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"

#include <Eigen/Core>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <vector>

namespace
{

/// Positions in space that no motion takes onto each other, and the same in another order: place i
/// is place 7 i + 3 (mod 40) there.
shape::MetricSpaces Shuffled(int& stride, int& offset)
{
  constexpr int count = 40;
  stride = 7;
  offset = 3;
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  const Eigen::MatrixXd positions = Eigen::MatrixXd::NullaryExpr(
    count, 3, [&](Eigen::Index, Eigen::Index) { return uniform(random); });
  shape::MetricSpaces spaces;
  spaces.DistancesA.resize(count, count);
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      spaces.DistancesA(i, j) = (positions.row(i) - positions.row(j)).norm();
    }
  }
  spaces.DistancesA /= spaces.DistancesA.maxCoeff();
  Eigen::VectorXd weights =
    Eigen::VectorXd::NullaryExpr(count, [&](Eigen::Index) { return 0.5 + uniform(random); });
  spaces.WeightsA = weights / weights.sum();
  Eigen::VectorXi order(count);
  for (int i = 0; i < count; ++i)
  {
    order((stride * i + offset) % count) = i;
  }
  spaces.DistancesB = spaces.DistancesA(order, order);
  spaces.WeightsB = spaces.WeightsA(order);
  return spaces;
}

} // namespace

TEST(GromovWasserstein, SinkhornFitsRowsAndColumns)
{
  // Likenesses whose exponentials no number holds, and places that may not go to each other.
  Eigen::MatrixXd likeness = 3000.0 * Eigen::MatrixXd::Random(30, 20);
  likeness(3, 4) = -std::numeric_limits<double>::infinity();
  const Eigen::VectorXd rows = Eigen::VectorXd::Constant(30, 1.0 / 30.0);
  const Eigen::VectorXd columns = Eigen::VectorXd::LinSpaced(20, 1.0, 3.0) / 40.0;
  const Eigen::MatrixXd far = shape::Sinkhorn(rows, columns).Masses(likeness, 500, 1e-9);
  EXPECT_TRUE(far.allFinite());
  EXPECT_GE(far.minCoeff(), 0.0);
  EXPECT_LT(far(3, 4), 1e-300);
  EXPECT_LT((far.colwise().sum().transpose() - columns).cwiseAbs().maxCoeff(), 1e-12);
  shape::Sinkhorn scaling(rows, columns);
  const Eigen::MatrixXd near = scaling.Masses(1e-3 * likeness, 5000, 1e-9);
  EXPECT_LT((near.colwise().sum().transpose() - columns).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((near.rowwise().sum() - rows).cwiseAbs().sum(), 1e-8);
  // What is left is a function of the row plus one of the column.
  const Eigen::MatrixXd rest = near.array().log().matrix() - 1e-3 * likeness;
  EXPECT_NEAR(rest(5, 6) - rest(5, 7), rest(8, 6) - rest(8, 7), 1e-9);
}

TEST(GromovWasserstein, SinkhornBeginsWhereItEnded)
{
  const Eigen::MatrixXd likeness = 20.0 * Eigen::MatrixXd::Random(30, 30);
  const Eigen::VectorXd weights = Eigen::VectorXd::LinSpaced(30, 1.0, 3.0) / 60.0;
  shape::Sinkhorn scaling(weights, weights.reverse());
  const Eigen::MatrixXd masses = scaling.Masses(likeness, 10000, 1e-10);
  EXPECT_LT(scaling.Error(), 1e-9);
  EXPECT_LT((scaling.Masses(likeness, 0, 1e-10) - masses).cwiseAbs().maxCoeff(), 1e-9);
  // Of twice the likeness twice the potentials are no solution, but nearer to it than none.
  scaling.Scale(2.0);
  scaling.Masses(2.0 * likeness, 3, 0.0);
  const double warm = scaling.Error();
  shape::Sinkhorn cold(weights, weights.reverse());
  cold.Masses(2.0 * likeness, 3, 0.0);
  EXPECT_LT(warm, 0.5 * cold.Error());
}

TEST(GromovWasserstein, CouplingIsTheShuffleAndItsObjectiveFalls)
{
  int stride = 0, offset = 0;
  const shape::MetricSpaces spaces = Shuffled(stride, offset);
  const Eigen::Index count = spaces.WeightsA.size();
  // Some pairs are known, and how far the others are from these is a start.
  shape::Landmarks fixed;
  for (const int i : { 0, 5, 11, 17, 30 })
  {
    fixed.push_back({ i, static_cast<int>((stride * i + offset) % count) });
  }
  Eigen::MatrixXd start = Eigen::MatrixXd::Zero(count, count);
  for (const auto& [i, j] : fixed)
  {
    for (Eigen::Index k = 0; k < count; ++k)
    {
      const Eigen::VectorXd difference = spaces.DistancesB.col(j).array() - spaces.DistancesA(i, k);
      start.row(k) -= 200.0 * difference.cwiseAbs2().transpose();
    }
  }
  shape::EntropicCouplingOptions options;
  options.FirstEntropy = 1e-3;
  options.Entropy = 1e-4;
  options.IterationsPerEntropy = 30;
  options.SinkhornIterations = 10000;
  const auto found = shape::SolveCoupling(spaces, start, fixed, options);
  for (int i = 0; i < static_cast<int>(count); ++i)
  {
    Eigen::Index to = 0;
    const double maximum = found.Masses.row(i).maxCoeff(&to);
    EXPECT_EQ(to, (stride * i + offset) % count);
    EXPECT_GT(maximum, 0.9 * spaces.WeightsA(i));
  }
  EXPECT_LT((found.Masses.rowwise().sum() - spaces.WeightsA).cwiseAbs().sum(), 1e-3);
  EXPECT_NEAR((found.Masses.rowwise().sum() - spaces.WeightsA).cwiseAbs().sum(), found.Error, 1e-9);
  EXPECT_LT(found.Distortion, 0.02); // of what goes astray
  EXPECT_LT(
    (found.Masses.colwise().sum().transpose() - spaces.WeightsB).cwiseAbs().maxCoeff(), 1e-9);
  ASSERT_EQ(found.Objectives.size(), found.Entropies.size());
  for (std::size_t k = 1; k < found.Objectives.size(); ++k)
  {
    EXPECT_LE(found.Entropies[k], found.Entropies[k - 1]);
    // Straight distances are of negative type.
    EXPECT_LE(found.Objectives[k], found.Objectives[k - 1] + 1e-6);
  }
}

TEST(GromovWasserstein, MuchEntropySpreadsMassesEvenly)
{
  int stride = 0, offset = 0;
  const shape::MetricSpaces spaces = Shuffled(stride, offset);
  const Eigen::Index count = spaces.WeightsA.size();
  shape::EntropicCouplingOptions options;
  options.FirstEntropy = options.Entropy = 1e3;
  const auto found =
    shape::SolveCoupling(spaces, Eigen::MatrixXd::Random(count, count), {}, options);
  const Eigen::MatrixXd even = spaces.WeightsA * spaces.WeightsB.transpose();
  EXPECT_LT((found.Masses - even).cwiseAbs().maxCoeff(), 1e-3 * even.maxCoeff());
}

TEST(GromovWasserstein, FeaturesAloneGiveTheBestAssignment)
{
  // As many features as samples, shuffled and changed: the best of all assignments is not obvious.
  constexpr int count = 7;
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  shape::MetricSpaces spaces;
  const auto draw = [&](Eigen::Index rows, Eigen::Index columns)
  {
    return Eigen::MatrixXd(Eigen::MatrixXd::NullaryExpr(
      rows, columns, [&](Eigen::Index, Eigen::Index) { return uniform(random); }));
  };
  const Eigen::MatrixXd a = draw(count, 2), b = draw(count, 2);
  spaces.WeightsA = spaces.WeightsB = Eigen::VectorXd::Constant(count, 1.0 / count);
  // Distances that say nothing about the features.
  const Eigen::MatrixXd one = draw(count, count), two = draw(count, count);
  spaces.DistancesA = 0.5 * (one + one.transpose());
  spaces.DistancesB = 0.5 * (two + two.transpose());
  spaces.Costs.resize(count, count);
  for (int i = 0; i < count; ++i)
  {
    for (int j = 0; j < count; ++j)
    {
      spaces.Costs(i, j) = (a.row(i) - b.row(j)).squaredNorm();
    }
  }
  spaces.CostWeight = 1.0;
  std::vector<int> order(count), best;
  std::iota(order.begin(), order.end(), 0);
  double least = std::numeric_limits<double>::infinity();
  do
  {
    double cost = 0.0;
    for (int i = 0; i < count; ++i)
    {
      cost += spaces.Costs(i, order[i]) / count;
    }
    if (cost < least)
    {
      least = cost;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  shape::EntropicCouplingOptions options;
  options.SinkhornIterations = 2000;
  options.Tolerance = 1e-9;
  const auto found =
    shape::SolveCoupling(spaces, Eigen::MatrixXd::Random(count, count), {}, options);
  // Of what is minimised, entropy is at most e log(count), and a quarter of the cost is counted.
  EXPECT_GE(found.Cost, least - 1e-8);
  EXPECT_LE(found.Cost, least + 4.0 * options.Entropy * std::log(count) + 1e-8);
  for (int i = 0; i < count; ++i)
  {
    Eigen::Index to = 0;
    found.Masses.row(i).maxCoeff(&to);
    EXPECT_EQ(to, best[i]);
  }
  // With the other weight, costs have no effect.
  spaces.CostWeight = 0.0;
  const Eigen::MatrixXd start = Eigen::MatrixXd::Random(count, count);
  const Eigen::MatrixXd masses = shape::SolveCoupling(spaces, start, {}, options).Masses;
  spaces.Costs.resize(0, 0);
  EXPECT_EQ(masses, shape::SolveCoupling(spaces, start, {}, options).Masses);
  spaces.CostWeight = 1.5;
  EXPECT_REFUSED(shape::SolveCoupling(spaces, start, {}, options), "FeatureWeight");
}

TEST(GromovWasserstein, FeaturesTellSidesApartThatDistancesDoNot)
{
  // A plate is like its mirror image, but a feature is on one side of it only.
  const shape::Mesh plate = shapetest::FlatSquare(12, 0.0);
  shape::GromovWassersteinOptions options;
  options.Samples = 100;
  const auto corner = [&](double x, double y)
  {
    Eigen::Index found = 0;
    (plate.Points.rowwise() - Eigen::RowVector3d(x, y, 0.0)).rowwise().norm().minCoeff(&found);
    return static_cast<int>(found);
  };
  // The start turns the plate by a half.
  options.Starts = { { { corner(-1, -1), corner(1, 1) }, { corner(1, -1), corner(-1, 1) },
    { corner(1, 1), corner(-1, -1) } } };
  const auto right = [&]
  {
    const auto maps = shape::ComputeGromovWassersteinMap(plate, plate, {}, options).Maps;
    return shapetest::MapErrors(maps.AToB, plate, plate.Points).mean();
  };
  EXPECT_GT(right(), 0.3);
  options.Features.OfA = options.Features.OfB = plate.Points.leftCols(2);
  options.Features.FeatureWeight = 0.8;
  EXPECT_LT(right(), 0.1);
  options.Features.OfB = plate.Points.leftCols(1);
  EXPECT_REFUSED(right(), "components");
}

TEST(GromovWasserstein, FindsTheSameSurfaceInOtherTriangles)
{
  const shape::Mesh a = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  shape::Mesh b = shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3, -1, 1 }));
  const Eigen::Matrix3d turn = shapetest::Rotation(2.0, { 1, 2, 3 });
  const Eigen::MatrixXd onA = b.Points;
  b.Points = 3.0 * b.Points * turn.transpose();
  const Eigen::MatrixXd onB = 3.0 * a.Points * turn.transpose();
  // Two of the tips, and none.
  Eigen::Index tip = 0, tipB = 0, other = 0, otherB = 0;
  a.Points.col(0).maxCoeff(&tip);
  onA.col(0).maxCoeff(&tipB);
  a.Points.col(1).maxCoeff(&other);
  onA.col(1).maxCoeff(&otherB);
  shape::GromovWassersteinOptions options;
  options.Samples = 300;
  for (const shape::Landmarks& landmarks :
    { shape::Landmarks{ { int(tip), int(tipB) }, { int(other), int(otherB) } },
      shape::Landmarks{} })
  {
    const shape::SurfaceMaps maps =
      shape::ComputeGromovWassersteinMap(a, b, landmarks, options).Maps;
    EXPECT_LT(shapetest::MapErrors(maps.AToB, b, onB).mean(), 0.03); // entropy blurs
    EXPECT_LT(shapetest::MapErrors(maps.BToA, a, onA).mean(), 0.03);
  }
}

TEST(GromovWasserstein, OfSeveralStartsTheOneThatKeepsDistancesIsTaken)
{
  const shape::Mesh mesh = shapetest::BumpySphere(4, Eigen::Matrix3d::Identity());
  const shapetest::Renumbered copy = shapetest::Renumber(mesh, 5);
  const auto image = [&](int point) { return copy.NewOf(point); };
  shape::GromovWassersteinOptions options;
  options.Samples = 200;
  const shape::Landmarks right{ { 0, image(0) }, { 700, image(700) }, { 1500, image(1500) } },
    wrong{ { 0, image(1500) }, { 700, image(0) }, { 1500, image(700) } };
  for (const auto& starts : { std::vector{ right, wrong }, std::vector{ wrong, right } })
  {
    options.Starts = starts;
    const auto found = shape::ComputeGromovWassersteinMap(mesh, copy.Mesh, {}, options);
    EXPECT_EQ(found.Start, right);
    EXPECT_LT(found.Distortion, 0.04); // the samples differ
    EXPECT_LT(found.Error, 0.01);
  }
  options.Starts = { wrong };
  EXPECT_GT(shape::ComputeGromovWassersteinMap(mesh, copy.Mesh, {}, options).Distortion, 0.06);
}

TEST(GromovWasserstein, WorksWithBordersAndHandles)
{
  const shape::Mesh plate = shapetest::FlatSquare(20, 0.2);
  const shapetest::Renumbered copy = shapetest::Renumber(plate, 2);
  shape::Landmarks landmarks;
  for (const int corner : { 0, 20, 420 })
  {
    landmarks.push_back({ corner, copy.NewOf(corner) });
  }
  shape::GromovWassersteinOptions options;
  options.Samples = 300;
  const shape::SurfaceMaps maps =
    shape::ComputeGromovWassersteinMap(plate, copy.Mesh, landmarks, options).Maps;
  EXPECT_LT(shapetest::MapErrors(maps.AToB, copy.Mesh, plate.Points).mean(), 0.1);
  const shape::Mesh torus = shapetest::Torus(2.0, 0.7, 40, 20);
  const shape::SurfaceMaps round = shape::ComputeGromovWassersteinMap(
    torus, torus, { { 0, 0 }, { 105, 105 }, { 450, 450 } }, options)
                                     .Maps;
  EXPECT_LT(shapetest::MapErrors(round.AToB, torus, torus.Points).mean(), 0.11);
}

TEST(GromovWasserstein, NamesWhatIsWrong)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const shape::Mesh both = shapetest::Twice(sphere);
  EXPECT_REFUSED(shape::ComputeGromovWassersteinMap(sphere, both, {}), "surface B");
  EXPECT_REFUSED(shape::ComputeGromovWassersteinMap(sphere, sphere, { { 0, 999 } }), "999");
  shape::GromovWassersteinOptions options;
  options.Samples = 5;
  EXPECT_THROW(
    shape::ComputeGromovWassersteinMap(sphere, sphere, {}, options), shape::InvalidInput);
  options = {};
  options.Coupling.Entropy = 0.0;
  EXPECT_THROW(
    shape::ComputeGromovWassersteinMap(sphere, sphere, {}, options), shape::InvalidInput);
  // Fewer points than samples, and a landmark twice.
  const shape::SurfaceMaps maps = shape::ComputeGromovWassersteinMap(sphere, sphere,
    { { 0, 0 }, { 0, 5 }, { 40, 40 },
      { 100, 100 } }).Maps;
  EXPECT_TRUE(maps.AToB.Barycentrics.allFinite());
}
