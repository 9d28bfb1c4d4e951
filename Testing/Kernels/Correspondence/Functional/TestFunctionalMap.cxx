#include "Base/Errors.h"
#include "Correspondence/Evaluate/SurfaceMapFacts.h"
#include "Correspondence/Functional/FunctionalMap.h"
#include "Correspondence/Functional/HeatKernelMap.h"
#include "Correspondence/Functional/PartialFunctionalMap.h"
#include "Correspondence/Pair/SurfacePart.h"
#include "Spectrum/SpectralSignatures.h"
#include "Support/MatchingShapes.h"
#include "Support/SimpleSurfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

using shapetest::ReadModel;

/// A surface in another pose and size, with other numbers of points.
shapetest::Renumbered Copied(const shape::Mesh& mesh)
{
  shapetest::Renumbered copy = shapetest::Renumber(mesh, 3);
  copy.Mesh.Points =
    3.0 * copy.Mesh.Points * shapetest::Rotation(1.1, { 1.0, 2.0, -0.5 }).transpose();
  return copy;
}

shape::Landmarks SomeLandmarks(const shapetest::Renumbered& copy, int count)
{
  shape::Landmarks landmarks;
  for (int i = 0; i < count; ++i)
  {
    const int point = (i * 2 + 1) * static_cast<int>(copy.NewOf.size()) / (2 * count);
    landmarks.push_back({ point, copy.NewOf(point) });
  }
  return landmarks;
}

/// Where the copies of a surface's points are.
Eigen::MatrixXd Wanted(const shapetest::Renumbered& copy)
{
  return copy.Mesh.Points(copy.NewOf, Eigen::all);
}

TEST(FunctionalMap, FindsACopyBothWaysWhateverItsPoseSizeAndNumbers)
{
  const shape::Mesh mesh = ReadModel("elk");
  const shapetest::Renumbered copy = Copied(mesh);
  const shape::SurfaceMaps maps =
    shape::ComputeFunctionalMap(mesh, copy.Mesh, SomeLandmarks(copy, 3));
  EXPECT_LT(shapetest::MapErrors(maps.AToB, copy.Mesh, Wanted(copy)).mean(), 1e-6);
  Eigen::MatrixXd back(mesh.Points.rows(), 3);
  back(copy.NewOf, Eigen::all) = mesh.Points;
  EXPECT_LT(shapetest::MapErrors(maps.BToA, mesh, back).mean(), 1e-6);
}

TEST(FunctionalMap, OfSurfacesWithBorderAndSeveralComponents)
{
  // A square plate beside a bumpy sphere.
  shape::Mesh mesh = shapetest::BumpySphere(3, Eigen::Matrix3d::Identity());
  const shape::Mesh plate = shapetest::FlatSquare(14, 0.2);
  const Eigen::Index points = mesh.Points.rows(), triangles = mesh.Triangles.rows();
  mesh.Points.conservativeResize(points + plate.Points.rows(), 3);
  mesh.Points.bottomRows(plate.Points.rows()) = plate.Points.array() + 4.0;
  mesh.Triangles.conservativeResize(triangles + plate.Triangles.rows(), 3);
  mesh.Triangles.bottomRows(plate.Triangles.rows()) =
    plate.Triangles.array() + static_cast<int>(points);
  const shapetest::Renumbered copy = Copied(mesh);
  shape::FunctionalMapOptions options;
  options.Refinement.Last = 60;
  const shape::SurfaceMaps maps =
    shape::ComputeFunctionalMap(mesh, copy.Mesh, SomeLandmarks(copy, 12), options);
  const Eigen::VectorXd errors = shapetest::MapErrors(maps.AToB, copy.Mesh, Wanted(copy));
  EXPECT_LT(errors.maxCoeff(), 1e-6);
}

TEST(FitFunctionalMap, OfTheSameDescriptorsIsTheIdentityAndOrientationTellsTheMirrorImage)
{
  const shape::Mesh mesh = ReadModel("elk");
  shape::Mesh unit = mesh;
  unit.Points /= std::sqrt(shape::ComputePointAreas(unit).sum());
  const shape::LaplaceEigenpairs spectrum = shape::SolveLaplaceEigenproblem(unit, 30);
  Eigen::MatrixXd descriptors(unit.Points.rows(), 40);
  descriptors << shape::ComputeWaveKernelSignature(spectrum, 20),
    shape::ComputeWaveKernelFrom(spectrum, 5, 20);
  const shape::SurfaceDescriptors surface{ unit, spectrum, descriptors };
  shape::FunctionalMapFitOptions options;
  options.Size = 20;
  const Eigen::MatrixXd map = shape::FitFunctionalMap(surface, surface, options);
  EXPECT_LT((map - Eigen::MatrixXd::Identity(20, 20)).norm(), 0.05);

  // Turned inside out nothing changes but the orientation: the weight alone pulls maps off.
  shape::Mesh reversed = unit;
  reversed.Triangles.col(1).swap(reversed.Triangles.col(2));
  const shape::SurfaceDescriptors turned{ reversed, spectrum, descriptors };
  options.OrientationWeight = 1.0;
  const Eigen::MatrixXd kept = shape::FitFunctionalMap(surface, surface, options),
                        mirrored = shape::FitFunctionalMap(surface, turned, options);
  EXPECT_LT((kept - Eigen::MatrixXd::Identity(20, 20)).norm(), 0.05);
  EXPECT_GT((mirrored - Eigen::MatrixXd::Identity(20, 20)).norm(), 0.5);
}

/// A part of a bumpy sphere, and all of it three times as large, in other triangles.
struct PartAndWhole
{
  shapetest::Cut Part =
    shapetest::Above(shapetest::BumpySphere(4, Eigen::Matrix3d::Identity()), -0.2);
  shape::Mesh Whole = shapetest::BumpySphere(4, shapetest::Rotation(0.7, { 3.0, -1.0, 1.0 }));
  Eigen::Matrix3d Pose = 3.0 * shapetest::Rotation(1.1, { 1.0, 2.0, -0.5 });
  shape::Landmarks Pairs;

  PartAndWhole()
  {
    this->Whole.Points = this->Whole.Points * this->Pose.transpose();
    const Eigen::MatrixXd wanted = this->Wanted();
    for (Eigen::Index i = 0; i < wanted.rows(); i += wanted.rows() / 6)
    {
      Eigen::Index nearest = 0;
      (this->Whole.Points.rowwise() - wanted.row(i)).rowwise().squaredNorm().minCoeff(&nearest);
      this->Pairs.push_back({ static_cast<int>(i), static_cast<int>(nearest) });
    }
  }

  Eigen::MatrixXd Wanted() const { return this->Part.Surface.Points * this->Pose.transpose(); }
  double Share() const
  {
    return 9.0 * shape::ComputePointAreas(this->Part.Surface).sum() /
      shape::ComputePointAreas(this->Whole).sum();
  }
};

TEST(SurfacePart, IsFoundWithItsScaleByTheLandmarksWhicheverSurfaceItIs)
{
  using Which = shape::SurfacePart::WhichType;
  const PartAndWhole pair;
  ASSERT_LT(pair.Share(), 0.8);
  const shape::SurfacePart found = shape::FindPart(pair.Part.Surface, pair.Whole, pair.Pairs);
  EXPECT_EQ(found.Which, Which::SurfaceA);
  EXPECT_NEAR(found.Scale, 3.0, 0.1);
  EXPECT_NEAR(found.Share, pair.Share(), 0.07 * pair.Share());

  shape::Landmarks turned;
  for (const auto& [a, b] : pair.Pairs)
  {
    turned.push_back({ b, a });
  }
  const shape::SurfacePart other = shape::FindPart(pair.Whole, pair.Part.Surface, turned);
  EXPECT_EQ(other.Which, Which::SurfaceB);
  EXPECT_NEAR(other.Scale * found.Scale, 1.0, 1e-12);
  EXPECT_NEAR(other.Share, found.Share, 1e-12);

  // A surface with a border is no part of itself, however large its copy is.
  shape::Mesh copy = pair.Part.Surface;
  copy.Points *= 5.0;
  const shape::SurfacePart same =
    shape::FindPart(pair.Part.Surface, copy, { { 0, 0 }, { 90, 90 }, { 400, 400 }, { 900, 900 } });
  EXPECT_EQ(same.Which, Which::None);
  EXPECT_NEAR(same.Scale, 5.0, 1e-9);
  EXPECT_THROW(shape::MeasurePart(pair.Part.Surface, pair.Whole, pair.Pairs, Which::SurfaceB),
    shape::InvalidInput);
}

TEST(PartialFunctionalMap, FindsAPartInTheWholeAndWhatOfThatHasAPartner)
{
  const PartAndWhole pair;
  const shape::SurfaceMaps maps =
    shape::ComputePartialFunctionalMap(pair.Part.Surface, pair.Whole, pair.Pairs, 3.0);
  const double length = std::sqrt(shape::ComputePointAreas(pair.Whole).sum());
  const Eigen::VectorXd errors = shapetest::MapErrors(maps.AToB, pair.Whole, pair.Wanted());
  EXPECT_LT(errors.mean() / length, 0.01);
  // Each of both taken with its own area as 1 the part is spread over the whole.
  const shape::SurfaceMaps spread =
    shape::ComputeFunctionalMap(pair.Part.Surface, pair.Whole, pair.Pairs);
  EXPECT_GT(
    shapetest::MapErrors(spread.AToB, pair.Whole, pair.Wanted()).mean(), 5.0 * errors.mean());

  const shape::SurfaceMapFacts facts = shape::EvaluateMaps(pair.Part.Surface, pair.Whole, maps);
  EXPECT_GT(facts.CoverageOfA, 0.95);
  EXPECT_NEAR(facts.CoverageOfB, pair.Share(), 0.04);
  EXPECT_NEAR(facts.DirichletEnergy, pair.Share(), 0.1);
  EXPECT_LT(facts.ReversedArea, 0.05);

  EXPECT_THROW(shape::ComputePartialFunctionalMap(
                 pair.Part.Surface, pair.Whole, { pair.Pairs[0], pair.Pairs[1] }, 3.0),
    shape::InvalidInput);
}

TEST(HeatKernelMap, FindsAPartInTheWhole)
{
  const PartAndWhole pair;
  const double length = std::sqrt(shape::ComputePointAreas(pair.Whole).sum());
  const auto error = [&](const shape::SurfaceMaps& maps)
  { return shapetest::MapErrors(maps.AToB, pair.Whole, pair.Wanted()).mean() / length; };
  const shape::SurfaceMaps maps =
    shape::ComputePartialHeatKernelMap(pair.Part.Surface, pair.Whole, pair.Pairs, 3.0);
  // Each of both taken with its own area as 1, and heat compared over all of it, far parts differ.
  const shape::SurfaceMaps spread =
    shape::ComputeHeatKernelMap(pair.Part.Surface, pair.Whole, pair.Pairs);
  EXPECT_LT(error(maps), error(spread));
  EXPECT_LT(error(maps), 0.01);
  // The unit does not count.
  shape::Mesh large = pair.Part.Surface;
  large.Points *= 5.0;
  const shape::SurfaceMaps scaled =
    shape::ComputePartialHeatKernelMap(large, pair.Whole, pair.Pairs, 0.6);
  EXPECT_LT((shapetest::PositionsOn(scaled.AToB, pair.Whole) -
              shapetest::PositionsOn(maps.AToB, pair.Whole))
              .cwiseAbs()
              .maxCoeff(),
    1e-6 * length);
  EXPECT_THROW(shape::ComputePartialHeatKernelMap(
                 shapetest::Twice(pair.Part.Surface), pair.Whole, pair.Pairs, 3.0),
    shape::InvalidInput);
}

TEST(FunctionalMap, RefusesSurfacesThatAreNoManifolds)
{
  shape::Mesh fan = shapetest::FlatSquare(3, 0.0);
  const shape::Mesh good = fan;
  fan.Triangles.row(1) = fan.Triangles.row(0);
  EXPECT_THROW(shape::ComputeFunctionalMap(fan, good, {}), shape::InvalidInput);
  EXPECT_THROW(shape::ComputeFunctionalMap(good, fan, {}), shape::InvalidInput);
}

} // namespace
