#include "Cage/CageDeform.h"
#include "Distance/SignedDistance.h"
#include "Mesh/Mesh.h"
#include "Support/CageShapes.h"
#include "Support/ProgressChecks.h"
#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace
{

using shape::CageCoordinates;
using shape::CageDeformOptions;
using shape::CageMovedPoints;
using shape::Mesh;
using namespace shapetest; // NOLINT(google-build-using-namespace)

/// The mean value weights as the paper defines them, from the mean vector of each triangle, with
/// extended precision.
Eigen::RowVector3d MoveByPaper(
  const Mesh& cage, const Eigen::MatrixXd& moved, const Eigen::RowVector3d& position)
{
  using Vector = Eigen::Matrix<long double, 3, 1>;
  Vector sum = Vector::Zero();
  long double total = 0.0L;
  for (Eigen::Index t = 0; t < cage.Triangles.rows(); ++t)
  {
    std::array<Vector, 3> rays;
    for (int k = 0; k < 3; ++k)
    {
      rays[k] = (cage.Points.row(cage.Triangles(t, k)) - position).transpose().cast<long double>();
    }
    Vector mean = Vector::Zero();
    for (int k = 0; k < 3; ++k)
    {
      const Vector normal = rays[(k + 1) % 3].cross(rays[(k + 2) % 3]);
      mean += 0.5L * normal.normalized() *
        std::atan2(normal.norm(), rays[(k + 1) % 3].dot(rays[(k + 2) % 3]));
    }
    for (int k = 0; k < 3; ++k)
    {
      const Vector normal = rays[(k + 1) % 3].cross(rays[(k + 2) % 3]);
      const long double weight = mean.dot(normal) / rays[k].dot(normal);
      sum += weight * moved.row(cage.Triangles(t, k)).transpose().cast<long double>();
      total += weight;
    }
  }
  return (sum / total).transpose().cast<double>();
}

/// The paper's normal of a moved triangle, times its stretch. rows: the corners.
Eigen::RowVector3d StretchedNormal(const Eigen::Matrix3d& corners, const Eigen::Matrix3d& images)
{
  // The stretch is the root mean square of the singular values of the triangle's linear map.
  Eigen::Matrix<double, 3, 2> edges, imageEdges;
  edges << (corners.row(1) - corners.row(0)).transpose(),
    (corners.row(2) - corners.row(0)).transpose();
  imageEdges << (images.row(1) - images.row(0)).transpose(),
    (images.row(2) - images.row(0)).transpose();
  const Eigen::Matrix<double, 3, 3> linear =
    imageEdges * (edges.transpose() * edges).inverse() * edges.transpose();
  return std::sqrt(0.5) * linear.norm() *
    imageEdges.col(0).cross(imageEdges.col(1)).normalized().transpose();
}

/// Green coordinates in closed form, triangle by triangle with extended precision. The potential of
/// an edge of length l with its ends at distances a and b is log((a + b + l) / (a + b - l)).
Eigen::RowVector3d MoveByClosedForm(
  const Mesh& cage, const Eigen::MatrixXd& moved, const Eigen::RowVector3d& position)
{
  using Vector = Eigen::Matrix<long double, 3, 1>;
  Vector sum = Vector::Zero();
  for (Eigen::Index t = 0; t < cage.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = shape::GetCorners(cage, t),
                          images = shape::GetCorners({ moved, cage.Triangles }, t);
    std::array<Vector, 3> rays, edges;
    std::array<long double, 3> distances;
    for (int k = 0; k < 3; ++k)
    {
      rays[k] = (corners.row(k) - position).transpose().cast<long double>();
      edges[k] =
        (corners.row((k + 2) % 3) - corners.row((k + 1) % 3)).transpose().cast<long double>();
      distances[k] = rays[k].norm();
    }
    const Vector area = edges[0].cross(edges[1]);
    const Vector normal = area.normalized();
    const long double height = normal.dot(rays[0]);
    const long double angle = 2.0L *
      std::atan2(rays[0].dot(rays[1].cross(rays[2])),
        distances[0] * distances[1] * distances[2] + distances[0] * rays[1].dot(rays[2]) +
          distances[1] * rays[2].dot(rays[0]) + distances[2] * rays[0].dot(rays[1]));
    Vector potentials = Vector::Zero(), sides;
    for (int k = 0; k < 3; ++k)
    {
      const long double length = edges[k].norm(),
                        both = distances[(k + 1) % 3] + distances[(k + 2) % 3];
      potentials(k) = std::log((both + length) / (both - length));
      sides(k) = -normal.cross(edges[k]).dot(rays[(k + 1) % 3]) / length;
    }
    sum += (sides.dot(potentials) - height * angle) *
      StretchedNormal(corners, images).transpose().cast<long double>();
    for (int i = 0; i < 3; ++i)
    {
      long double share = edges[i].norm() * sides(i) / area.norm() * angle;
      for (int k = 0; k < 3; ++k)
      {
        share += height / area.norm() * edges[i].dot(edges[k]) / edges[k].norm() * potentials(k);
      }
      sum += share * images.row(i).transpose().cast<long double>();
    }
  }
  return (sum / (4.0L * std::acos(-1.0L))).transpose().cast<double>();
}

/// Green's third identity by sums over small triangles.
Eigen::RowVector3d MoveByIntegrals(
  const Mesh& cage, const Eigen::MatrixXd& moved, const Eigen::RowVector3d& position)
{
  constexpr int Parts = 60;
  Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
  for (Eigen::Index t = 0; t < cage.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = shape::GetCorners(cage, t),
                          images = shape::GetCorners({ moved, cage.Triangles }, t);
    const Eigen::RowVector3d area =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0));
    const Eigen::RowVector3d normal = StretchedNormal(corners, images);
    const double part = 0.5 * area.norm() / (Parts * Parts);
    for (int i = 0; i < Parts; ++i)
    {
      for (int j = 0; j < 2 * (Parts - i) - 1; ++j)
      {
        const double shift = j % 2 ? 2.0 / 3.0 : 1.0 / 3.0;
        const double a = (i + shift) / Parts, b = (j / 2 + shift) / Parts;
        const Eigen::RowVector3d place(1.0 - a - b, a, b);
        const Eigen::RowVector3d ray = place * corners - position;
        sum += part / (4.0 * M_PI * ray.norm()) *
          (normal + ray.dot(area) / (area.norm() * ray.squaredNorm()) * place * images);
      }
    }
  }
  return sum;
}

} // namespace

TEST(CageDeform, MeanValueReproducesAffineMotionsEverywhere)
{
  for (const Mesh& cage : Cages())
  {
    const Eigen::MatrixXd points =
      Stacked(PointsAround(cage, 300, 3.0), PointsNear(cage, Sides::Both));
    EXPECT_LT(
      AffineError(cage, Shear(), points, WithCoordinates(CageCoordinates::MeanValue)), 1e-10);
  }
}

TEST(CageDeform, GreenReproducesSimilaritiesAndWithTheOptionAffineMotions)
{
  CageDeformOptions options = WithCoordinates(CageCoordinates::Green);
  for (const Mesh& cage : Cages())
  {
    const Eigen::MatrixXd points =
      Stacked(PointsAround(cage, 300, 1.0), PointsNear(cage, Sides::Inner));
    options.ReproduceAffine = false;
    EXPECT_LT(AffineError(cage, Similarity(), points, options), 1e-10);
    // The paper's stretch is a number, which cannot turn a normal as shear does.
    EXPECT_GT(AffineError(cage, Shear(), points, options), 1e-2);
    options.ReproduceAffine = true;
    EXPECT_LT(AffineError(cage, Shear(), points, options), 1e-10);
    EXPECT_LT(AffineError(cage, Similarity(), points, options), 1e-10);
  }
}

TEST(CageDeform, MeanValueIsThePapersDefinition)
{
  for (const Mesh& cage : { CornerCage(), PebbleCage(2, 2.0) })
  {
    const Eigen::MatrixXd points = PointsAround(cage, 200, 1.6), moved = Bent(cage.Points);
    const CageMovedPoints result =
      MoveByCage(cage, moved, points, WithCoordinates(CageCoordinates::MeanValue));
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      EXPECT_LT((result.Points.row(i) - MoveByPaper(cage, moved, points.row(i))).norm(), 1e-12);
    }
  }
}

TEST(CageDeform, GreenIsItsClosedForm)
{
  for (const Mesh& cage : { CornerCage(), PebbleCage(2, 2.0) })
  {
    // Inside, also close to the surface, and in the planes of triangles.
    const Eigen::MatrixXd moved = Bent(cage.Points),
                          points =
                            Stacked(PointsAround(cage, 300, 1.0), PointsNear(cage, Sides::Inner));
    const shape::CageDeformer deformer(cage, moved, WithCoordinates(CageCoordinates::Green));
    const CageMovedPoints result = deformer.Evaluate(points);
    // Not at the surface, where the closed form is not defined.
    const Eigen::VectorXd distances = shape::SignedDistance(cage).Evaluate(points).Distances;
    int compared = 0;
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      if (distances(i) < -1e-7)
      {
        EXPECT_LT(
          (result.Points.row(i) - MoveByClosedForm(cage, moved, points.row(i))).norm(), 1e-12);
        ++compared;
      }
    }
    EXPECT_GT(compared, 200);
  }
}

TEST(CageDeform, APositionDoesNotDependOnThoseBesideIt)
{
  const Mesh cage = CornerCage();
  const Eigen::MatrixXd points = PointsAround(cage, 13, 1.1);
  for (const CageCoordinates coordinates : { CageCoordinates::MeanValue, CageCoordinates::Green })
  {
    const shape::CageDeformer deformer(cage, Bent(cage.Points), WithCoordinates(coordinates, true));
    const CageMovedPoints all = deformer.Evaluate(points);
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      const CageMovedPoints one = deformer.Evaluate(points.row(i));
      EXPECT_EQ(one.Points.row(0), all.Points.row(i));
      EXPECT_EQ(one.Gradients.row(0), all.Gradients.row(i));
    }
  }
}

TEST(CageDeform, GreenIsGreensIdentityWithThePapersStretch)
{
  for (const Mesh& cage : { CornerCage(), PebbleCage(1, 2.0) })
  {
    const Eigen::MatrixXd moved = Bent(cage.Points);
    // Away from the surface, where the sums are accurate.
    const Eigen::RowVector3d centre =
      cage.Points.rows() == 12 ? Eigen::RowVector3d(5.5, -1.5, 1.5) : Eigen::RowVector3d::Zero();
    Eigen::MatrixXd points = 0.2 * Icosphere(0).Points;
    points.rowwise() += centre;
    const CageMovedPoints result =
      MoveByCage(cage, moved, points, WithCoordinates(CageCoordinates::Green));
    for (Eigen::Index i = 0; i < points.rows(); ++i)
    {
      EXPECT_EQ(result.OutsideDomain(i), 0);
      EXPECT_LT((result.Points.row(i) - MoveByIntegrals(cage, moved, points.row(i))).norm(), 1e-3);
    }
  }
}

TEST(CageDeform, MeanValueCoordinatesSumToOneAndArePositiveInConvexCages)
{
  const Mesh cage = Icosphere(1);
  const Eigen::MatrixXd points = PointsAround(cage, 50, 1.0);
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(points.rows());
  std::vector<int> inside;
  for (int i = 0; i < points.rows(); ++i)
  {
    if (points.row(i).norm() < 0.85)
    {
      inside.push_back(i);
    }
  }
  for (Eigen::Index vertex = 0; vertex < cage.Points.rows(); ++vertex)
  {
    Eigen::MatrixXd moved = cage.Points;
    moved(vertex, 0) += 1.0;
    const CageMovedPoints result =
      MoveByCage(cage, moved, points, WithCoordinates(CageCoordinates::MeanValue));
    const Eigen::VectorXd coordinate = result.Points.col(0) - points.col(0);
    EXPECT_GT(Eigen::VectorXd(coordinate(inside)).minCoeff(), 0.0);
    sum += coordinate;
  }
  EXPECT_LT((sum.array() - 1.0).abs().maxCoeff(), 1e-10);
}

TEST(CageDeform, MeanValueFollowsTheCageOnItAndIsContinuousThere)
{
  ExpectFollowsCage(CageCoordinates::MeanValue);
}

TEST(CageDeform, GradientsAreThoseOfTheMap)
{
  const Mesh cage = CornerCage();
  // Also in the plane of triangles at the reentrant edge, inside and outside.
  Eigen::MatrixXd special(3, 3);
  special << 5.5, -1.0, 1.5, 5.5, -1.5, 1.5, 7.0, 0.5, 1.5;
  const Eigen::MatrixXd points = Stacked(special, PointsAround(cage, 60, 1.4));
  EXPECT_LT(GradientError(cage, points, CageCoordinates::MeanValue), 1e-5);
  EXPECT_LT(GradientError(cage, special, CageCoordinates::Green), 1e-6);
  // At a point on the cage, the gradient is that of points inside: tangents are those of the cage.
  const Eigen::MatrixXd moved = Bent(cage.Points);
  for (Eigen::Index t = 0; t < cage.Triangles.rows(); ++t)
  {
    const Eigen::Matrix3d corners = shape::GetCorners(cage, t),
                          images = shape::GetCorners({ moved, cage.Triangles }, t);
    const CageMovedPoints at = MoveByCage(
      cage, moved, corners.colwise().mean(), WithCoordinates(CageCoordinates::MeanValue, true));
    const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> gradient =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(at.Gradients.data());
    const Eigen::Vector3d edge = corners.row(1) - corners.row(0),
                          image = images.row(1) - images.row(0);
    EXPECT_LT((gradient * edge - image).norm(), 1e-4);
  }
  ExpectAffineGradients(CageCoordinates::MeanValue);
  ExpectAffineGradients(CageCoordinates::Green);
}

TEST(CageDeform, PointsOutsideStay)
{
  ExpectOutsideStays(CageCoordinates::Green);
  const Mesh cage = Box({ 0, 0, 0 }, { 1, 1, 1 });
  Eigen::MatrixXd points(2, 3);
  points << 30.0, 0.5, 0.5, 200.0, 0.0, 0.0;
  const CageMovedPoints moved = MoveByCage(
    cage, Similarity()(cage.Points), points, WithCoordinates(CageCoordinates::MeanValue));
  EXPECT_EQ(moved.OutsideDomain, Eigen::Vector2i(0, 1));
  EXPECT_EQ(moved.Points.row(1), points.row(1));
}

TEST(CageDeform, ACageMayFaceInwardsAndHaveUnusedPoints)
{
  const Mesh cage = PebbleCage(1, 1.0);
  const Eigen::MatrixXd points = PointsAround(cage, 50, 1.2), moved = Bent(cage.Points);
  Mesh other = shapetest::Reversed(cage);
  other.Points.conservativeResize(cage.Points.rows() + 1, 3);
  other.Points.bottomRows(1) << 1e3, 0, 0;
  Eigen::MatrixXd otherMoved(cage.Points.rows() + 1, 3);
  otherMoved << moved, Eigen::RowVector3d(0, 0, 7);
  for (const CageCoordinates coordinates : { CageCoordinates::MeanValue, CageCoordinates::Green })
  {
    const CageMovedPoints one = MoveByCage(cage, moved, points, WithCoordinates(coordinates)),
                          two = MoveByCage(other, otherMoved, points, WithCoordinates(coordinates));
    EXPECT_EQ(one.OutsideDomain, two.OutsideDomain);
    EXPECT_LT((one.Points - two.Points).cwiseAbs().maxCoeff(), 1e-12);
  }
}

TEST(CageDeform, BadInputIsRefused)
{
  const Mesh cage = Box({ 0, 0, 0 }, { 1, 1, 1 });
  EXPECT_REFUSED(shape::CageDeformer(cage, Icosphere(1).Points), "42 points", "Cage 8", "moved");
  EXPECT_REFUSED(shape::CageDeformer(shapetest::WithoutLast(cage), cage.Points), "the Cage");
  Eigen::MatrixXd broken = cage.Points;
  broken(3, 1) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_REFUSED(shape::CageDeformer(cage, broken), "the MovedCage", "not finite");
  const Mesh flat = shapetest::WithFlatTriangle(cage, 0, 0);
  EXPECT_REFUSED(shape::CageDeformer(flat, flat.Points), "no area", "Clean");
  const shape::CageDeformer deformer(cage, cage.Points);
  EXPECT_REFUSED(deformer.Evaluate(broken), "the Input", "not finite");
  broken = cage.Points;
  broken.col(2).setZero();
  CageDeformOptions options = WithCoordinates(CageCoordinates::Green);
  options.ReproduceAffine = true;
  EXPECT_REFUSED(shape::CageDeformer(cage, broken, options), "flat", "Reproduce Affine");
  EXPECT_TRUE(MoveByCage(cage, broken, cage.Points, WithCoordinates(CageCoordinates::Green))
                .Points.allFinite());
  shapetest::ExpectRefused<CageDeformOptions>([&](const CageDeformOptions& bad)
    { shape::CageDeformer(cage, cage.Points, bad); },
    WithCoordinates(CageCoordinates::MeanValue),
    { { &CageDeformOptions::Tetrahedra, 999, { "Tetrahedra", "999", "1,000" } } });
}

TEST(CageDeform, ProgressRisesAndStops)
{
  ExpectReports(CageCoordinates::MeanValue);
  ExpectReports(CageCoordinates::Green);
}
