#include "Deform/ShapeDeformation.h"
#include "Support/DeformShapes.h"
#include "Support/Deformations.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using Options = shape::DeformOptions;
using shapetest::Bent;
using shapetest::Cap;
using shapetest::DeformWithBentLoop;
using shapetest::LoopOf;

/// How far the points within `radius` of the z axis are from a rigid motion of their rest.
double Bending(const Eigen::MatrixXd& rest, const Eigen::MatrixXd& moved, double radius)
{
  std::vector<int> inner;
  for (int i = 0; i < rest.rows(); ++i)
  {
    if (rest.row(i).head<2>().norm() < radius)
    {
      inner.push_back(i);
    }
  }
  const Eigen::MatrixXd from = rest(inner, Eigen::all).transpose();
  const Eigen::MatrixXd to = moved(inner, Eigen::all).transpose();
  const Eigen::Matrix4d fit = Eigen::umeyama(from, to, false);
  return (to - ((fit.topLeftCorner<3, 3>() * from).colwise() + fit.topRightCorner<3, 1>()))
    .colwise()
    .norm()
    .maxCoeff();
}

} // namespace

TEST(PointParameters, RigidityKeepsTheInsideStiff)
{
  const shape::Mesh cap = Cap(16);
  double before = 1.0;
  for (const double rigidity : { 0.25, 0.5, 1.0, 2.0, 4.0 })
  {
    Options options;
    options.Rigidity = rigidity;
    const double bending = Bending(cap.Points, DeformWithBentLoop(cap, options), 0.5);
    EXPECT_LT(bending, before);
    before = bending;
    // The same, painted.
    shape::DeformFields fields;
    fields.Rigidity = Eigen::VectorXd::Constant(cap.Points.rows(), rigidity);
    EXPECT_EQ(DeformWithBentLoop(cap, {}, fields), DeformWithBentLoop(cap, options));
  }
  EXPECT_LT(before, 0.01);
  // Stiffer inside only.
  before = 1.0;
  for (const double contrast : { 0.3, 1.0, 3.0, 10.0 })
  {
    Options options;
    options.RigidityBy = Options::RigidityByType::Distance;
    options.RigidityContrast = contrast;
    const double bending = Bending(cap.Points, DeformWithBentLoop(cap, options), 0.5);
    EXPECT_LT(bending, before);
    before = bending;
  }
}

TEST(PointParameters, CurvedPartsAbsorbStretchingWhereRigidityIsByCurvature)
{
  shape::Mesh bump = shapetest::FlatDisk(24);
  for (auto row : bump.Points.rowwise())
  {
    const double r = row.head<2>().norm();
    row(2) = 0.5 / (1.0 + std::exp((r - 0.6) / 0.04)); // a plateau, its flank and a brim
  }
  constexpr double stiff = 2.0, contrast = 8.0;
  Options options;
  options.Rigidity = stiff;
  const Eigen::MatrixXd allStiff = DeformWithBentLoop(bump, options);
  options.RigidityBy = Options::RigidityByType::Curvature;
  options.RigidityContrast = contrast;
  const Eigen::MatrixXd byCurvature = DeformWithBentLoop(bump, options);
  options.RigidityBy = Options::RigidityByType::Uniform;
  options.Rigidity = stiff / contrast;
  const Eigen::MatrixXd allSoft = DeformWithBentLoop(bump, options);
  // The flank gives way; the plateau keeps its shape better than it would if all gave way.
  EXPECT_GT(Bending(bump.Points, byCurvature, 0.75), 1.5 * Bending(bump.Points, allStiff, 0.75));
  EXPECT_LT(Bending(bump.Points, byCurvature, 0.45), 0.7 * Bending(bump.Points, allSoft, 0.45));
}

TEST(PointParameters, ScaleAndInnerScaleGrowTheShape)
{
  const shape::Mesh cap = Cap(16);
  const auto heightAt = [&](double scale, double inner, const shape::DeformFields& fields = {})
  {
    Options options;
    options.Scale = scale;
    options.InnerScale = inner;
    const shape::BoundaryHandle loop = LoopOf(cap);
    const Eigen::MatrixXd moved =
      shape::ShapeDeformation(shape::BuildPointGraph(cap), loop, options, fields)
        .Deform(shape::GetRestPose(loop))
        .Points;
    return moved.col(2).maxCoeff();
  };
  double before = 0.0, innerBefore = 0.0;
  for (const double scale : { 0.5, 0.8, 1.0, 1.3, 2.0 })
  {
    EXPECT_GT(heightAt(scale, 1.0), before);
    EXPECT_GT(heightAt(1.0, scale), innerBefore);
    before = heightAt(scale, 1.0);
    innerBefore = heightAt(1.0, scale);
    shape::DeformFields fields;
    fields.Scale = Eigen::VectorXd::Constant(cap.Points.rows(), scale);
    EXPECT_NEAR(heightAt(1.0, 1.0, fields), before, 1e-12);
  }
  EXPECT_NEAR(heightAt(1.0, 1.0), cap.Points.col(2).maxCoeff(), 1e-15);
}

TEST(PointParameters, ALargerUpwindRadiusDrawsTheShapeToTheHandle)
{
  // The rim is stretched, and the shape keeps its size: how high it stays is what the radius tells.
  const shape::Mesh cap = Cap(20);
  const shape::BoundaryHandle loop = LoopOf(cap);
  Eigen::MatrixXd target = loop.Positions;
  target.col(0) *= 1.5;
  double before = 10.0;
  for (const double radius : { 1.2, 2.1, 4.0, 8.0 })
  {
    Options options;
    options.UpwindRadius = radius;
    const double height = shape::ShapeDeformation(shape::BuildPointGraph(cap), loop, options)
                            .Deform(shape::PoseHandle(loop, target))
                            .Points.col(2)
                            .mean();
    EXPECT_LT(height, before) << radius;
    before = height;
  }
}
