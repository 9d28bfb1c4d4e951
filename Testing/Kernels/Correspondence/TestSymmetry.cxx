#include "Base/Errors.h"
#include "Correspondence/Symmetry.h"
#include "Support/MatchingShapes.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>
#include <set>
#include <vector>

namespace
{

shape::Mesh Ellipsoid(int level, const Eigen::Vector3d& axes)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  // Turned, so that the triangles have no symmetry of the ellipsoid.
  mesh.Points = mesh.Points * shapetest::Rotation(0.7, { 1, 2, 3 }).transpose() * axes.asDiagonal();
  return mesh;
}

/// A sphere with n equal arms around the z axis, flattened: the symmetries of a star with two
/// sides.
shape::Mesh Star(int arms, int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  mesh.Points = mesh.Points * shapetest::Rotation(0.7, { 1, 2, 3 }).transpose();
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    const double x = mesh.Points(i, 0), y = mesh.Points(i, 1), radius = std::hypot(x, y),
                 wave = std::cos(arms * std::atan2(y, x)) * std::pow(radius, arms);
    mesh.Points.row(i).head(2) *= 1.0 + 0.35 * wave;
    mesh.Points(i, 2) *= 0.5;
  }
  return mesh;
}

/// A sphere with random bumps.
shape::Mesh Random(unsigned int seed, int level)
{
  shape::Mesh mesh = shapetest::Icosphere(level);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> height(0.2, 0.6);
  Eigen::VectorXd radii = Eigen::VectorXd::Ones(mesh.Points.rows());
  for (int k = 0; k < 6; ++k)
  {
    const Eigen::Vector3d towards =
      Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
    const double size = height(random);
    radii.array() += size * (8.0 * ((mesh.Points * towards).array() - 1.0)).exp();
  }
  mesh.Points = radii.asDiagonal() * mesh.Points;
  return mesh;
}

int CountReversing(const shape::SymmetryResult& result)
{
  int count = 0;
  for (const shape::Symmetry& element : result.Elements)
  {
    count += element.Reversing ? 1 : 0;
  }
  return count;
}

/// The mean distance of images from `wanted`, divided by the longest edge of the bounding box.
double Error(const shape::Symmetry& element, const shape::Mesh& mesh, const Eigen::MatrixXd& wanted)
{
  return shapetest::MapErrors(element.Map, mesh, wanted).mean();
}

/// Checks the composition against the maps: it is that of a group, which the generators generate.
void ExpectGroup(const shape::SymmetryResult& result, const shape::Mesh& mesh)
{
  const auto order = static_cast<int>(result.Elements.size());
  std::vector<Eigen::MatrixXd> images;
  for (const shape::Symmetry& element : result.Elements)
  {
    images.push_back(shape::PullBack(element.Map, mesh.Triangles, mesh.Points));
  }
  const double size =
    (mesh.Points.colwise().maxCoeff() - mesh.Points.colwise().minCoeff()).maxCoeff();
  ASSERT_EQ(result.Composition.rows(), order);
  ASSERT_EQ(result.Composition.cols(), order);
  for (int i = 0; i < order; ++i)
  {
    EXPECT_EQ(result.Composition(0, i), i);
    EXPECT_EQ(result.Composition(i, 0), i);
    std::set<int> products;
    for (int j = 0; j < order; ++j)
    {
      const int product = result.Composition(i, j);
      products.insert(product);
      const Eigen::MatrixXd both =
        shape::PullBack(result.Elements[j].Map, mesh.Triangles, images[i]);
      EXPECT_LT((both - images[product]).rowwise().norm().mean() / size, 0.01)
        << i << " after " << j;
    }
    EXPECT_EQ(static_cast<int>(products.size()), order) << "each element once, so also the inverse";
    EXPECT_EQ(*products.rbegin(), order - 1);
  }
  std::vector<int> reached{ 0 };
  std::set<int> known{ 0 };
  for (std::size_t at = 0; at < reached.size(); ++at)
  {
    for (int i = 0; i < order; ++i)
    {
      const int product = result.Composition(i, reached[at]);
      if (result.Elements[i].Generator && known.insert(product).second)
      {
        reached.push_back(product);
      }
    }
  }
  EXPECT_EQ(static_cast<int>(reached.size()), order) << "the generators generate all elements";
}

/// Checks that the area of each copy of the domain, times the order, is that of the surface. Copies
/// are bounded by points halfway between images, which are rounded to points: of n points of a
/// copy, about one in sqrt(n) belongs to a neighbour.
void ExpectEqualCopies(const shape::SymmetryResult& result, const shape::Mesh& mesh)
{
  const auto order = static_cast<double>(result.Elements.size());
  const Eigen::VectorXd areas = shape::ComputePointAreas(mesh) / shape::ComputeArea(mesh);
  Eigen::VectorXd shares = Eigen::VectorXd::Zero(result.Elements.size());
  for (Eigen::Index i = 0; i < mesh.Points.rows(); ++i)
  {
    shares(result.Copies(i)) += areas(i);
    EXPECT_EQ(result.Copies(result.Orbits(i)), 0) << "the orbit's point is in the domain";
  }
  EXPECT_LT((order * shares.array() - 1.0).abs().maxCoeff(),
    1.0 / std::sqrt(static_cast<double>(mesh.Points.rows()) / order));
}

} // namespace

// Tolerance and the error of the points' spacing were chosen on other shapes: an ellipsoid with the
// axes 1, 1.4 and 2, stars with 3, 5 and 6 arms, a pebble, BumpySphere, and random bumps 0 to 3.
// There symmetries were at least 0.0023 below the bound, and other maps at least 0.0025 above it.

TEST(Symmetry, AnEllipsoidHasEightSymmetries)
{
  const Eigen::Vector3d axes(1.0, 1.3, 1.75);
  const shape::Mesh mesh = Ellipsoid(4, axes);
  const shape::SymmetryResult result = shape::FindSymmetries(mesh);
  ASSERT_EQ(result.Elements.size(), 8u);
  EXPECT_EQ(CountReversing(result), 4);
  ExpectGroup(result, mesh);
  ExpectEqualCopies(result, mesh);
  std::set<int> found;
  for (int i = 0; i < 8; ++i)
  {
    const shape::Symmetry& element = result.Elements[i];
    EXPECT_LT(element.Distortion, result.Bound - 0.001);
    EXPECT_EQ(element.Order, i == 0 ? 1 : 2);
    // The coordinates change signs.
    int best = -1;
    for (int signs = 0; signs < 8; ++signs)
    {
      const Eigen::Vector3d sign(signs & 1 ? -1 : 1, signs & 2 ? -1 : 1, signs & 4 ? -1 : 1);
      if (Error(element, mesh, mesh.Points * sign.asDiagonal()) < 0.01)
      {
        best = signs;
        EXPECT_EQ(element.Reversing, sign.prod() < 0.0);
        if (element.Reversing && (signs == 1 || signs == 2 || signs == 4))
        {
          // The ellipse in the plane where this coordinate is 0.
          const int across = signs == 1 ? 0 : signs == 2 ? 1 : 2;
          const double a = axes((across + 1) % 3), b = axes((across + 2) % 3);
          double length = 0.0;
          for (const auto& segment : element.Fixed)
          {
            length += (segment[1] - segment[0]).norm();
            EXPECT_LT(std::abs(segment[0](across)), 0.05);
          }
          // Ramanujan's length of an ellipse.
          const double h = std::pow((a - b) / (a + b), 2);
          EXPECT_NEAR(
            length / (M_PI * (a + b) * (1.0 + 3.0 * h / (10.0 + std::sqrt(4.0 - 3.0 * h)))), 1.0,
            0.03);
        }
      }
    }
    found.insert(best);
  }
  EXPECT_EQ(found.size(), 8u) << "each change of signs once";
  EXPECT_EQ(found.count(-1), 0u);
  // Points of an orbit differ by signs.
  const Eigen::MatrixXd representatives = mesh.Points(result.Orbits, Eigen::all);
  EXPECT_LT((representatives.cwiseAbs() - mesh.Points.cwiseAbs()).rowwise().norm().mean(), 0.06);
  // Means over orbits: of a coordinate 0, of its square the same.
  const Eigen::MatrixXd squares = mesh.Points.cwiseAbs2();
  EXPECT_LT(shape::Symmetrize(result, mesh.Triangles, mesh.Points).rowwise().norm().mean(), 0.01);
  EXPECT_LT((shape::Symmetrize(result, mesh.Triangles, squares) - squares).cwiseAbs().mean(), 0.02);
}

TEST(Symmetry, StarsAreDihedral)
{
  for (const int arms : { 4, 7 })
  {
    const shape::Mesh star = Star(arms, 4);
    const shape::SymmetryResult result = shape::FindSymmetries(star);
    // The dihedral group, and the exchange of both sides.
    ASSERT_EQ(result.Elements.size(), 4u * arms);
    EXPECT_EQ(CountReversing(result), 2 * arms);
    ExpectGroup(result, star);
    ExpectEqualCopies(result, star);
    std::vector<int> turned(arms, -1); // the element that is the rotation by k arms
    for (std::size_t i = 0; i < result.Elements.size(); ++i)
    {
      const shape::Symmetry& element = result.Elements[i];
      EXPECT_LT(element.Distortion, result.Bound - 0.001);
      for (int k = 0; k < arms; ++k)
      {
        const Eigen::Matrix3d turn = shapetest::Rotation(2.0 * M_PI * k / arms, { 0, 0, 1 });
        if (Error(element, star, star.Points * turn.transpose()) < 0.005)
        {
          EXPECT_EQ(turned[k], -1) << "one element";
          turned[k] = static_cast<int>(i);
          EXPECT_FALSE(element.Reversing);
          EXPECT_EQ(element.Order, arms / std::gcd(arms, k));
        }
      }
    }
    for (int k = 0; k < arms; ++k)
    {
      ASSERT_GE(turned[k], 0) << "a rotation by " << k << " arms";
    }
    for (int k = 0; k < arms; ++k)
    {
      for (int l = 0; l < arms; ++l)
      {
        EXPECT_EQ(result.Composition(turned[k], turned[l]), turned[(k + l) % arms]);
      }
    }
  }
}

TEST(Symmetry, BumpsAtRandomHaveNone)
{
  for (unsigned int seed = 10; seed < 14; ++seed)
  {
    const shape::Mesh mesh = Random(seed, 4);
    const shape::SymmetryResult result = shape::FindSymmetries(mesh);
    EXPECT_EQ(result.Elements.size(), 1u) << "seed " << seed;
    EXPECT_GT(result.Rejected, result.Bound + 0.001);
    EXPECT_EQ(result.Copies.maxCoeff(), 0);
    EXPECT_EQ(Error(result.Elements[0], mesh, mesh.Points), 0.0);
  }
}

TEST(Symmetry, AnotherMeshHasTheSameGroup)
{
  const shape::Mesh mesh = Ellipsoid(3, { 1.0, 1.3, 1.75 });
  const shapetest::Renumbered other = shapetest::Renumber(mesh, 5);
  const shape::SymmetryResult one = shape::FindSymmetries(mesh),
                              two = shape::FindSymmetries(other.Mesh);
  ASSERT_EQ(one.Elements.size(), 8u) << "642 points instead of 2562";
  ASSERT_EQ(two.Elements.size(), 8u);
  // A mesh of fewer points is bisected, so that distances are as exact.
  for (const shape::Symmetry& element : one.Elements)
  {
    EXPECT_LT(element.Distortion, one.Bound - 0.001);
    EXPECT_LT(element.Map.Triangles.maxCoeff(), mesh.Triangles.rows()) << "of the given surface";
  }
  for (const shape::Symmetry& element : two.Elements)
  {
    // The images of the points in the order of the first mesh.
    const shape::SurfacePoints map{ element.Map.Triangles(other.NewOf),
      element.Map.Barycentrics(other.NewOf, Eigen::all) };
    const Eigen::MatrixXd images = shapetest::PositionsOn(map, other.Mesh);
    int same = 0;
    for (const shape::Symmetry& each : one.Elements)
    {
      same += Error(each, mesh, images) < 0.005 ? 1 : 0;
    }
    EXPECT_EQ(same, 1);
  }
}

TEST(Symmetry, TheSpacingOfSearchPointsDoesNotDecide)
{
  for (const int points : { 500, 2000 })
  {
    shape::SymmetryOptions options;
    options.SearchPoints = points;
    const shape::SymmetryResult ellipsoid =
                                  shape::FindSymmetries(Ellipsoid(4, { 1.0, 1.3, 1.75 }), options),
                                bumps = shape::FindSymmetries(Random(12, 4), options);
    EXPECT_EQ(ellipsoid.Elements.size(), 8u) << points;
    EXPECT_EQ(bumps.Elements.size(), 1u) << points;
    for (const shape::Symmetry& element : ellipsoid.Elements)
    {
      EXPECT_LT(element.Distortion, ellipsoid.Bound - 0.001);
    }
    EXPECT_GT(bumps.Rejected, bumps.Bound + 0.001);
  }
}

// The whole square is mapped, not its boundary alone: eight symmetries, four of which reverse.
TEST(Symmetry, OpenSurfacesHaveSymmetriesToo)
{
  shape::Mesh mesh = shapetest::FlatSquare(45, 0.3);
  const shape::SymmetryResult square = shape::FindSymmetries(mesh);
  EXPECT_EQ(square.Elements.size(), 8u);
  EXPECT_EQ(CountReversing(square), 4);
  mesh.Points.col(0) *= 1.5;
  const shape::SymmetryResult rectangle = shape::FindSymmetries(mesh);
  EXPECT_EQ(rectangle.Elements.size(), 4u);
  EXPECT_EQ(CountReversing(rectangle), 2);
  ExpectGroup(rectangle, mesh);
}

TEST(Symmetry, OneTriangleIsASurface)
{
  shape::Mesh mesh;
  mesh.Points.resize(3, 3);
  mesh.Points << 0, 0, 0, 4, 0, 0, 1, 2, 0;
  mesh.Triangles.resize(1, 3);
  mesh.Triangles << 0, 1, 2;
  EXPECT_EQ(shape::FindSymmetries(mesh).Elements.size(), 1u);
  mesh.Points(2, 0) = 2.0; // two equal sides
  const shape::SymmetryResult result = shape::FindSymmetries(mesh);
  ASSERT_EQ(result.Elements.size(), 2u);
  EXPECT_LT(Error(result.Elements[1], mesh, mesh.Points({ 1, 0, 2 }, Eigen::all)), 0.02);
}

TEST(Symmetry, RefusesRoundAndSeparateSurfaces)
{
  EXPECT_THROW(shape::FindSymmetries(shapetest::Icosphere(3)), shape::SolveFailure);
  shape::Mesh two = Ellipsoid(2, { 1, 1.4, 2 });
  const Eigen::Index points = two.Points.rows(), triangles = two.Triangles.rows();
  two.Points.conservativeResize(2 * points, 3);
  two.Points.bottomRows(points) = two.Points.topRows(points).array() + 9.0;
  two.Triangles.conservativeResize(2 * triangles, 3);
  two.Triangles.bottomRows(triangles) =
    two.Triangles.topRows(triangles).array() + static_cast<int>(points);
  EXPECT_THROW(shape::FindSymmetries(two), shape::InvalidInput);
  for (const double tolerance : { 0.0, 0.2, double(NAN) })
  {
    shape::SymmetryOptions options;
    options.Tolerance = tolerance;
    EXPECT_THROW(shape::FindSymmetries(Ellipsoid(2, { 1, 1.4, 2 }), options), shape::InvalidInput);
  }
}
