#include "Core/Errors.h"
#include "Correspondence/FunctionalMap.h"
#include "MatchingShapes.h"
#include "Surface/SpectralSignatures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

namespace
{

shape::Mesh Model(const std::string& name)
{
  return shapetest::ReadOff(std::string(SHAPEMAP_MODELS) + "/" + name + ".off");
}

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
  const shape::Mesh mesh = Model("elk");
  const shapetest::Renumbered copy = Copied(mesh);
  const shape::SurfaceMaps maps = shape::FunctionalMap(mesh, copy.Mesh, SomeLandmarks(copy, 3));
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
    shape::FunctionalMap(mesh, copy.Mesh, SomeLandmarks(copy, 12), options);
  const Eigen::VectorXd errors = shapetest::MapErrors(maps.AToB, copy.Mesh, Wanted(copy));
  EXPECT_LT(errors.maxCoeff(), 1e-6);
}

TEST(FitFunctionalMap, OfTheSameDescriptorsIsTheIdentityAndOrientationTellsTheMirrorImage)
{
  const shape::Mesh mesh = Model("elk");
  shape::Mesh unit = mesh;
  unit.Points /= std::sqrt(shape::PointAreas(unit).sum());
  const shape::LaplaceSpectrum spectrum = shape::FindLaplaceSpectrum(unit, 30);
  Eigen::MatrixXd descriptors(unit.Points.rows(), 40);
  descriptors << shape::WaveKernelSignature(spectrum, 20), shape::WaveKernelFrom(spectrum, 5, 20);
  const shape::DescribedSurface surface{ unit, spectrum, descriptors };
  shape::FunctionalMapFitOptions options;
  options.Size = 20;
  const Eigen::MatrixXd map = shape::FitFunctionalMap(surface, surface, options);
  EXPECT_LT((map - Eigen::MatrixXd::Identity(20, 20)).norm(), 0.05);

  // Turned inside out nothing changes but the orientation: the weight alone pulls maps off.
  shape::Mesh reversed = unit;
  reversed.Triangles.col(1).swap(reversed.Triangles.col(2));
  const shape::DescribedSurface turned{ reversed, spectrum, descriptors };
  options.OrientationWeight = 1.0;
  const Eigen::MatrixXd kept = shape::FitFunctionalMap(surface, surface, options),
                        mirrored = shape::FitFunctionalMap(surface, turned, options);
  EXPECT_LT((kept - Eigen::MatrixXd::Identity(20, 20)).norm(), 0.05);
  EXPECT_GT((mirrored - Eigen::MatrixXd::Identity(20, 20)).norm(), 0.5);
}

TEST(FunctionalMap, RefusesSurfacesThatAreNoManifolds)
{
  shape::Mesh fan = shapetest::FlatSquare(3, 0.0);
  const shape::Mesh good = fan;
  fan.Triangles.row(1) = fan.Triangles.row(0);
  EXPECT_THROW(shape::FunctionalMap(fan, good, {}), shape::InvalidInput);
  EXPECT_THROW(shape::FunctionalMap(good, fan, {}), shape::InvalidInput);
}

} // namespace
