// Facts checked: a feature set down where it was cut is in its old place; anywhere else the result
// is a closed manifold with the Euler number that gluing gives, and meets the target smoothly; on a
// plane, turning and scaling are a similarity; what does not fit is refused with the reason and
// with a scale that does fit.

#include "Base/Errors.h"
#include "CutPaste/CutFeature.h"
#include "CutPaste/PasteFeature.h"
#include "Deform/Deform.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/Refusals.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace
{

/// A part of a surface, deformed, and how it stood on the surface.
struct Cut
{
  shape::Mesh Whole; ///< the surface with the feature where it was
  shape::Mesh Feature;
  std::vector<int> Points; ///< of the feature: the points of the surface
  shape::FeatureFootprint Base;
};

/// Cuts out the triangles whose corners are all within `radius` (along the chord) of the seed,
/// their points moved by `bump`.
Cut CutOut(const shape::Mesh& base, const Eigen::RowVector3d& seed, double radius,
  const std::function<Eigen::RowVector3d(const Eigen::RowVector3d&)>& bump)
{
  Cut cut{ base, {}, {}, {} };
  std::vector<int> number(base.Points.rows(), -1);
  std::vector<int> triangles;
  for (int t = 0; t < static_cast<int>(base.Triangles.rows()); ++t)
  {
    if (((shape::GetCorners(base, t).rowwise() - seed).rowwise().norm().array() < radius).all())
    {
      triangles.push_back(t);
      for (const int corner : base.Triangles.row(t))
      {
        if (number[corner] < 0)
        {
          number[corner] = static_cast<int>(cut.Points.size());
          cut.Points.push_back(corner);
        }
      }
    }
  }
  for (const int point : cut.Points)
  {
    cut.Whole.Points.row(point) = bump(base.Points.row(point));
  }
  cut.Feature.Points = cut.Whole.Points(cut.Points, Eigen::all);
  cut.Feature.Triangles = Eigen::MatrixXi(base.Triangles(triangles, Eigen::all))
                            .unaryExpr([&](int i) { return number[i]; });
  cut.Base.Loop = shape::FindManifoldBoundaryLoops(cut.Feature)[0];

  shape::ExponentialMap map(base);
  const shape::ExponentialPatch patch = map.Around(seed, 3.0 * radius);
  cut.Base.Normal = patch.Seed.Normal;
  cut.Base.XAxis = patch.Seed.XAxis;
  const auto size = static_cast<Eigen::Index>(cut.Base.Loop.size());
  cut.Base.LoopPositions.resize(size, 2);
  cut.Base.Normals.resize(size, 3);
  const Eigen::MatrixXd normals = shape::ComputeVertexNormals(base, shape::NormalWeight::Angle);
  for (Eigen::Index i = 0; i < size; ++i)
  {
    const int point = cut.Points[cut.Base.Loop[i]];
    const auto row = std::find(patch.Points.begin(), patch.Points.end(), point);
    cut.Base.LoopPositions.row(i) = patch.Positions.row(row - patch.Points.begin());
    cut.Base.Normals.row(i) = normals.row(point);
  }
  return cut;
}

/// A bump on the unit sphere around a direction, smooth and without effect beyond a chord of 0.5.
Eigen::RowVector3d Horn(const Eigen::RowVector3d& position, const Eigen::RowVector3d& axis)
{
  const double share = (position - axis).squaredNorm() / 0.25;
  const double height = share < 1.0 ? std::pow(1.0 - share, 3) : 0.0;
  return position * (1.0 + 0.8 * height) + 0.2 * height * Eigen::RowVector3d(0.0, 1.0, 0.0);
}

Cut HornOfSphere(int level)
{
  const Eigen::RowVector3d axis(0.0, 0.0, 1.0);
  return CutOut(shapetest::Icosphere(level), axis, 0.6,
    [&](const Eigen::RowVector3d& position) { return Horn(position, axis); });
}

/// A bump on the square [-1, 1]^2.
Cut BumpOfSquare()
{
  return CutOut(shapetest::FlatSquare(40, 0.2), Eigen::RowVector3d(0.1, 0.0, 0.0), 0.4,
    [](const Eigen::RowVector3d& position)
    {
      const double share = (position - Eigen::RowVector3d(0.1, 0.0, 0.0)).squaredNorm() / 0.12;
      return position +
        (share < 1.0 ? std::pow(1.0 - share, 3) : 0.0) * Eigen::RowVector3d(0.1, 0.05, 0.4);
    });
}

/// The points of the result that are the feature's.
Eigen::MatrixXd FeaturePoints(const shape::PastedFeature& pasted)
{
  const Eigen::VectorXi& points = pasted.Feature.Points;
  const auto first = std::find(points.begin(), points.end(), 0) - points.begin();
  return pasted.Surface.Points.middleRows(first, points.maxCoeff() + 1);
}

/// Painted rigidity and scale, and two segments.
shape::DeformFields Painted(const Eigen::MatrixXd& points)
{
  shape::DeformFields fields;
  fields.Rigidity = 1.0 + points.col(0).array().square();
  fields.Scale = 1.0 + 0.3 * (4.0 * points.col(1).array()).sin();
  fields.Segments = (points.col(2).array() > 1.2).cast<int>();
  return fields;
}

TEST(PasteFeature, FieldsAndBiasActAsInDeform)
{
  const Cut cut = HornOfSphere(5);
  const shape::Mesh sphere = shapetest::Icosphere(5);
  shape::PasteTarget target(sphere);
  const shape::DeformFields fields = Painted(cut.Feature.Points);
  for (const bool smooth : { false, true })
  {
    shape::DeformProblem problem;
    problem.Shape.Points = cut.Feature.Points;
    problem.Shape.Triangles = cut.Feature.Triangles;
    problem.Fields = fields;
    problem.Options.RigidityBy = shape::DeformOptions::RigidityByType::Distance;
    problem.Options.LaplacianSmoothing = smooth;
    problem.Options.Multiresolution = shape::DeformOptions::MultiresolutionType::Off;
    shape::PasteFeatureOptions options;
    options.OptimizeNormals = false;
    options.Frames.BiasFrame = { 0.0, 1.0, 0.3 };
    options.Frames.BiasWeight = 0.4;
    shape::PastePlacement position;
    position.Seed << 0.3, -0.5, 0.7;
    position.Rotation = 20.0;
    const shape::PastedFeature pasted =
      shape::FeatureToPaste(cut.Feature, cut.Base, problem.Options, fields)
        .PasteOn(target, position, options);

    Eigen::MatrixXd loop = cut.Feature.Points(cut.Base.Loop, Eigen::all);
    problem.Handle = shape::BuildCurveHandle(loop, true, cut.Base.Normals);
    const shape::DeformedShape deformed = shape::Deformer().Deform(
      problem, { pasted.Landings[0].Positions, pasted.Landings[0].Normals, {} }, options.Frames);
    EXPECT_LT((FeaturePoints(pasted) - deformed.Points).cwiseAbs().maxCoeff(), 1e-12);

    // Each of them changes the result.
    const auto pasteWith = [&](const shape::DeformFields& other, double bias)
    {
      shape::PasteFeatureOptions without = options;
      without.Frames.BiasWeight = bias;
      return FeaturePoints(shape::FeatureToPaste(cut.Feature, cut.Base, problem.Options, other)
                             .PasteOn(target, position, without));
    };
    EXPECT_GT(
      (pasteWith({ {}, fields.Scale, fields.Segments }, 0.4) - deformed.Points).norm(), 1e-3);
    EXPECT_GT(
      (pasteWith({ fields.Rigidity, {}, fields.Segments }, 0.4) - deformed.Points).norm(), 1e-3);
    EXPECT_GT(
      (pasteWith({ fields.Rigidity, fields.Scale, {} }, 0.4) - deformed.Points).norm(), 1e-3);
    EXPECT_GT((pasteWith(fields, 0.0) - deformed.Points).norm(), 1e-3);
  }
}

TEST(PasteFeature, TheFeatureLeansTowardsTheBiasAlsoWithASmoothSeam)
{
  const Cut cut = HornOfSphere(5);
  shape::PasteTarget target(shapetest::Icosphere(5));
  const shape::FeatureToPaste feature(cut.Feature, cut.Base);
  shape::PastePlacement position;
  position.Seed << 0.0, 0.0, 1.0;
  const Eigen::RowVector3d direction(1.0, 0.0, 0.0);
  double before = -1e300;
  for (const double weight : { 0.0, 0.2, 0.4 })
  {
    shape::PasteFeatureOptions options;
    options.Frames = { { 1.0, 0.0, 0.0 }, weight };
    const Eigen::MatrixXd points = FeaturePoints(feature.PasteOn(target, position, options));
    const double reach = points.rows() * points.colwise().mean().dot(direction);
    EXPECT_GT(reach, before);
    before = reach + 0.01;
  }
}

TEST(PasteFeature, DroppedInPlaceNothingHasMoved)
{
  for (const Cut& cut : { HornOfSphere(5), BumpOfSquare() })
  {
    const bool isSphere = cut.Whole.Points.col(2).minCoeff() < -0.9;
    const shape::Mesh base = isSphere ? shapetest::Icosphere(5) : shapetest::FlatSquare(40, 0.2);
    shape::PasteTarget target(base);
    const shape::FeatureToPaste feature(cut.Feature, cut.Base);
    shape::PastePlacement position;
    position.Seed =
      isSphere ? Eigen::RowVector3d(0.0, 0.0, 1.0) : Eigen::RowVector3d(0.1, 0.0, 0.0);
    const shape::PastedFeature pasted = feature.PasteOn(target, position);
    EXPECT_EQ(pasted.BandTriangles, 0);
    EXPECT_EQ(pasted.Surface.Points.rows(), base.Points.rows());
    EXPECT_EQ(pasted.Surface.Triangles.rows(), base.Triangles.rows());
    EXPECT_LT((FeaturePoints(pasted) - cut.Feature.Points).cwiseAbs().maxCoeff(),
      1e-12 * shape::ComputeBoxDiagonal(base.Points));
    EXPECT_EQ(shape::ComputeTopology(pasted.Surface).EulerNumber, isSphere ? 2 : 1);
  }
}

/// Cuts out the triangles of a closed surface that a function chooses.
shape::CutFeatureResult CutWhere(
  const shape::Mesh& surface, const std::function<bool(const Eigen::RowVector3d&)>& isFeature)
{
  std::vector<char> selected;
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    selected.push_back(isFeature(shape::GetCorners(surface, t).colwise().mean()) ? 1 : 0);
  }
  return shape::CutFeature(surface, selected);
}

/// One half of a torus, cut out: a tube with two loops.
shape::CutFeatureResult HalfOfTorus()
{
  return CutWhere(shapetest::Torus(3.0, 1.0, 60, 24),
    [](const Eigen::RowVector3d& centre) { return centre.x() > 0.0; });
}

/// The largest distance of a point of one surface from the nearest point of the other.
double FarthestFromPoints(const shape::Mesh& a, const shape::Mesh& b)
{
  double farthest = 0.0;
  for (const auto& point : a.Points.rowwise())
  {
    farthest = std::max(farthest, (b.Points.rowwise() - point).rowwise().squaredNorm().minCoeff());
  }
  return std::sqrt(farthest);
}

TEST(PasteFeature, SeveralLoopsDroppedInPlaceGiveTheOriginal)
{
  // A tube closes a torus; pants join three caps of a sphere, which are components of their own.
  const shape::Mesh torus = shapetest::Torus(3.0, 1.0, 60, 24), sphere = shapetest::Icosphere(4);
  const shape::CutFeatureResult pants = CutWhere(sphere,
    [](const Eigen::RowVector3d& centre) { return centre.maxCoeff() < 0.8 * centre.norm(); });
  for (const auto& [whole, cut] : { std::pair(torus, HalfOfTorus()), std::pair(sphere, pants) })
  {
    const bool isTorus = whole.Points.rows() == torus.Points.rows();
    ASSERT_EQ(cut.Bases.size(), isTorus ? 2U : 3U);
    const shape::Topology rest = shape::RequireClosedSurface(cut.Rest.Surface, "the rest");
    EXPECT_EQ(rest.EulerNumber, isTorus ? 2 : 6);
    shape::PasteTarget target(cut.Rest.Surface);
    shape::PastePlacement placement;
    placement.Seed = cut.Bases[0].Origin;
    const shape::PastedFeature back =
      shape::FeatureToPaste(cut.Feature.Surface, cut.Bases).PasteOn(target, placement);
    EXPECT_EQ(back.BandTriangles, 0);
    EXPECT_EQ(back.Surface.Points.rows(), whole.Points.rows());
    EXPECT_EQ(back.Surface.Triangles.rows(), whole.Triangles.rows());
    const double tolerance = 1e-12 * shape::ComputeBoxDiagonal(whole.Points);
    EXPECT_LT(FarthestFromPoints(back.Surface, whole), tolerance);
    EXPECT_LT(FarthestFromPoints(whole, back.Surface), tolerance);
    const shape::Topology topology = shape::RequireClosedSurface(back.Surface, "the result");
    EXPECT_EQ(topology.EulerNumber, isTorus ? 0 : 2);
    EXPECT_EQ(topology.Components, 1);
    EXPECT_EQ(back.EulerNumber, topology.EulerNumber);
  }
}

TEST(PasteFeature, ATubeWithTwoLoopsIsAHandleOfTheTarget)
{
  const shape::CutFeatureResult cut = HalfOfTorus();
  const shape::FeatureToPaste tube(cut.Feature.Surface, cut.Bases);
  shape::Mesh sphere = shapetest::Icosphere(5);
  sphere.Points *= 9.0;
  shape::PasteTarget target(sphere);
  for (const double rotation : { 0.0, 70.0 })
  {
    shape::PastePlacement placement{ { 1.0, 2.0, -9.0 }, rotation, 0.8 };
    const shape::PastedFeature pasted = tube.PasteOn(target, placement);
    const shape::Topology topology = shape::RequireClosedSurface(pasted.Surface, "the result");
    EXPECT_EQ(topology.EulerNumber, 0); // genus 1
    EXPECT_EQ(topology.Components, 1);
    ASSERT_EQ(pasted.Landings.size(), 2U);
    // The loops are as far apart as on the torus, up to the curvature of both surfaces.
    const double apart = (pasted.Landings[0].Seed.Origin - pasted.Landings[1].Seed.Origin).norm();
    EXPECT_NEAR(apart, 0.8 * (cut.Bases[0].Origin - cut.Bases[1].Origin).norm(), 1.0);
  }
}

TEST(PasteFeature, LoopsThatDoNotAllFitAreRefused)
{
  const shape::CutFeatureResult cut = HalfOfTorus();
  const shape::FeatureToPaste tube(cut.Feature.Surface, cut.Bases);
  // One loop fits on the square, but not two.
  shape::Mesh square = shapetest::FlatSquare(40, 0.0);
  square.Points *= 2.5;
  shape::PasteTarget target(square);
  const std::string words = shapetest::Refusal([&] { tube.PasteOn(target, {}); });
  EXPECT_NE(words.find("at the loop with index 1 of 2"), std::string::npos) << words;
  EXPECT_NE(words.find("move Seed"), std::string::npos) << words;
  shape::FeatureToPaste(cut.Feature.Surface, cut.Bases[0]).PasteOn(target, {});
  // Both loops at one position.
  std::vector<shape::FeatureFootprint> same = cut.Bases;
  same[1].Origin = same[0].Origin;
  shape::Mesh plane = shapetest::FlatSquare(60, 0.0);
  plane.Points *= 10.0;
  shape::PasteTarget wide(plane);
  EXPECT_REFUSED(shape::FeatureToPaste(cut.Feature.Surface, same).PasteOn(wide, {}),
    "touches that of another loop, at any Scale down to 0.00390625; move Seed, or refine");
  shape::SoupTarget soup(plane);
  EXPECT_REFUSED(tube.PasteOn(soup, {}), "set Loops to One");
}

TEST(PasteFeature, AnywhereElseTheResultIsAClosedManifold)
{
  const Cut cut = HornOfSphere(4);
  const shape::FeatureToPaste feature(cut.Feature, cut.Base);
  // A torus has Euler number 0, and keeps it.
  for (const bool torus : { false, true })
  {
    const shape::Mesh base = torus ? shapetest::Torus(3.0, 1.2, 90, 40) : shapetest::Icosphere(5);
    shape::PasteTarget target(base);
    for (int i = 0; i < 6; ++i)
    {
      shape::PastePlacement position;
      position.Seed = 4.0 * Eigen::RowVector3d::Random();
      position.Rotation = 50.0 * i;
      position.Scale = 0.6 + 0.1 * i;
      const shape::PastedFeature pasted = feature.PasteOn(target, position);
      const shape::Topology topology = shape::RequireClosedSurface(pasted.Surface, "the result");
      EXPECT_EQ(topology.EulerNumber, torus ? 0 : 2);
      EXPECT_EQ(topology.Components, 1);
      EXPECT_TRUE(pasted.Surface.Points.allFinite());
      EXPECT_LT(shape::ComputePercentile(pasted.AnglesAfter, 0.5), 3.0);
      EXPECT_LT(shape::ComputePercentile(pasted.AnglesAfter, 0.95), 10.0);
      EXPECT_GT(pasted.BandTriangles, 0);
      // Of the target, what is not covered is as it was.
      for (Eigen::Index p = 0; p < pasted.Target.Points.size(); ++p)
      {
        const int original = pasted.Target.Points(p);
        if (original >= 0)
        {
          ASSERT_EQ(pasted.Surface.Points.row(p), base.Points.row(original));
        }
      }
      const Eigen::VectorXd sums =
        pasted.Target.Weights * Eigen::VectorXd::Ones(pasted.Target.Weights.cols()) +
        pasted.Feature.Weights * Eigen::VectorXd::Ones(pasted.Feature.Weights.cols());
      EXPECT_TRUE((sums.array() == 1.0).all());
    }
  }
}

TEST(PasteFeature, OnAPlaneTurningAndScalingAreASimilarity)
{
  const Cut cut = BumpOfSquare();
  const shape::FeatureToPaste feature(cut.Feature, cut.Base);
  shape::Mesh wide = shapetest::FlatSquare(60, 0.3);
  wide.Points *= 4.0;
  wide.Points.col(2).setConstant(7.0);
  shape::PasteTarget target(wide);
  shape::PastePlacement position;
  position.Seed << 0.7, -0.4, 7.5;
  position.Rotation = 35.0;
  position.Scale = 1.7;
  const shape::PastedFeature pasted = feature.PasteOn(target, position);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(35.0 * M_PI / 180.0, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::MatrixXd wanted =
    (1.7 * (cut.Feature.Points.rowwise() - Eigen::RowVector3d(0.1, 0.0, 0.0)) * turn.transpose())
      .rowwise() +
    Eigen::RowVector3d(0.7, -0.4, 7.0);
  EXPECT_LT((FeaturePoints(pasted) - wanted).cwiseAbs().maxCoeff(), 1e-10);
}

TEST(PasteFeature, ASphereTakesItAnywhereAsItWas)
{
  // The same place but for a rotation: the result turns with it, within the mesh's resolution.
  const Cut cut = HornOfSphere(5);
  const shape::FeatureToPaste feature(cut.Feature, cut.Base);
  shape::PasteTarget target(shapetest::Icosphere(5));
  shape::PastePlacement position;
  position.Seed = Eigen::RowVector3d(1.0, 0.5, -0.3).normalized();
  const shape::PastedFeature pasted = feature.PasteOn(target, position);
  const Eigen::Matrix3d turn =
    Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), position.Seed.transpose())
      .toRotationMatrix();
  EXPECT_LT(
    (FeaturePoints(pasted) - cut.Feature.Points * turn.transpose()).rowwise().norm().maxCoeff(),
    0.02);
}

TEST(PasteFeature, DraggingIsNearToTheFullResult)
{
  const Cut cut = HornOfSphere(5);
  const shape::FeatureToPaste feature(cut.Feature, cut.Base);
  shape::PasteTarget target(shapetest::Torus(3.0, 1.5, 90, 40));
  shape::PastePlacement position;
  position.Seed << 4.0, 1.0, 0.5;
  shape::PasteFeatureOptions dragging;
  dragging.Dragging = true;
  const shape::PastedFeature quick = feature.PasteOn(target, position, dragging);
  const shape::PastedFeature full = feature.PasteOn(target, position);
  ASSERT_EQ(quick.Surface.Triangles, full.Surface.Triangles);
  EXPECT_LT((quick.Surface.Points - full.Surface.Points).rowwise().norm().maxCoeff(), 0.1);
  for (const shape::PastedFeature& pasted : { quick, full })
  {
    EXPECT_GT(shape::ComputePercentile(pasted.AnglesBefore, 0.5), 9.0);
    EXPECT_LT(shape::ComputePercentile(pasted.AnglesAfter, 0.5),
      shape::ComputePercentile(pasted.AnglesBefore, 0.5) / 3.0);
    EXPECT_LT(shape::ComputePercentile(pasted.AnglesAfter, 0.95),
      shape::ComputePercentile(pasted.AnglesBefore, 0.95) / 3.0);
  }
  EXPECT_LT(shape::ComputePercentile(full.AnglesAfter, 0.5), 3.0);
}

TEST(PasteFeature, WhatDoesNotFitIsRefusedWithAScaleThatDoes)
{
  const Cut cut = BumpOfSquare();
  const shape::FeatureToPaste feature(cut.Feature, cut.Base);
  shape::PasteTarget target(shapetest::FlatSquare(40, 0.2));
  shape::PastePlacement position;
  position.Seed << 0.8, 0.0, 0.0;
  const std::string loop = shapetest::Refusal([&] { feature.PasteOn(target, position); });
  EXPECT_NE(loop.find("beyond the boundary"), std::string::npos) << loop;
  const auto at = loop.find("Scale to ");
  ASSERT_NE(at, std::string::npos) << loop;
  position.Scale = std::stod(loop.substr(at + 9));
  EXPECT_GT(position.Scale, 0.3);
  EXPECT_LT(position.Scale, 1.0);
  feature.PasteOn(target, position);

  shape::PasteTarget small(shapetest::Icosphere(4));
  const Cut horn = HornOfSphere(4);
  const shape::FeatureToPaste large(horn.Feature, horn.Base);
  shape::PastePlacement huge;
  huge.Seed << 1.0, 0.0, 0.0;
  huge.Scale = 8.0;
  EXPECT_REFUSED(large.PasteOn(small, huge), "Scale");
  huge.Scale = 0.0;
  EXPECT_REFUSED(large.PasteOn(small, huge), "positive");

  shape::FeatureFootprint wrong = cut.Base;
  wrong.LoopPositions.row(3).swap(wrong.LoopPositions.row(20));
  EXPECT_REFUSED(shape::FeatureToPaste(cut.Feature, wrong), "crosses");
}

} // namespace
