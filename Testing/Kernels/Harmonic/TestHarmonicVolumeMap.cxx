#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/Private/ScaledBoundary.h"
#include "Support/HarmonicShapes.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

namespace
{

using Method = shape::HarmonicVolumeMapOptions::MethodType;
using shapetest::DentedSphere;
using Stop = shape::HarmonicVolumeMapResult::Stop;

/// A map that is harmonic inside the bumpy sphere: polynomials and charges outside.
Eigen::MatrixXd Harmonic(const Eigen::MatrixXd& points)
{
  Eigen::MatrixXd values(points.rows(), 3);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const Eigen::RowVector3d p = points.row(i);
    const double x = p(0), y = p(1), z = p(2);
    const auto charge = [&](double a, double b, double c)
    { return 0.3 / (p - Eigen::RowVector3d(a, b, c)).norm(); };
    values.row(i) << x + 0.2 * x * y + charge(2, 1, 0),
      y + 0.1 * (x * x * x - 3.0 * x * y * y) + charge(-1, -2, 1),
      z + 0.2 * (x * x - z * z) + charge(0, 1, 2.2);
  }
  return values;
}

/// Root mean square error at points well inside, divided by the size of the targets.
double InteriorError(const shape::ChargeSet& map, const shape::Mesh& boundary)
{
  Eigen::MatrixXd inside(3 * boundary.Points.rows(), 3);
  inside << 0.9 * boundary.Points, 0.6 * boundary.Points, 0.2 * boundary.Points;
  const Eigen::MatrixXd error = shape::Evaluate(map, inside) - Harmonic(inside);
  return std::sqrt(error.squaredNorm() / error.rows()) /
    shape::ComputeLongestBoxEdge(Harmonic(boundary.Points));
}

shape::HarmonicVolumeMapOptions With(Method method, double collocations, double sources)
{
  shape::HarmonicVolumeMapOptions options;
  options.Method = method;
  options.CollocationRatio = collocations;
  options.SourceRatio = sources;
  options.Tolerance = 0.0;
  options.OffsetDistance = 0.2; // the offset surface is sampled sooner
  return options;
}

} // namespace

TEST(HarmonicVolumeMap, TheInteriorErrorFallsAsSourcesAreAdded)
{
  const shape::Mesh boundary = DentedSphere(4);
  const Eigen::MatrixXd targets = Harmonic(boundary.Points);
  double errors[3];
  const double ratios[3] = { 0.01, 0.03, 0.09 };
  for (int i = 0; i < 3; ++i)
  {
    const auto result = shape::ComputeHarmonicVolumeMap(
      boundary, targets, {}, With(Method::SingleShot, 0.4, ratios[i]));
    errors[i] = InteriorError(result.Map, boundary);
  }
  EXPECT_LT(errors[1], errors[0] / 4.0) << errors[0];
  EXPECT_LT(errors[2], errors[1] / 4.0) << errors[1];
  EXPECT_LT(errors[2], 2.5e-4);
}

TEST(HarmonicVolumeMap, TheInteriorErrorIsOfSecondOrderInTheBoundarysEdges)
{
  // The boundary map is linear over each triangle: that error is of second order and remains.
  double errors[2];
  for (int i = 0; i < 2; ++i)
  {
    const shape::Mesh boundary = DentedSphere(2 + i);
    const auto options = With(Method::SingleShot, i == 0 ? 4.0 : 1.0, i == 0 ? 1.6 : 0.4);
    const auto result =
      shape::ComputeHarmonicVolumeMap(boundary, Harmonic(boundary.Points), {}, options);
    errors[i] = InteriorError(result.Map, boundary);
  }
  EXPECT_GT(errors[0] / errors[1], 3.0) << errors[0] << " " << errors[1];
}

TEST(HarmonicVolumeMap, AffineMapsAreExact)
{
  for (const Method method : { Method::MultiLevel, Method::SingleShot })
  {
    shapetest::ExpectAffineMapIsExact(DentedSphere(3), With(method, 0.2, 0.2));
  }
}

TEST(HarmonicVolumeMap, EachKeptLevelLowersTheResidual)
{
  const shape::Mesh boundary = DentedSphere(3);
  auto options = With(Method::MultiLevel, 0.8, 0.8);
  options.MaximumLevels = 8;
  const auto result =
    shape::ComputeHarmonicVolumeMap(boundary, shapetest::Icosphere(3).Points, {}, options);
  ASSERT_GE(result.Levels.size(), 4u);
  int kept = 0;
  for (std::size_t i = 1; i < result.Levels.size(); ++i)
  {
    const auto& level = result.Levels[i];
    const auto& before = result.Levels[i - 1];
    EXPECT_EQ(level.Number, static_cast<int>(i));
    EXPECT_EQ(level.Kept, level.RMSEInside < before.RMSEInside);
    EXPECT_LE(level.RMSEInside, before.RMSEInside);
    kept += level.Kept;
  }
  EXPECT_GE(kept, 3);
  EXPECT_LT(result.Levels.back().RMSEInside, 0.1 * result.Levels.front().RMSEInside);
  EXPECT_GT(result.InsertedSources, 0);
}

TEST(HarmonicVolumeMap, TheReportedErrorsAreThoseOfTheMap)
{
  const shape::Mesh boundary = DentedSphere(3);
  const Eigen::MatrixXd targets = 5.0 * shapetest::Icosphere(3).Points;
  for (const Method method : { Method::MultiLevel, Method::SingleShot })
  {
    const auto result =
      shape::ComputeHarmonicVolumeMap(boundary, targets, {}, With(method, 0.8, 0.2));
    const double size = shape::ComputeLongestBoxEdge(targets);
    const Eigen::MatrixXd atPoints =
      (shape::Evaluate(result.Map, boundary.Points) - targets) / size;
    const Eigen::MatrixXd inside =
      (shape::Evaluate(result.Map, shape::ComputeOffCentres(boundary)) -
        shape::InterpolateAtOffCentres(boundary, targets)) /
      size;
    const auto& level = result.Levels.back();
    EXPECT_NEAR(level.RMSEVertices, std::sqrt(atPoints.squaredNorm() / atPoints.rows()), 1e-10);
    EXPECT_NEAR(level.RMSEInside, std::sqrt(inside.squaredNorm() / inside.rows()), 1e-10);
    EXPECT_NEAR(level.Maximum,
      std::max(atPoints.rowwise().norm().maxCoeff(), inside.rowwise().norm().maxCoeff()), 1e-10);
  }
}

TEST(HarmonicVolumeMap, TheErrorAtTheCollocationPointsIsThatOfTheMap)
{
  const shape::Mesh boundary = DentedSphere(3);
  const Eigen::MatrixXd targets = 5.0 * shapetest::Icosphere(3).Points;
  const double size = shape::ComputeLongestBoxEdge(targets);
  const auto error = [&](const shape::HarmonicVolumeMapResult& result,
                       const Eigen::MatrixXd& points, const Eigen::MatrixXd& images)
  {
    const Eigen::MatrixXd left = (shape::Evaluate(result.Map, points) - images) / size;
    return std::sqrt(left.squaredNorm() / left.rows());
  };
  // SingleShot: the samples of its ratio. They are fitted, what is between them is not.
  auto options = With(Method::SingleShot, 0.4, 0.4);
  const auto single = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
  const shape::ScaledBoundary scaled = shape::ScaleBoundary(boundary, targets);
  const shape::ClosestPoints samples =
    shape::SurfaceLocator(scaled.Surface)
      .Find(shape::SampleSurface(shape::SplitComponents(scaled.Surface).front(),
        static_cast<int>(std::round(0.4 * boundary.Points.rows())), options.CollocationSampling,
        options.Seed));
  const Eigen::MatrixXd fitted = (scaled.Size * samples.Positions).rowwise() + scaled.Origin;
  const Eigen::MatrixXd wanted =
    (scaled.TargetSize * shape::PullBack(samples, scaled.Surface.Triangles(), scaled.Targets))
      .rowwise() +
    scaled.TargetOrigin;
  const auto& level = single.Levels.back();
  EXPECT_NEAR(level.RMSECollocations, error(single, fitted, wanted), 1e-8);
  EXPECT_LT(level.RMSECollocations, level.RMSEInside);
  // Accelerated, before any refinement: the points and the centroids of the triangles.
  options.Method = Method::Accelerated;
  options.MaximumLevels = 1;
  const auto accelerated = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
  Eigen::MatrixXd points(boundary.Points.rows() + boundary.Triangles.rows(), 3);
  Eigen::MatrixXd images(points.rows(), 3);
  points << boundary.Points, shape::ComputeCentroids(boundary);
  images << targets, shape::ComputeCentroids(shape::Mesh{ targets, boundary.Triangles });
  EXPECT_NEAR(accelerated.Levels.back().RMSECollocations, error(accelerated, points, images), 1e-6);
}

TEST(HarmonicVolumeMap, StopsAtTheTolerance)
{
  const shape::Mesh boundary = DentedSphere(3);
  auto options = With(Method::MultiLevel, 0.8, 0.4);
  options.Tolerance = 5e-3;
  const auto result =
    shape::ComputeHarmonicVolumeMap(boundary, shapetest::Icosphere(3).Points, {}, options);
  EXPECT_EQ(result.Reason, Stop::Tolerance);
  EXPECT_LE(result.Levels.back().RMSEInside, 5e-3);
  EXPECT_GT(result.Levels[result.Levels.size() - 2].RMSEInside, 5e-3);
}

TEST(HarmonicVolumeMap, ALargeThresholdDeletesSources)
{
  const shape::Mesh boundary = DentedSphere(3);
  auto options = With(Method::MultiLevel, 0.8, 0.8);
  options.SingularValueThreshold = 0.1;
  options.MaximumLevels = 6;
  const auto result =
    shape::ComputeHarmonicVolumeMap(boundary, Harmonic(boundary.Points), {}, options);
  EXPECT_GT(result.DeletedSources, 0);
  ASSERT_EQ(result.Levels.size(), 7u);
  // The fifth level takes up the first subset again, with ten new ones for those deleted.
  EXPECT_LT(result.Levels[5].Sources, result.Levels[2].Sources);
}

TEST(HarmonicVolumeMap, ASoftFeatureIsMetBetterTheMoreItWeighs)
{
  const shape::Mesh boundary = DentedSphere(2);
  shape::VolumeFeatures features;
  features.Points = Eigen::RowVector3d(0.1, 0.2, -0.1);
  features.Targets = Eigen::RowVector3d(0.3, 0.2, -0.1);
  const auto error = [&](double weight)
  {
    auto options = With(Method::SingleShot, 0.6, 0.3);
    options.FeatureWeight = weight;
    return shape::ComputeHarmonicVolumeMap(boundary, boundary.Points, features, options)
      .RMSEFeatures;
  };
  const double light = error(1.0), heavy = error(20.0), rigid = error(2000.0);
  EXPECT_LT(heavy, 0.9 * light);
  EXPECT_LT(rigid, 0.2 * light);
}

TEST(HarmonicVolumeMap, AWeightCountsAsSoManyRows)
{
  const shape::Mesh boundary = DentedSphere(2);
  shape::VolumeFeatures once, thrice;
  once.Points = Eigen::RowVector3d(0.1, 0.2, -0.1);
  once.Targets = Eigen::RowVector3d(0.2, 0.2, -0.1);
  once.Weights = Eigen::VectorXd::Constant(1, 3.0);
  thrice.Points = once.Points.replicate(3, 1);
  thrice.Targets = once.Targets.replicate(3, 1);
  thrice.Weights = Eigen::VectorXd::Ones(3);
  const auto options = With(Method::SingleShot, 2.0, 0.5);
  const Eigen::MatrixXd targets = shapetest::Icosphere(2).Points;
  const auto a = shape::ComputeHarmonicVolumeMap(boundary, targets, once, options);
  const auto b = shape::ComputeHarmonicVolumeMap(boundary, targets, thrice, options);
  EXPECT_LT((shape::Evaluate(a.Map, boundary.Points) - shape::Evaluate(b.Map, boundary.Points))
              .cwiseAbs()
              .maxCoeff(),
    1e-9);
}

TEST(HarmonicVolumeMap, AnInwardFacingBoundaryAndUnusedPointsChangeNothing)
{
  const shape::Mesh boundary = DentedSphere(2);
  const Eigen::MatrixXd targets = shapetest::Icosphere(2).Points;
  const auto options = With(Method::MultiLevel, 2.0, 1.0);
  const auto expected = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
  shape::Mesh inward = boundary;
  inward.Triangles.col(1).swap(inward.Triangles.col(2));
  inward.Points.conservativeResize(boundary.Points.rows() + 1, 3);
  inward.Points.bottomRows(1).setConstant(50.0);
  Eigen::MatrixXd more = targets;
  more.conservativeResize(targets.rows() + 1, 3);
  more.bottomRows(1).setConstant(50.0);
  const auto result = shape::ComputeHarmonicVolumeMap(inward, more, {}, options);
  EXPECT_EQ(result.Map.Points, expected.Map.Points);
  EXPECT_EQ(result.Map.Charges, expected.Map.Charges);
}

TEST(HarmonicVolumeMap, RepeatsItselfForAnyNumberOfThreads)
{
  const shape::Mesh boundary = DentedSphere(3);
  const Eigen::MatrixXd targets = shapetest::Icosphere(3).Points;
  for (const auto mode : { shape::SamplingMode::Uniform, shape::SamplingMode::GeometryAdaptive,
         shape::SamplingMode::Quadric })
  {
    auto options = With(Method::MultiLevel, 0.8, 0.4);
    options.CollocationSampling = options.SourceSampling = mode;
    const auto first = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
    const auto second = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
    EXPECT_EQ(first.Map.Points, second.Map.Points);
    EXPECT_EQ(first.Map.Charges, second.Map.Charges);
    setenv("VTK_SMP_MAX_THREADS", "1", 1);
    const auto one = shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options);
    unsetenv("VTK_SMP_MAX_THREADS");
    EXPECT_LT(
      (shape::Evaluate(first.Map, boundary.Points) - shape::Evaluate(one.Map, boundary.Points))
        .cwiseAbs()
        .maxCoeff(),
      1e-9);
  }
}

TEST(HarmonicVolumeMap, RefusesWithTheFactAndTheRemedy)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const auto map = [](const shape::Mesh& boundary, const Eigen::MatrixXd& targets,
                     const shape::VolumeFeatures& features = {},
                     const shape::HarmonicVolumeMapOptions& options = {})
  { return shape::ComputeHarmonicVolumeMap(boundary, targets, features, options); };

  const shape::Mesh open = shapetest::WithoutLast(sphere);
  EXPECT_REFUSED(map(open, sphere.Points), "1 open loop");

  shape::Mesh two = shapetest::Twice(sphere, { 3, 0, 0 });
  EXPECT_REFUSED(map(two, two.Points), "2 solids");
  two.Points.bottomRows(162).rowwise() -= Eigen::RowVector3d(2, 0, 0);
  EXPECT_REFUSED(map(two, two.Points), "touch or cross");

  EXPECT_REFUSED(map(sphere, sphere.Points.topRows(7)), "7 rows");
  Eigen::MatrixXd broken = sphere.Points;
  broken(11, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(map(sphere, broken), "first at point 11");

  shape::VolumeFeatures features;
  features.Points.resize(2, 3);
  features.Points << 0, 0, 0, 3, 0, 0;
  features.Targets = features.Points;
  EXPECT_REFUSED(map(sphere, sphere.Points, features), "first at feature point 1");
  features.Points(1, 0) = 0.5;
  // What lies in a void lies outside the solid.
  two.Points.bottomRows(162) = (0.3 * sphere.Points).rowwise() + Eigen::RowVector3d(0.5, 0.0, 0.0);
  EXPECT_REFUSED(map(two, two.Points, features), "first at feature point 1");
  features.Weights = Eigen::Vector2d(1.0, -1.0);
  EXPECT_REFUSED(map(sphere, sphere.Points, features), "first at feature point 1");

  using Options = shape::HarmonicVolumeMapOptions;
  shapetest::ExpectRefused<Options>(
    [&](const Options& options) { map(sphere, sphere.Points, {}, options); }, {},
    { { &Options::OffsetDistance, -0.1, { "OffsetDistance" } },
      { &Options::SourceRatio, -1.0, { "SourceRatio" } } });
  EXPECT_REFUSED(map(sphere, Harmonic(sphere.Points), {}, With(Method::SingleShot, 200.0, 200.0)),
    "32400 x 32400", "GiB");
}

TEST(HarmonicVolumeMap, StopsWhereverItIsToldTo)
{
  const shape::Mesh boundary = DentedSphere(2);
  const Eigen::MatrixXd targets = shapetest::Icosphere(2).Points;
  const auto options = With(Method::MultiLevel, 1.0, 0.5);
  int calls = 0;
  double last = 0.0;
  bool rising = true;
  shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options,
    shape::Progress(
      [&](double fraction)
      {
        rising = rising && fraction >= last && fraction <= 1.0;
        last = fraction;
        ++calls;
        return true;
      }));
  EXPECT_TRUE(rising);
  EXPECT_EQ(last, 1.0);
  for (const int limit : { 1, calls / 4, calls / 2, calls - 2 })
  {
    int left = limit;
    EXPECT_THROW(shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options,
                   shape::Progress([&](double) { return --left > 0; })),
      shape::Aborted);
  }
}

TEST(HarmonicVolumeMap, TheAutomaticOffsetFollowsTheSpacingOfTheCollocationPoints)
{
  const shape::Mesh boundary = DentedSphere(3);
  const Eigen::MatrixXd targets = Harmonic(boundary.Points);
  shape::HarmonicVolumeMapOptions options;
  options.Method = Method::MultiLevel;
  options.MaximumLevels = 1;
  options.CollocationRatio = 0.8;
  const double coarse =
    shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options).OffsetDistance;
  options.CollocationRatio = 3.2;
  const double fine =
    shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options).OffsetDistance;
  EXPECT_NEAR(coarse / fine, 2.0, 1e-9);
  // What is asked for is the farthest; the last of MultiLevel's 4 subsets is sqrt(4) times nearer.
  options.OffsetDistance = 0.11;
  options.SourceSubsets = 4;
  EXPECT_NEAR(
    shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options).OffsetDistance, 0.055, 1e-15);
  options.Method = Method::SingleShot;
  options.CollocationRatio = 0.8;
  EXPECT_EQ(shape::ComputeHarmonicVolumeMap(boundary, targets, {}, options).OffsetDistance, 0.11);
}

TEST(HarmonicVolumeMap, EachChargeSitsAtAPlaceOfItsOwn)
{
  // Several levels use the same sources: their charges are added up.
  const shape::Mesh boundary = DentedSphere(3);
  shape::HarmonicVolumeMapOptions options = With(Method::MultiLevel, 0.4, 0.4);
  options.SourceSubsets = 2;
  options.MaximumLevels = 6;
  const shape::HarmonicVolumeMapResult result =
    shape::ComputeHarmonicVolumeMap(boundary, Harmonic(boundary.Points), {}, options);
  int solved = 0;
  for (const auto& level : result.Levels)
  {
    solved += level.Sources;
  }
  EXPECT_LT(result.Map.Points.rows(), 0.6 * solved);
  for (Eigen::Index i = 1; i < result.Map.Points.rows(); ++i)
  {
    EXPECT_GT((result.Map.Points.topRows(i).rowwise() - result.Map.Points.row(i))
                .rowwise()
                .squaredNorm()
                .minCoeff(),
      0.0);
  }
}

TEST(HarmonicVolumeMap, DoesNotDependOnHowTheBoundaryIsNumbered)
{
  const shape::Mesh boundary = DentedSphere(3);
  const int n = static_cast<int>(boundary.Points.rows());
  // 5 and the number of points, 642, have no common factor: every point gets a number.
  Eigen::VectorXi newId(n);
  shape::Mesh renumbered = boundary;
  for (int i = 0; i < n; ++i)
  {
    newId(i) = 5 * i % n;
    renumbered.Points.row(newId(i)) = boundary.Points.row(i);
  }
  renumbered.Triangles =
    boundary.Triangles.colwise().reverse().unaryExpr([&](int i) { return newId(i); });
  const shape::HarmonicVolumeMapOptions options = With(Method::MultiLevel, 0.4, 0.4);
  const auto image = [&](const shape::Mesh& mesh)
  {
    const shape::HarmonicVolumeMapResult result =
      shape::ComputeHarmonicVolumeMap(mesh, Harmonic(mesh.Points), {}, options);
    return shape::Evaluate(result.Map, 0.7 * boundary.Points);
  };
  EXPECT_EQ(image(boundary), image(renumbered));
}
