#include "Base/Errors.h"
#include "Correspondence/Evaluate/Collection.h"
#include "Correspondence/Evaluate/MapDifference.h"
#include "Support/MatchingShapes.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using Measure = shape::CollectionOptions::MeasureType;

shape::CollectionOptions By(Measure measure)
{
  shape::CollectionOptions options;
  options.Measure = measure;
  return options;
}

std::vector<shape::CollectionShape> Shapes(
  const shape::Surface& base, const std::vector<Eigen::MatrixXd>& positions)
{
  std::vector<shape::CollectionShape> shapes;
  for (const Eigen::MatrixXd& each : positions)
  {
    shapes.push_back({ base.WithPoints(each), {} });
  }
  return shapes;
}

/// A sphere with a bump around the direction `towards`.
Eigen::MatrixXd Bump(
  const shape::Mesh& sphere, double height, const Eigen::RowVector3d& towards = { 0, 0, 1 })
{
  Eigen::MatrixXd points = sphere.Points;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    points.row(i) *= 1.0 + height * std::exp(6.0 * (sphere.Points.row(i).dot(towards) - 1.0));
  }
  return points;
}

/// A plate folded along the line x = 0, where it has an edge: an isometry of its triangles.
Eigen::MatrixXd Folded(const shape::Mesh& plate, double angle)
{
  Eigen::MatrixXd points = plate.Points;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (points(i, 0) > 0.0)
    {
      points(i, 2) = std::sin(angle) * points(i, 0);
      points(i, 0) *= std::cos(angle);
    }
  }
  return points;
}

/// A plate rolled to a part of a cylinder: an isometry up to the chords.
Eigen::MatrixXd RolledUp(const shape::Mesh& plate, double radius)
{
  Eigen::MatrixXd points = plate.Points;
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    const double angle = points(i, 0) / radius;
    points(i, 0) = radius * std::sin(angle);
    points(i, 2) = radius * std::cos(angle);
  }
  return points;
}

const Measure Intrinsic[] = { Measure::Area, Measure::Conformal, Measure::Both };

} // namespace

TEST(Collection, BendingDoesNotCount)
{
  // A grid without shake has edges along x = 0.
  const shape::Mesh plate = shapetest::FlatSquare(16, 0.0);
  const auto folds =
    Shapes(plate, { plate.Points, Folded(plate, 0.4), Folded(plate, 1.0), Folded(plate, 1.5) });
  for (const Measure measure : Intrinsic)
  {
    EXPECT_LT(shape::CompareCollection(plate, folds, By(measure)).Distances.maxCoeff(), 1e-10);
  }
  EXPECT_GT(
    shape::CompareCollection(plate, folds, By(Measure::Procrustes)).Distances.maxCoeff(), 0.05);

  // Chords are shorter than arcs by h^2 / 24 R^2: halving h divides the distance by 4.
  double before = 0.0;
  for (const int cells : { 8, 16, 32 })
  {
    const shape::Mesh finer = shapetest::FlatSquare(cells, 0.0);
    const double distance =
      shape::CompareCollection(finer, Shapes(finer, { finer.Points, RolledUp(finer, 1.0) }))
        .Distances.maxCoeff();
    if (before > 0.0)
    {
      EXPECT_NEAR(std::log2(before / distance), 2.0, 0.2);
    }
    before = distance;
  }
}

TEST(Collection, AFamilyOfBumpsIsALineInOrder)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  const std::vector<double> heights = { 0.3, 0.0, 0.5, 0.1, 0.4, 0.2, 0.6 };
  std::vector<Eigen::MatrixXd> positions;
  // Each shape is moved and turned, which must not count.
  for (std::size_t i = 0; i < heights.size(); ++i)
  {
    const Eigen::Matrix3d turn = shapetest::Rotation(double(i), Eigen::Vector3d(1, double(i), 2));
    positions.emplace_back((Bump(sphere, heights[i]) * turn.transpose()).rowwise() +
      Eigen::RowVector3d(double(i), -2.0, 0.5));
  }
  for (const Measure measure :
    { Measure::Area, Measure::Conformal, Measure::Both, Measure::Procrustes })
  {
    const shape::CollectionResult result =
      shape::CompareCollection(sphere, Shapes(sphere, positions), By(measure));
    const Eigen::MatrixXd& embedding = result.Embedding;
    const double sign = embedding(6, 0) > embedding(1, 0) ? 1.0 : -1.0;
    for (std::size_t i = 0; i < heights.size(); ++i)
    {
      for (std::size_t j = 0; j < heights.size(); ++j)
      {
        EXPECT_EQ(heights[i] < heights[j], sign * embedding(i, 0) < sign * embedding(j, 0));
        EXPECT_EQ(heights[i] < heights[j], result.Distances(1, i) < result.Distances(1, j));
      }
    }
    EXPECT_GT(result.Shares(0), 0.8);
    // The shapes differ at the bump, and nowhere else.
    Eigen::Index top = 0;
    const Eigen::VectorXd& deviation = measure == Measure::Procrustes ? result.PositionDeviation
      : measure == Measure::Conformal                                 ? result.Conformal.Deviation
                                                                      : result.Area.Deviation;
    deviation.maxCoeff(&top);
    EXPECT_GT(sphere.Points(top, 2), 0.7);
    if (measure == Measure::Area)
    {
      result.Area.Functions.col(0).cwiseAbs().maxCoeff(&top);
      EXPECT_GT(sphere.Points(top, 2), 0.8);
    }
  }
  EXPECT_EQ(shape::FindNearestToAll(Shapes(sphere, positions)), 0);
}

TEST(Collection, ScalingChangesAreasAlone)
{
  // Similar shapes have the operators s^2 I and I.
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const auto shapes = Shapes(sphere, { sphere.Points, 2.0 * sphere.Points, 3.0 * sphere.Points });
  Eigen::Matrix3d wanted;
  wanted << 0, 3, 8, 3, 0, 5, 8, 5, 0;
  const shape::CollectionResult areas = shape::CompareCollection(sphere, shapes, By(Measure::Area));
  EXPECT_LT((areas.Distances - wanted).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_NEAR(areas.Shares(0), 1.0, 1e-9);
  // The standard deviation of 1, 4 and 9, everywhere and for every function.
  EXPECT_LT((areas.Area.Deviation.array() - std::sqrt(98.0 / 9.0)).abs().maxCoeff(), 1e-9);
  EXPECT_LT((areas.Area.Variances.array() - 98.0 / 9.0).abs().maxCoeff(), 1e-9);
  EXPECT_LT(
    (areas.Area.Modes.col(0).cwiseAbs().array() - std::sqrt(98.0 / 9.0)).abs().maxCoeff(), 1e-9);
  EXPECT_LT(areas.Conformal.Modes.cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(
    shape::CompareCollection(sphere, shapes, By(Measure::Conformal)).Distances.maxCoeff(), 1e-9);
  EXPECT_LT(areas.Conformal.Deviation.maxCoeff(), 1e-9);
}

TEST(Collection, OperatorsAreThoseOfMapDifference)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const shape::Mesh pebble = shapetest::Pebble(sphere);
  shape::CollectionOptions options;
  options.BasisSize = 20;
  const shape::CollectionResult result =
    shape::CompareCollection(sphere, Shapes(sphere, { pebble.Points, sphere.Points }), options);
  shape::MapDifferenceOptions alone;
  alone.NumberOfEigenpairs = 20;
  alone.Products = shape::MapDifferenceOptions::ProductsType::Triangles;
  const Eigen::VectorXi same =
    Eigen::VectorXi::LinSpaced(sphere.Points.rows(), 0, static_cast<int>(sphere.Points.rows()) - 1);
  const shape::MapDifferenceResult difference =
    shape::MapDifference(sphere, pebble, shape::MakeSurfacePointsAtVertices(same, pebble), alone);
  EXPECT_LT((result.Area.Operators[0] - difference.Area.Matrix).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_LT(
    (result.Conformal.Operators[0] - difference.Conformal.Matrix).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_TRUE(result.Area.Operators[1].isIdentity(1e-9));
}

// All principal components together make each shape's fields of MapDifference again.
TEST(Collection, CoordinatesTimesModesAreTheDifferences)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const Eigen::Index points = sphere.Points.rows();
  std::vector<Eigen::MatrixXd> positions;
  for (const double height : { 0.0, 0.5, 0.2, 0.9 })
  {
    positions.push_back(Bump(sphere, height) +
      0.3 * height * (1.0 - height) * (Bump(sphere, 1.0, { 1, 0, 0 }) - sphere.Points));
  }
  shape::CollectionOptions options;
  options.BasisSize = 20;
  options.EmbeddingDimension = 3;
  const shape::CollectionResult result =
    shape::CompareCollection(sphere, Shapes(sphere, positions), options);
  EXPECT_NEAR(result.Shares.sum(), 1.0, 1e-9);
  EXPECT_GT(result.Shares(1), 1e-4) << "there is more than one mode";
  shape::MapDifferenceOptions alone;
  alone.NumberOfEigenpairs = 20;
  alone.Products = shape::MapDifferenceOptions::ProductsType::Triangles;
  const Eigen::VectorXi same = Eigen::VectorXi::LinSpaced(points, 0, static_cast<int>(points) - 1);
  Eigen::MatrixXd areas(points, 4), angles(points, 4);
  for (int i = 0; i < 4; ++i)
  {
    const shape::Mesh other{ positions[i], sphere.Triangles };
    const shape::MapDifferenceResult difference =
      shape::MapDifference(sphere, other, shape::MakeSurfacePointsAtVertices(same, other), alone);
    areas.col(i) = difference.Area.Field;
    angles.col(i) = difference.Conformal.Field;
  }
  const Eigen::MatrixXd scores = result.Embedding.array().rowwise() /
    (result.Embedding.colwise().norm().array() / std::sqrt(4.0));
  areas.colwise() -= areas.rowwise().mean().eval();
  angles.colwise() -= angles.rowwise().mean().eval();
  EXPECT_LT((result.Area.Modes * scores.transpose() - areas).cwiseAbs().maxCoeff(), 1e-8);
  EXPECT_LT((result.Conformal.Modes * scores.transpose() - angles).cwiseAbs().maxCoeff(), 1e-8);
}

TEST(Collection, AnOutlierIsFirst)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  std::vector<Eigen::MatrixXd> positions;
  for (int i = 0; i < 8; ++i)
  {
    positions.push_back(Bump(sphere, 0.3 + 0.02 * i));
  }
  // A bump of the same height elsewhere: its shape is the same, but not by this correspondence.
  positions[5] = Bump(sphere, 0.4, { 0, 1, 0 });
  for (const Measure measure :
    { Measure::Area, Measure::Conformal, Measure::Both, Measure::Procrustes })
  {
    EXPECT_EQ(
      shape::CompareCollection(sphere, Shapes(sphere, positions), By(measure)).Order.front(), 5);
  }
}

TEST(Collection, MapsOfRenumberedShapesGiveTheSame)
{
  const shape::Mesh sphere = shapetest::Icosphere(3);
  std::vector<shape::CollectionShape> mapped;
  std::vector<Eigen::MatrixXd> positions;
  for (int i = 0; i < 4; ++i)
  {
    positions.push_back(Bump(sphere, 0.2 * i));
    const shapetest::Renumbered other =
      shapetest::Renumber({ positions.back(), sphere.Triangles }, 7 + i);
    Eigen::VectorXi images(other.NewOf.size());
    for (int p = 0; p < static_cast<int>(images.size()); ++p)
    {
      images(other.NewOf(p)) = p;
    }
    mapped.push_back({ other.Mesh, shape::MakeSurfacePointsAtVertices(images, sphere) });
  }
  const shape::CollectionResult result = shape::CompareCollection(sphere, mapped),
                                wanted =
                                  shape::CompareCollection(sphere, Shapes(sphere, positions));
  EXPECT_LT((result.Distances - wanted.Distances).cwiseAbs().maxCoeff(), 1e-9);
  EXPECT_THROW(
    shape::CompareCollection(sphere, mapped, By(Measure::Procrustes)), shape::InvalidInput);
  // With the positions of the template's points on each shape, the positions are compared.
  for (std::size_t i = 0; i < mapped.size(); ++i)
  {
    mapped[i].OnShape = positions[i];
  }
  const Eigen::MatrixXd distances =
    shape::CompareCollection(sphere, mapped, By(Measure::Procrustes)).Distances;
  EXPECT_LT((distances -
              shape::CompareCollection(sphere, Shapes(sphere, positions), By(Measure::Procrustes))
                .Distances)
              .cwiseAbs()
              .maxCoeff(),
    1e-9);
}

TEST(Collection, LeavesOfOneGroupAreNeighbours)
{
  // Two groups by turns: low bumps, and high ones.
  const shape::Mesh sphere = shapetest::Icosphere(3);
  std::vector<Eigen::MatrixXd> positions;
  for (const double height : { 0.0, 0.8, 0.05, 0.85, 0.1, 0.9 })
  {
    positions.push_back(Bump(sphere, height));
  }
  const std::vector<int> leaves =
    shape::CompareCollection(sphere, Shapes(sphere, positions)).Leaves;
  ASSERT_EQ(leaves.size(), 6U);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(leaves[i] % 2, i < 3 ? 0 : 1);
  }
}

TEST(Collection, RefusesShapesThatDoNotCorrespond)
{
  const shape::Mesh sphere = shapetest::Icosphere(2);
  const shape::Mesh renumbered = shapetest::Renumber(sphere, 3).Mesh;
  EXPECT_THROW(shape::CompareCollection(sphere, {}), shape::InvalidInput);
  EXPECT_THROW(
    shape::CompareCollection(sphere, { { shapetest::Icosphere(1), {} } }), shape::InvalidInput);
  EXPECT_THROW(shape::CompareCollection(sphere, { { renumbered, {} } }), shape::InvalidInput);
  EXPECT_THROW(
    shape::CompareCollection(sphere, Shapes(sphere, { NAN * sphere.Points })), shape::InvalidInput);
  for (const int size : { 1, 163 })
  {
    shape::CollectionOptions options;
    options.BasisSize = size;
    EXPECT_THROW(shape::CompareCollection(sphere, Shapes(sphere, { sphere.Points }), options),
      shape::InvalidInput);
  }
}
