#pragma once

#include "Cage/CageDeform.h"
#include "Mesh/Mesh.h"
#include "Support/ProgressChecks.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TestShapes.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

// Cages, positions around them and motions, for the tests of deformations by cages.
namespace shapetest
{

inline shape::CageDeformOptions WithCoordinates(
  shape::CageCoordinates coordinates, bool gradient = false)
{
  shape::CageDeformOptions options;
  options.Coordinates = coordinates;
  options.Tetrahedra = 5000;
  options.DeformationGradient = gradient;
  return options;
}

inline shape::CageMovedPoints MoveByCage(const shape::Mesh& cage, const Eigen::MatrixXd& moved,
  const Eigen::MatrixXd& points, const shape::CageDeformOptions& options)
{
  return shape::CageDeformer(cage, moved, options).Evaluate(points);
}

/// A prism over an L: triangles in common planes, an edge with a reentrant angle, coordinates off
/// the origin.
inline shape::Mesh CornerCage()
{
  shape::Mesh prism = Prism({ { 0, 0 }, { 3, 0 }, { 3, 1 }, { 1, 1 }, { 1, 3 }, { 0, 3 } });
  prism.Points.rowwise() += Eigen::RowVector3d(5.0, -2.0, 1.0);
  return prism;
}

/// An icosphere whose points are shaken, of size `scale`.
inline shape::Mesh PebbleCage(int level, double scale)
{
  shape::Mesh sphere = Icosphere(level);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> shake(0.9, 1.1);
  for (Eigen::Index i = 0; i < sphere.Points.rows(); ++i)
  {
    sphere.Points.row(i) *= scale * shake(random);
  }
  return sphere;
}

/// Random points in the box of a mesh, made larger around its centre by `factor`.
inline Eigen::MatrixXd PointsAround(const shape::Mesh& mesh, int count, double factor)
{
  const Eigen::RowVector3d low = mesh.Points.colwise().minCoeff(),
                           high = mesh.Points.colwise().maxCoeff();
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-0.5 * factor, 0.5 * factor);
  Eigen::MatrixXd points(count, 3);
  for (Eigen::Index i = 0; i < points.size(); ++i)
  {
    points(i) = unit(random);
  }
  return (points * (high - low).asDiagonal()).rowwise() + 0.5 * (low + high);
}

enum class Sides
{
  Inner,
  Both
};

/// Points at small distances from about 20 triangles, edges and points of a mesh, and in the planes
/// of its triangles.
inline Eigen::MatrixXd PointsNear(const shape::Mesh& mesh, Sides sides)
{
  const double size = shape::ComputeLongestBoxEdge(mesh.Points);
  const std::vector<Eigen::RowVector3d> places = { { 0.3, 0.3, 0.4 }, { 0.5, 0.5, 0.0 },
    { 0.0, 0.25, 0.75 }, { 1.0, 0.0, 0.0 }, { 1.5, -0.25, -0.25 }, { -0.5, 1.5, 0.0 } };
  std::vector<Eigen::RowVector3d> found;
  const Eigen::Index step = std::max<Eigen::Index>(1, mesh.Triangles.rows() / 20);
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); t += step)
  {
    const Eigen::Matrix3d corners = shape::GetCorners(mesh, t);
    const Eigen::RowVector3d normal =
      (corners.row(1) - corners.row(0)).cross(corners.row(2) - corners.row(0)).normalized();
    for (const Eigen::RowVector3d& place : places)
    {
      for (const double height : { 0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-3, 1e-2 })
      {
        found.emplace_back(place * corners + (sides == Sides::Both ? height : 0.0) * size * normal);
        found.emplace_back(place * corners - height * size * normal);
      }
    }
  }
  Eigen::MatrixXd points(found.size(), 3);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    points.row(static_cast<Eigen::Index>(i)) = found[i];
  }
  return points;
}

inline Eigen::MatrixXd Stacked(const Eigen::MatrixXd& above, const Eigen::MatrixXd& below)
{
  Eigen::MatrixXd all(above.rows() + below.rows(), 3);
  all << above, below;
  return all;
}

struct AffineMotion
{
  Eigen::Matrix3d Linear;
  Eigen::RowVector3d Offset;

  Eigen::MatrixXd operator()(const Eigen::MatrixXd& points) const
  {
    return (points * this->Linear.transpose()).rowwise() + this->Offset;
  }
};

inline AffineMotion Shear()
{
  AffineMotion motion;
  motion.Linear << 1.2, 0.5, -0.3, 0.1, 0.7, 0.2, -0.4, 0.3, 1.5;
  motion.Offset << 3.0, -1.0, 2.0;
  return motion;
}

inline AffineMotion Similarity()
{
  AffineMotion motion;
  motion.Linear =
    1.7 * Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 3).normalized()).toRotationMatrix();
  motion.Offset << 3.0, -1.0, 2.0;
  return motion;
}

/// A smooth motion that is not affine.
inline Eigen::MatrixXd Bent(const Eigen::MatrixXd& points)
{
  Eigen::MatrixXd moved = points;
  moved.col(0) += 0.3 * points.col(1).array().sin().matrix();
  moved.col(1) += 0.2 * points.col(0).cwiseProduct(points.col(2));
  moved.col(2) += 0.1 * points.col(0).array().square().matrix();
  return moved;
}

/// The rows of points that moved.
inline std::vector<int> RowsInside(const shape::CageMovedPoints& moved)
{
  std::vector<int> rows;
  for (int i = 0; i < moved.OutsideDomain.size(); ++i)
  {
    if (moved.OutsideDomain(i) == 0)
    {
      rows.push_back(i);
    }
  }
  return rows;
}

/// The largest distance from the affine image, of points that moved, relative to the cage's size.
inline double AffineError(const shape::Mesh& cage, AffineMotion motion,
  const Eigen::MatrixXd& points, const shape::CageDeformOptions& options)
{
  motion.Offset *= shape::ComputeLongestBoxEdge(cage.Points);
  const shape::CageMovedPoints moved = MoveByCage(cage, motion(cage.Points), points, options);
  EXPECT_TRUE(moved.Points.allFinite());
  const Eigen::MatrixXd difference = moved.Points - motion(points);
  const std::vector<int> rows = RowsInside(moved);
  EXPECT_GT(rows.size(), 50U);
  return Eigen::MatrixXd(difference(rows, Eigen::all)).cwiseAbs().maxCoeff() /
    shape::ComputeLongestBoxEdge(cage.Points);
}

inline std::vector<shape::Mesh> Cages()
{
  return { Box({ -1, -2, -3 }, { 2, 2, 1 }), CornerCage(), PebbleCage(1, 1e-6), PebbleCage(2, 1e6),
    Joined({ PebbleCage(1, 3.0), Reversed(Icosphere(1)) }) };
}

/// The largest difference of gradients from central differences.
inline double GradientError(
  const shape::Mesh& cage, const Eigen::MatrixXd& points, shape::CageCoordinates coordinates)
{
  constexpr double Step = 1e-4;
  const shape::CageDeformer deformer(cage, Bent(cage.Points), WithCoordinates(coordinates, true));
  const shape::CageMovedPoints at = deformer.Evaluate(points);
  double worst = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    const Eigen::RowVector3d step = Step * Eigen::RowVector3d::Unit(axis);
    const shape::CageMovedPoints ahead = deformer.Evaluate(points.rowwise() + step),
                                 behind = deformer.Evaluate(points.rowwise() - step);
    for (const int i : RowsInside(at))
    {
      for (int k = 0; k < 3; ++k)
      {
        const double slope = (ahead.Points(i, k) - behind.Points(i, k)) / (2.0 * Step);
        worst = std::max(worst, std::abs(at.Gradients(i, 3 * k + axis) - slope));
      }
    }
  }
  return worst;
}

/// The map follows the cage on it, and is continuous there.
inline void ExpectFollowsCage(shape::CageCoordinates coordinates)
{
  const shape::Mesh cage = CornerCage();
  const Eigen::MatrixXd moved = Bent(cage.Points);
  const shape::CageDeformer deformer(cage, moved, WithCoordinates(coordinates));
  EXPECT_LT((deformer.Evaluate(cage.Points).Points - moved).cwiseAbs().maxCoeff(), 1e-13);
  for (const Eigen::RowVector3d& place :
    { Eigen::RowVector3d(0.2, 0.3, 0.5), Eigen::RowVector3d(0.5, 0.0, 0.5) })
  {
    for (Eigen::Index t = 0; t < cage.Triangles.rows(); ++t)
    {
      const Eigen::RowVector3d on = place * shape::GetCorners(cage, t),
                               to = place * shape::GetCorners({ moved, cage.Triangles }, t);
      for (const double distance : { 0.0, 1e-13, 1e-10, 1e-7, 1e-4 })
      {
        const Eigen::RowVector3d towards = (Eigen::RowVector3d(5.5, -1.5, 1.5) - on).normalized();
        const shape::CageMovedPoints near = deformer.Evaluate(on + distance * towards);
        EXPECT_LT((near.Points.row(0) - to).norm(), 1e-13 + 10.0 * distance);
      }
    }
  }
}

/// Affine motions have their gradient everywhere.
inline void ExpectAffineGradients(shape::CageCoordinates coordinates)
{
  const shape::Mesh cage = CornerCage();
  const Eigen::MatrixXd points =
    Stacked(PointsAround(cage, 60, 1.4), PointsNear(cage, Sides::Both));
  shape::CageDeformOptions options = WithCoordinates(coordinates, true);
  options.ReproduceAffine = true;
  const shape::CageMovedPoints at = MoveByCage(cage, Shear()(cage.Points), points, options);
  const Eigen::Matrix<double, 3, 3, Eigen::RowMajor> linear = Shear().Linear;
  const Eigen::Map<const Eigen::RowVectorXd> expected(linear.data(), 9);
  for (const int i : RowsInside(at))
  {
    EXPECT_LT((at.Gradients.row(i) - expected).cwiseAbs().maxCoeff(), 1e-7);
  }
}

/// Points outside a cage stay, if the map is defined inside.
inline void ExpectOutsideStays(shape::CageCoordinates coordinates)
{
  const shape::Mesh cage = Box({ 0, 0, 0 }, { 1, 1, 1 });
  Eigen::MatrixXd points(4, 3);
  points << 0.5, 0.5, 0.5, 1.1, 0.5, 0.5, 1.0 + 1e-7, 0.5, 0.5, 2000.0, 0.0, 0.0;
  const shape::CageMovedPoints moved =
    MoveByCage(cage, Similarity()(cage.Points), points, WithCoordinates(coordinates, true));
  EXPECT_EQ(moved.OutsideDomain, Eigen::Vector4i(0, 1, 0, 1));
  EXPECT_EQ(moved.Points.row(1), points.row(1));
  EXPECT_EQ(Eigen::RowVectorXd(moved.Gradients.row(1)),
    (Eigen::RowVectorXd(9) << 1, 0, 0, 0, 1, 0, 0, 0, 1).finished());
  EXPECT_LT((moved.Points.row(2) - Similarity()(points.row(2))).norm(), 1e-6);
}

/// Preparation and evaluation report progress and can be stopped.
inline void ExpectReports(shape::CageCoordinates coordinates)
{
  const shape::Mesh cage = Icosphere(2);
  const Eigen::MatrixXd points = PointsAround(cage, 3000, 1.0);
  const auto call = [&](const shape::Progress& progress)
  {
    shape::CageDeformer(
      cage, cage.Points, WithCoordinates(coordinates, true), progress.Part(0.0, 0.5))
      .Evaluate(points, progress.Part(0.5, 1.0));
  };
  EXPECT_GT(shapetest::ExpectProgressRises(call), 5);
  shapetest::ExpectStopsAt(3, call);
}

} // namespace shapetest
