#include "Hex/RegionRemesh.h"

#include "Base/Errors.h"
#include "Hex/Features/RegionNetwork.h"
#include "Mesh/QuadSurface.h"
#include "Quality/ScaledJacobian.h"
#include "Search/ClosestPoint.h"
#include "Support/Refusals.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace
{

using Rule = std::function<int(const Eigen::RowVector3d& position)>;

/// The faces between unit cubes with different labels, whose centres have half-integers.
shape::LabelledSurfaces Blocks(const std::array<int, 3>& size, const Rule& rule)
{
  const auto labelAt = [&](const Eigen::Array3i& cell)
  {
    const bool isInside =
      (cell >= 0).all() && cell(0) < size[0] && cell(1) < size[1] && cell(2) < size[2];
    return isInside ? rule((cell.cast<double>() + 0.5).matrix().transpose()) : 0;
  };
  std::map<std::array<int, 3>, int> pointOf;
  std::vector<Eigen::RowVector3i> triangles;
  std::vector<Eigen::RowVector2i> labels;
  for (int z = -1; z < size[2]; ++z)
  {
    for (int y = -1; y < size[1]; ++y)
    {
      for (int x = -1; x < size[0]; ++x)
      {
        for (int axis = 0; axis < 3; ++axis)
        {
          const Eigen::Array3i cell(x, y, z), step = Eigen::Matrix3i::Identity().col(axis);
          const int here = labelAt(cell), next = labelAt(cell + step);
          if (here == next)
          {
            continue;
          }
          // Counter-clockwise seen from the next cell.
          const Eigen::Array3i u = Eigen::Matrix3i::Identity().col((axis + 1) % 3),
                               v = Eigen::Matrix3i::Identity().col((axis + 2) % 3);
          std::array<int, 4> corners{};
          const Eigen::Array3i first = cell + step;
          const Eigen::Array3i at[] = { first, first + u, first + u + v, first + v };
          for (int k = 0; k < 4; ++k)
          {
            corners[k] =
              pointOf.emplace(std::array<int, 3>{ at[k](0), at[k](1), at[k](2) }, pointOf.size())
                .first->second;
          }
          const bool isFirst = here != 0 && (next == 0 || here > next);
          for (const auto& half : { std::array<int, 3>{ 0, 1, 2 }, std::array<int, 3>{ 0, 2, 3 } })
          {
            const Eigen::RowVector3i corner(corners[half[0]], corners[half[1]], corners[half[2]]);
            triangles.push_back(isFirst ? corner : Eigen::RowVector3i(corner.reverse()));
            labels.emplace_back(isFirst ? here : next, isFirst ? next : here);
          }
        }
      }
    }
  }
  shape::LabelledSurfaces regions;
  regions.Surfaces.Points.resize(static_cast<Eigen::Index>(pointOf.size()), 3);
  for (const auto& [position, point] : pointOf)
  {
    regions.Surfaces.Points.row(point) << position[0], position[1], position[2];
  }
  regions.Surfaces.Triangles.resize(static_cast<Eigen::Index>(triangles.size()), 3);
  regions.Labels.resize(regions.Surfaces.Triangles.rows(), 2);
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    regions.Surfaces.Triangles.row(static_cast<Eigen::Index>(t)) = triangles[t];
    regions.Labels.row(static_cast<Eigen::Index>(t)) = labels[t];
  }
  return regions;
}

/// An image whose labels are those of a rule at the samples' positions.
shape::LabelImage Image(const std::array<int, 3>& size, const Eigen::Matrix3d& axes,
  const Eigen::RowVector3d& origin, const Rule& rule)
{
  shape::LabelImage image;
  image.Size = size;
  image.Axes = axes;
  image.Origin = origin;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        image.Labels.push_back(rule(origin + Eigen::RowVector3d(i, j, k) * axes.transpose()));
      }
    }
  }
  return image;
}

shape::Mesh BoundaryOf(const shape::HexFit& fit, int label)
{
  std::vector<int> rows;
  for (int hex = 0; hex < static_cast<int>(fit.RegionOf.size()); ++hex)
  {
    if (fit.RegionOf(hex) == label)
    {
      rows.push_back(hex);
    }
  }
  const shape::HexMesh region{ fit.Solid.Points, fit.Solid.Hexahedra(rows, Eigen::all) };
  return { fit.Solid.Points, shape::SplitQuads(shape::FindBoundaryQuads(region)) };
}

/// Points of hexahedra with these regions around them.
std::map<int, std::set<int>> RegionsAtPoints(const shape::HexFit& fit)
{
  std::map<int, std::set<int>> regions;
  for (Eigen::Index hex = 0; hex < fit.Solid.Hexahedra.rows(); ++hex)
  {
    for (const int point : Eigen::RowVectorXi(fit.Solid.Hexahedra.row(hex)))
    {
      regions[point].insert(fit.RegionOf(hex));
    }
  }
  return regions;
}

/// Checks what holds for every result: nothing is inverted, and each region is a closed manifold
/// with the Euler number of its surface. eulerNumbers: by label.
void Check(const shape::HexRemeshResult& result, const std::map<int, int>& eulerNumbers)
{
  const shape::HexFit& fit = result.Fit;
  EXPECT_EQ(fit.Inverted, 0);
  EXPECT_EQ(fit.MinimumScaledJacobian, shape::ComputeScaledJacobians(fit.Solid).minCoeff());
  ASSERT_EQ(result.Regions.size(), eulerNumbers.size());
  for (const shape::HexRegion& region : result.Regions)
  {
    const shape::Mesh boundary = BoundaryOf(fit, region.Label);
    const shape::Topology topology = shape::RequireClosedSurface(boundary, "the region");
    EXPECT_EQ(topology.EulerNumber, eulerNumbers.at(region.Label)) << region.Label;
    EXPECT_EQ(region.EulerNumber, topology.EulerNumber);
    EXPECT_DOUBLE_EQ(region.Volume, shape::ComputeEnclosedVolume(boundary));
  }
  // Regions share points: only the quads of the boundary belong to one hexahedron.
  EXPECT_EQ(shape::FindBoundaryQuads(fit.Solid).rows(), fit.Quads.rows());
  Eigen::Index quads = fit.Quads.rows();
  for (const Eigen::MatrixXi& interface : fit.Interfaces)
  {
    quads += interface.rows();
  }
  EXPECT_EQ(fit.QuadRegions.rows(), quads);
  EXPECT_TRUE((fit.QuadRegions.topRows(fit.Quads.rows()).col(1).array() == 0).all());
  EXPECT_TRUE((fit.QuadRegions.bottomRows(quads - fit.Quads.rows()).array() != 0).all());
}

/// The curves with these labels around them, as triangles without area.
shape::Mesh CurveOf(const shape::LabelledSurfaces& regions, const std::vector<int>& labels)
{
  std::vector<Eigen::RowVector3i> edges;
  for (const auto& curve :
    shape::FindRegionNetwork(regions.Surfaces.Triangles, regions.Labels).Curves)
  {
    for (std::size_t i = 0; curve.Labels == labels && i + 1 < curve.Points.size(); ++i)
    {
      edges.emplace_back(curve.Points[i], curve.Points[i + 1], curve.Points[i + 1]);
    }
  }
  shape::Mesh mesh{ regions.Surfaces.Points, Eigen::MatrixXi(edges.size(), 3) };
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    mesh.Triangles.row(static_cast<Eigen::Index>(i)) = edges[i];
  }
  return mesh;
}

double VolumeOf(const shape::HexRemeshResult& result, int label)
{
  const auto found = std::find_if(result.Regions.begin(), result.Regions.end(),
    [&](const shape::HexRegion& region) { return region.Label == label; });
  return found == result.Regions.end() ? 0.0 : found->Volume;
}

} // namespace

TEST(RegionRemesh, TwoCubesShareTheirFace)
{
  const auto regions =
    Blocks({ 8, 4, 4 }, [](const Eigen::RowVector3d& at) { return at(0) < 4.0 ? 3 : 7; });
  shape::HexRemeshOptions options;
  options.CellSize = 0.5;
  const shape::HexRemeshResult result = shape::RemeshRegions(regions, options);
  Check(result, { { 3, 2 }, { 7, 2 } });
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.3);
  // The four curves around the face are one closed curve of the boundary.
  EXPECT_EQ(result.Curves, 1);
  EXPECT_EQ(result.CurvesKept, 1);
  EXPECT_EQ(result.Junctions, 0);
  // What the rounded edges lose: each is cut off by less than a quarter of a cell's section.
  const double rounded = 0.25 * options.CellSize * options.CellSize * 12.0 * 4.0;
  EXPECT_NEAR(VolumeOf(result, 3), 64.0, rounded);
  EXPECT_NEAR(VolumeOf(result, 7), 64.0, rounded);
  ASSERT_EQ(result.Fit.Interfaces.size(), 1U);
  EXPECT_EQ(
    result.Fit.QuadRegions.row(result.Fit.QuadRegions.rows() - 1), Eigen::RowVector2i(7, 3));
  int shared = 0;
  for (const auto& [point, around] : RegionsAtPoints(result.Fit))
  {
    if (around.size() == 2)
    {
      ++shared;
      EXPECT_NEAR(result.Fit.Solid.Points(point, 0), 4.0, 1e-9);
    }
  }
  EXPECT_EQ(shared, 81); // 9 x 9 points of 8 x 8 faces
}

TEST(RegionRemesh, ThreeWedgesOfABallMeetAlongALine)
{
  // A ball that one plane divides, and another plane one of its halves.
  constexpr double radius = 14.0;
  const Eigen::RowVector3d first = Eigen::RowVector3d(1.0, 0.2, 0.1).normalized();
  const Eigen::RowVector3d along = Eigen::Vector3d(first.transpose())
                                     .cross(Eigen::Vector3d(0.0, 1.0, 0.0))
                                     .normalized()
                                     .transpose();
  const Eigen::RowVector3d second =
    Eigen::Vector3d(along.transpose()).cross(Eigen::Vector3d(first.transpose())).transpose();
  const auto rule = [&](const Eigen::RowVector3d& at)
  { return at.norm() > radius ? 0 : (at.dot(first) > 0.0 ? 1 : (at.dot(second) > 0.0 ? 2 : 3)); };
  const Eigen::RowVector3d origin = Eigen::RowVector3d::Constant(-16.0);
  const shape::LabelledSurfaces regions =
    shape::SeparateLabels(Image({ 33, 33, 33 }, Eigen::Matrix3d::Identity(), origin, rule));
  shape::HexRemeshOptions options;
  options.CellSize = 2.2;
  const shape::HexRemeshResult result = shape::RemeshRegions(regions, options);
  Check(result, { { 1, 2 }, { 2, 2 }, { 3, 2 } });
  EXPECT_GT(result.Fit.MinimumScaledJacobian, 0.3);
  EXPECT_EQ(result.JunctionsKept, 2);
  EXPECT_EQ(result.CurvesKept, 4);
  const shape::SurfaceLocator curve(CurveOf(regions, { 1, 2, 3 }));
  int onLine = 0, away = 0;
  for (const auto& [point, around] : RegionsAtPoints(result.Fit))
  {
    if (around.size() == 3)
    {
      ++onLine;
      away += curve.FindOne(result.Fit.Solid.Points.row(point)).Distance > 1e-9 ? 1 : 0;
      const Eigen::RowVector3d position = result.Fit.Solid.Points.row(point);
      // Half a voxel along each axis.
      EXPECT_LT((position - position.dot(along) * along).norm(), std::sqrt(0.75));
    }
  }
  // Points lie on the curve, except those that would make hexahedra inverted.
  EXPECT_LE(away, result.Fit.Released);
  EXPECT_LT(away, onLine / 2);
  // The ball's circles are followed by chords: a step of a chain is at most twice a cell.
  EXPECT_LT(
    result.CurveDistance, std::sqrt(0.75) + 0.5 * options.CellSize * options.CellSize / radius);
  EXPECT_GT(onLine, static_cast<int>(2.0 * radius / options.CellSize));
  const double ball = 4.0 / 3.0 * M_PI * radius * radius * radius;
  EXPECT_NEAR(VolumeOf(result, 1) / ball, 0.5, 0.03);
  EXPECT_NEAR(VolumeOf(result, 2) / ball, 0.25, 0.03);
}

TEST(RegionRemesh, ARegionInsideAnotherHasAShellAroundIt)
{
  const Eigen::RowVector3d origin = Eigen::RowVector3d::Constant(-12.0);
  const auto rule = [](const Eigen::RowVector3d& at)
  { return at.norm() < 5.5 ? 2 : (at.norm() < 10.5 ? 1 : 0); };
  const shape::LabelledSurfaces regions =
    shape::SeparateLabels(Image({ 25, 25, 25 }, Eigen::Matrix3d::Identity(), origin, rule));
  shape::HexRemeshOptions options;
  options.CellSize = 1.6;
  const shape::HexRemeshResult one = shape::RemeshRegions(regions, options);
  Check(one, { { 1, 4 }, { 2, 2 } });
  EXPECT_GT(one.Fit.MinimumScaledJacobian, 0.3);
  EXPECT_EQ(one.Curves, 0);
  // Each further layer has a hexahedron for each quad and region beside it.
  options.PaddingLayers = 2;
  const shape::HexRemeshResult two = shape::RemeshRegions(regions, options);
  Check(two, { { 1, 4 }, { 2, 2 } });
  EXPECT_EQ(two.Fit.Solid.Hexahedra.rows() - one.Fit.Solid.Hexahedra.rows(),
    one.Fit.Quads.rows() + 2 * one.Fit.Interfaces[0].rows());
}

TEST(RegionRemesh, TheGridFollowsTheAxesOfTheImage)
{
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(0.7, Eigen::Vector3d(1.0, 2.0, 3.0).normalized()).toRotationMatrix();
  const Eigen::RowVector3d origin(3.0, -2.0, 5.0);
  // Two blocks along an axis of the image, whose voxels are not cubes.
  const Eigen::Matrix3d axes = turn * Eigen::Vector3d(1.0, 0.5, 2.0).asDiagonal();
  shape::LabelImage image =
    Image({ 22, 22, 8 }, axes, origin, [](const Eigen::RowVector3d&) { return 0; });
  for (int k = 1; k < 7; ++k)
  {
    for (int j = 1; j < 21; ++j)
    {
      for (int i = 1; i < 21; ++i)
      {
        image.Labels[image.IndexOf(i, j, k)] = i < 11 ? 1 : 2;
      }
    }
  }
  const shape::LabelledSurfaces regions = shape::SeparateLabels(image);
  EXPECT_LT((regions.Frame - turn).norm(), 1e-12);
  shape::HexRemeshOptions options;
  options.CellSize = 2.0;
  const shape::HexRemeshResult result = shape::RemeshRegions(regions, options);
  Check(result, { { 1, 2 }, { 2, 2 } });
  // The interface is normal to the first axis.
  const double place = (10.5 * axes.col(0).transpose() + origin).dot(turn.col(0).transpose());
  for (const auto& [point, around] : RegionsAtPoints(result.Fit))
  {
    if (around.size() == 2)
    {
      EXPECT_NEAR(result.Fit.Solid.Points.row(point).dot(turn.col(0).transpose()), place, 0.5);
    }
  }
  EXPECT_NEAR(VolumeOf(result, 1), 1200.0, 0.06 * 1200.0);
}

TEST(RegionRemesh, CellsAreSmallerThanGivenOnlyIfLargerOnesDoNotDoIt)
{
  // The first block has a tunnel, which cells larger than the tunnel cannot have.
  const auto regions = Blocks({ 16, 8, 8 },
    [](const Eigen::RowVector3d& at)
    {
      const bool isTunnel = at(0) > 3.0 && at(0) < 5.0 && at(1) > 3.0 && at(1) < 5.0;
      return isTunnel ? 0 : at(0) < 8.0 ? 1 : 2;
    });
  shape::HexRemeshOptions options;
  options.CellSize = 0.9;
  const shape::HexRemeshResult given = shape::RemeshRegions(regions, options);
  Check(given, { { 1, 0 }, { 2, 2 } });
  EXPECT_EQ(given.CellSize, options.CellSize);
  EXPECT_EQ(given.Reason.find("smaller"), std::string::npos) << given.Reason;
  options.CellSize = 5.0;
  const shape::HexRemeshResult smaller = shape::RemeshRegions(regions, options);
  Check(smaller, { { 1, 0 }, { 2, 2 } });
  EXPECT_LT(smaller.CellSize, options.CellSize);
  EXPECT_NE(smaller.Reason.find("larger ones lack the topology"), std::string::npos)
    << smaller.Reason;
}

TEST(RegionRemesh, WhatCannotBeFilledIsNamed)
{
  auto regions =
    Blocks({ 4, 2, 2 }, [](const Eigen::RowVector3d& at) { return at(0) < 2.0 ? 1 : 2; });
  shape::HexRemeshOptions options;
  options.CellSize = 0.5;
  options.Method = shape::HexRemeshOptions::MethodType::Polycube;
  EXPECT_REFUSED(shape::RemeshRegions(regions, options), "Grid");
  options.Method = shape::HexRemeshOptions::MethodType::Automatic;
  options.CellsOnLongestSide = 3;
  EXPECT_REFUSED(shape::RemeshRegions(regions, options), "CellsOnLongestSide");
  options.CellsOnLongestSide = 0;
  options.PaddingLayers = 0;
  EXPECT_REFUSED(shape::RemeshRegions(regions, options), "PaddingLayers");
  options.PaddingLayers = 1;
  const auto whole = regions;
  regions.Labels(0, 1) = regions.Labels(0, 0);
  EXPECT_REFUSED(shape::RemeshRegions(regions, options), "both sides");
  regions = whole;
  regions.Surfaces.Triangles.conservativeResize(regions.Surfaces.Triangles.rows() - 1, 3);
  regions.Labels.conservativeResize(regions.Labels.rows() - 1, 2);
  EXPECT_REFUSED(shape::RemeshRegions(regions, options), "region");
}
