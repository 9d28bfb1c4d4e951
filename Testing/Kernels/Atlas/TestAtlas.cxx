#include "Atlas/Atlas.h"
#include "Base/Errors.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

namespace
{

/// Ellipsoids whose half axes are axes + factors * changes, each turned and moved at random.
std::vector<Eigen::MatrixXd> Ellipsoids(const shape::Mesh& sphere, const Eigen::RowVector3d& axes,
  const Eigen::MatrixXd& factors, const Eigen::MatrixXd& changes, double noise, unsigned int seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Eigen::MatrixXd> shapes;
  for (Eigen::Index i = 0; i < factors.rows(); ++i)
  {
    const Eigen::RowVector3d own = axes + factors.row(i) * changes;
    Eigen::MatrixXd points = sphere.Points * own.asDiagonal();
    points = points.unaryExpr([&](double x) { return x + noise * normal(random); }).eval();
    const Eigen::Quaterniond turn =
      Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
        .normalized();
    points *= turn.toRotationMatrix();
    shapes.push_back(
      points.rowwise() + Eigen::RowVector3d(normal(random), normal(random), normal(random)));
  }
  return shapes;
}

/// 0 or 1 at random, as numbers of mean 0 and variance 1, independent of each other: a Hadamard
/// matrix without its first column.
Eigen::MatrixXd Independent(int columns)
{
  Eigen::MatrixXd hadamard = Eigen::MatrixXd::Ones(1, 1);
  while (hadamard.rows() < 16)
  {
    const Eigen::Index size = hadamard.rows();
    Eigen::MatrixXd twice(2 * size, 2 * size);
    twice << hadamard, hadamard, hadamard, -hadamard;
    hadamard = twice;
  }
  return hadamard.middleCols(1, columns) * std::sqrt(15.0 / 16.0);
}

double RootMean(const Eigen::MatrixXd& rows, const Eigen::VectorXd& weights)
{
  return std::sqrt(weights.dot(rows.rowwise().squaredNorm()) / weights.sum());
}

/// The greatest distance of the distribution of `values` from the uniform one on (0, 1].
double DistanceFromUniform(std::vector<double> values)
{
  std::sort(values.begin(), values.end());
  double distance = 0.0;
  const auto count = static_cast<double>(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    distance = std::max({ distance, std::abs(values[i] - static_cast<double>(i) / count),
      std::abs(values[i] - static_cast<double>(i + 1) / count) });
  }
  return distance;
}

const Eigen::Matrix<double, 2, 3> Changes =
  (Eigen::Matrix<double, 2, 3>() << 0.3, 0.0, -0.05, 0.0, 0.12, 0.0).finished();

} // namespace

// The sample covariance of the coefficients is the identity, so that the modes are known exactly:
// the displacements of the half axes, if these are orthogonal.
TEST(Atlas, FindsMeanAndModesOfEllipsoids)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::RowVector3d axes(3.0, 2.0, 1.2);
  const std::vector<Eigen::MatrixXd> shapes =
    Ellipsoids(sphere, axes, Independent(2), Changes, 0.0, 4);
  const shape::AtlasResult atlas = shape::BuildAtlas(shapes, sphere.Triangles);
  EXPECT_EQ(atlas.NumberOfModes, 2);
  const Eigen::MatrixXd mean = sphere.Points * axes.asDiagonal();
  const Eigen::VectorXd weights = shape::ComputePointAreas({ mean, sphere.Triangles });
  // The atlas has the orientation of the first shape.
  const Eigen::Matrix3d product = mean.transpose() * atlas.Mean;
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(product, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Eigen::Matrix3d turn = svd.matrixU() * svd.matrixV().transpose();
  EXPECT_LT(
    RootMean(atlas.Mean * turn.transpose() - mean, weights), 0.01 * RootMean(mean, weights));
  for (int k = 0; k < 2; ++k)
  {
    const Eigen::MatrixXd truth = sphere.Points * Changes.row(k).asDiagonal();
    Eigen::MatrixXd mode = atlas.Modes.middleCols(3 * k, 3) * turn.transpose();
    mode *= mode.cwiseProduct(truth).sum() < 0.0 ? -1.0 : 1.0;
    EXPECT_LT(RootMean(mode - truth, weights), 0.01 * RootMean(truth, weights)) << k;
  }
}

TEST(Atlas, QuantitiesThatFollowTheShapesAreMadeByTheModes)
{
  // A thickness that depends on the half axes, and a density that does not.
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Eigen::MatrixXd factors = Independent(3);
  const std::vector<Eigen::MatrixXd> shapes =
    Ellipsoids(sphere, { 3.0, 2.0, 1.2 }, factors.leftCols(2), Changes, 0.0, 7);
  const shape::AtlasResult atlas = shape::BuildAtlas(shapes, sphere.Triangles);
  ASSERT_EQ(atlas.NumberOfModes, 2);
  const Eigen::VectorXd along = sphere.Points.col(0);
  const Eigen::MatrixXd thickness =
    (along * factors.col(0).transpose() +
      Eigen::VectorXd::Ones(along.size()) * factors.col(1).transpose())
      .array() +
    5.0;
  const shape::AtlasField field = shape::BuildAtlasField(atlas, thickness);
  EXPECT_LT((field.Mean.array() - 5.0).abs().maxCoeff(), 1e-12);
  // The modes are not exactly the half axes, because shapes are rotated to the mean.
  const Eigen::MatrixXd made =
    (field.Modes * atlas.Scores.leftCols(2).transpose()).colwise() + field.Mean;
  EXPECT_LT((made - thickness).cwiseAbs().maxCoeff(), 0.02);
  EXPECT_LT(
    (field.Deviations - (along.array().square() + 1.0).sqrt().matrix()).cwiseAbs().maxCoeff(),
    1e-12);
  const Eigen::MatrixXd density = Eigen::VectorXd::Ones(along.size()) * factors.col(2).transpose();
  const shape::AtlasField other = shape::BuildAtlasField(atlas, density);
  EXPECT_LT(other.Modes.cwiseAbs().maxCoeff(), 0.02);
  EXPECT_THROW(shape::BuildAtlasField(atlas, density.leftCols(3)), shape::InvalidInput);
}

TEST(Atlas, ScoresTimesModesAreTheShapes)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const std::vector<Eigen::MatrixXd> shapes =
    Ellipsoids(sphere, { 2.0, 1.5, 1.0 }, Independent(2), Changes, 0.02, 5);
  for (const bool scale : { false, true })
  {
    shape::AtlasOptions options;
    options.Scale = scale;
    options.NumberOfModes = 15;
    const shape::AtlasResult atlas = shape::BuildAtlas(shapes, sphere.Triangles, {}, options);
    ASSERT_EQ(atlas.NumberOfModes, 15);
    for (int i = 0; i < 16; ++i)
    {
      Eigen::MatrixXd made = atlas.Mean;
      for (int k = 0; k < 15; ++k)
      {
        made += atlas.Scores(i, k) * atlas.Modes.middleCols(3 * k, 3);
      }
      EXPECT_LT((made - atlas.Aligned[i]).cwiseAbs().maxCoeff(), 1e-9);
      // Aligned shapes are the given ones, moved: distances are those times the scale.
      const double given = (shapes[i].row(0) - shapes[i].row(7)).norm(),
                   now = (made.row(0) - made.row(7)).norm();
      EXPECT_NEAR(now, given * atlas.Scales(i), 1e-9);
    }
    EXPECT_LT((atlas.Scores.transpose() * atlas.Scores / 15.0 - Eigen::MatrixXd::Identity(15, 15))
                .cwiseAbs()
                .maxCoeff(),
      1e-8);
    EXPECT_NEAR(atlas.Explained(14), 1.0, 1e-12);
    EXPECT_NEAR(atlas.Distances.squaredNorm() / 15.0, atlas.Variances.sum(), 1e-9);
  }
}

// Noise of the points adds variance in every mode, but only the true ones predict.
TEST(Atlas, NumberOfModesIsThatOfTheFamily)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  std::mt19937 random(77);
  std::normal_distribution<double> normal;
  for (int modes = 1; modes <= 3; ++modes)
  {
    for (const double noise : { 0.005, 0.02 })
    {
      const Eigen::MatrixXd factors =
        Eigen::MatrixXd::NullaryExpr(40, modes, [&] { return normal(random); });
      Eigen::Matrix3d changes;
      changes << 0.3, 0.0, 0.0, 0.0, 0.2, 0.0, 0.0, 0.0, 0.1;
      const shape::AtlasResult atlas =
        shape::BuildAtlas(Ellipsoids(sphere, { 3.0, 2.2, 1.4 }, factors, changes.topRows(modes),
                            noise, static_cast<unsigned int>(100 + modes)),
          sphere.Triangles);
      EXPECT_EQ(atlas.NumberOfModes, modes) << noise;
    }
  }
}

// Left out, a shape is reconstructed by an independent model of the others.
TEST(Atlas, GeneralisationIsThatOfModelsWithoutTheShape)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  std::vector<Eigen::MatrixXd> shapes =
    Ellipsoids(sphere, { 2.0, 1.5, 1.0 }, Independent(2), Changes, 0.05, 6);
  const shape::AtlasResult atlas = shape::BuildAtlas(shapes, sphere.Triangles);
  Eigen::VectorXd weights = Eigen::VectorXd::Zero(sphere.Points.rows());
  for (const Eigen::MatrixXd& each : shapes)
  {
    const Eigen::VectorXd areas = shape::ComputePointAreas({ each, sphere.Triangles });
    weights += areas / areas.sum() / 16.0;
  }
  const Eigen::VectorXd roots = weights.cwiseSqrt().replicate(3, 1);
  Eigen::MatrixXd rows(16, roots.size());
  for (int i = 0; i < 16; ++i)
  {
    rows.row(i) = atlas.Aligned[i].reshaped().cwiseProduct(roots).transpose();
  }
  for (const int modes : { 1, 2, 5 })
  {
    double sum = 0.0;
    for (int left = 0; left < 16; ++left)
    {
      Eigen::MatrixXd others(15, rows.cols());
      others << rows.topRows(left), rows.bottomRows(15 - left);
      const Eigen::RowVectorXd mean = others.colwise().mean();
      const Eigen::BDCSVD<Eigen::MatrixXd> svd(others.rowwise() - mean, Eigen::ComputeThinV);
      const Eigen::MatrixXd basis = svd.matrixV().leftCols(modes);
      const Eigen::VectorXd own = (rows.row(left) - mean).transpose();
      sum += (own - basis * (basis.transpose() * own)).norm();
    }
    EXPECT_NEAR(atlas.Generalisation(modes - 1), sum / 16.0, 1e-9) << modes;
  }
  EXPECT_GT(atlas.Specificity.minCoeff(), 0.0);
}

TEST(Atlas, OutlierIsTheShapeThatTheOthersDoNotMake)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  std::vector<Eigen::MatrixXd> shapes =
    Ellipsoids(sphere, { 3.0, 2.0, 1.2 }, Independent(2), Changes, 0.005, 8);
  for (Eigen::Index i = 0; i < sphere.Points.rows(); ++i)
  {
    shapes[11].row(i) *= 1.0 + 0.3 * std::exp(8.0 * (sphere.Points(i, 0) - 1.0));
  }
  EXPECT_EQ(shape::BuildAtlas(shapes, sphere.Triangles).OutlierRanks[11], 0);
}

// Kolmogorov and Smirnov: a sample of 1,000 uniform numbers is farther away than 1.95 / sqrt(1000)
// in one case of a thousand.
TEST(Atlas, PermutationTestIsUniformWhereGroupsDoNotDiffer)
{
  std::mt19937 random(2024);
  std::normal_distribution<double> normal;
  constexpr int trials = 1000, points = 5, shapes = 20;
  const Eigen::VectorXd weights = Eigen::VectorXd::Constant(points, 1.0 / points);
  Eigen::VectorXd groups(shapes);
  groups << Eigen::VectorXd::Zero(8), Eigen::VectorXd::Ones(12);
  std::vector<double> whole, first;
  for (int trial = 0; trial < trials; ++trial)
  {
    Eigen::MatrixXd deviations =
      Eigen::MatrixXd::NullaryExpr(3 * points, shapes, [&] { return normal(random); });
    deviations.colwise() -= deviations.rowwise().mean().eval();
    const shape::PermutationTestResult result =
      shape::TestByPermutation(deviations, weights, groups, { 499, trial });
    whole.push_back(result.PValue);
    first.push_back(result.PValues(0));
  }
  EXPECT_LT(DistanceFromUniform(whole), 1.95 / std::sqrt(1000.0));
  EXPECT_LT(DistanceFromUniform(first), 1.95 / std::sqrt(1000.0));
}

TEST(Atlas, GroupsAndRegressionAreFound)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const Eigen::MatrixXd factors = Independent(3);
  Eigen::Matrix3d changes;
  changes << Changes, 0.0, 0.0, 0.06;
  const std::vector<Eigen::MatrixXd> shapes =
    Ellipsoids(sphere, { 3.0, 2.0, 1.2 }, factors, changes, 0.01, 9);
  shape::AtlasVariables variables;
  variables.Groups = (factors.col(0).array() > 0.0).cast<double>();
  variables.Covariate = 50.0 + 4.0 * factors.col(1).array();
  shape::AtlasOptions options;
  const shape::AtlasResult atlas = shape::BuildAtlas(shapes, sphere.Triangles, variables, options);
  EXPECT_LT(atlas.OfGroups.PValue, 0.01);
  EXPECT_FALSE(atlas.OfGroups.Exact);
  // Along the axis that differs, points differ; those around the others do not.
  Eigen::Index tip = 0;
  sphere.Points.col(0).maxCoeff(&tip);
  EXPECT_LT(atlas.OfGroups.QValues(tip), 0.05);
  sphere.Points.col(1).maxCoeff(&tip);
  EXPECT_LT(atlas.OfCovariate.QValues(tip), 0.05);
  EXPECT_GT(atlas.OfGroups.QValues(tip), 0.05) << "the groups have the same mean there";
  // The length of the slope does not depend on the orientation.
  const Eigen::MatrixXd truth = sphere.Points * (changes.row(1) / 4.0).asDiagonal();
  EXPECT_NEAR(atlas.OfCovariate.Slope.norm(), truth.norm(), 0.02 * truth.norm());
  options.RemoveRegression = true;
  const shape::AtlasResult rest = shape::BuildAtlas(shapes, sphere.Triangles, variables, options);
  EXPECT_NEAR(rest.Variances.sum(), atlas.Variances.sum() * (1.0 - atlas.OfCovariate.RSquared),
    1e-9 * atlas.Variances.sum());
  EXPECT_LT((rest.Scores.transpose() * factors.col(1)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(Atlas, FewPermutationsAreEnumerated)
{
  const Eigen::VectorXd groups = (Eigen::VectorXd(6) << 0, 0, 0, 1, 1, 1).finished();
  Eigen::MatrixXd deviations = Eigen::MatrixXd::Zero(3, 6);
  deviations.row(0) << -3, -2, -1, 1, 2, 3;
  const shape::PermutationTestResult result =
    shape::TestByPermutation(deviations, Eigen::VectorXd::Ones(1), groups);
  EXPECT_TRUE(result.Exact);
  EXPECT_EQ(result.Permutations, 20);
  EXPECT_DOUBLE_EQ(result.PValue, 0.1) << "two of 20 separate the groups as far";
  EXPECT_DOUBLE_EQ(result.PValues(0), 0.1);
  EXPECT_TRUE(result.Slope.isApprox(Eigen::RowVector3d(4.0, 0.0, 0.0)));
}

TEST(Atlas, WrongInputIsRefused)
{
  const shape::Mesh sphere = shapetest::Icosphere(1), finer = shapetest::Icosphere(2);
  std::vector<Eigen::MatrixXd> three(3, sphere.Points);
  EXPECT_REFUSED(shape::BuildAtlas({ three[0], three[1] }, sphere.Triangles), "at least 3 shapes",
    "there are 2", "Group Datasets");
  EXPECT_THROW(shape::BuildAtlas({}, sphere.Triangles), shape::InvalidInput);
  EXPECT_EQ(shape::BuildAtlas(three, sphere.Triangles).NumberOfModes, 0) << "they are alike";
  shape::AtlasVariables constant;
  constant.Covariate = Eigen::Vector3d::Ones();
  EXPECT_THROW(shape::BuildAtlas(three, sphere.Triangles, constant), shape::InvalidInput);
  three[1] = finer.Points;
  EXPECT_THROW(shape::BuildAtlas(three, sphere.Triangles), shape::InvalidInput);
  three[1] = sphere.Points;
  three[1](0, 0) = std::nan("");
  EXPECT_THROW(shape::BuildAtlas(three, sphere.Triangles), shape::InvalidInput);
}
