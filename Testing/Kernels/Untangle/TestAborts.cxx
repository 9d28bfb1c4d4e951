#include "Base/Errors.h"
#include "Linear/NewtonSystem.h"
#include "Untangle/Private/CellPatches.h"
#include "Untangle/Private/CellSplits.h"
#include "Untangle/Private/ClusterSplits.h"
#include "Untangle/Private/TutteEmbedding.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace
{

/// A double cone over a polygon, of tetrahedra at its centre: point 0, which is put outside.
shape::Cells InvertedCone(int sides)
{
  constexpr int centre = 0, top = 1, bottom = 2;
  shape::Cells cone{ Eigen::MatrixXd(3 + sides, 3), Eigen::VectorXi::Constant(2 * sides, 10),
    Eigen::VectorXi::LinSpaced(2 * sides + 1, 0, 8 * sides), Eigen::VectorXi(8 * sides) };
  cone.Points.topRows(3) << 3, 0.5, 0.25, 0, 0, 1, 0, 0, -1;
  for (int side = 0; side < sides; ++side)
  {
    const double angle = 2.0 * M_PI * side / sides;
    const int here = 3 + side, next = 3 + (side + 1) % sides;
    cone.Points.row(here) << std::cos(angle), std::sin(angle), 0.0;
    cone.Corners.segment<8>(8 * side) << centre, here, next, top, centre, next, here, bottom;
  }
  return cone;
}

TEST(Aborts, EndEachPartOfTheWorkAtItsReport)
{
  const shape::Cells cone = InvertedCone(50);
  shape::SolidCells solid(cone, {}, "the cone");
  const std::vector<int> bad = shape::FindInverted(solid);
  ASSERT_FALSE(bad.empty());
  const auto isMovable = [&](int point) { return !solid.OnBoundary(point); };
  const std::vector<char> marked = shape::MarkAroundInverted(solid, 2);
  const Eigen::VectorXd sizes = shape::ComputeLogarithmicSizes(solid);
  const std::vector<std::function<void(const shape::Progress&)>> parts = { [&](const auto& progress)
    { shape::FindInverted(solid, progress); },
    [&](const auto& progress) { shape::MarkAroundInverted(solid, 2, progress); },
    [&](const auto& progress) { shape::FindMovablePatches(solid, marked, isMovable, progress); },
    [&](const auto& progress) { shape::ComputeLogarithmicSizes(solid, progress); },
    [&](const auto& progress) { shape::SolveTutteEmbedding(solid, progress); },
    [&](const auto& progress) { shape::BuildPatch(solid, { 0 }, sizes, progress); },
    [&](const auto& progress) { shape::CellSplits(solid, isMovable).Impossible(bad, progress); },
    [&](const auto& progress) { shape::CellSplits(solid, isMovable).Stubborn(bad, 1, progress); },
    [&](const auto& progress) { shape::SolidCells(cone, {}, "the cone", progress); },
    [&](const auto& progress) {
      shape::NewtonSystem({ 3, 3 }, { 0, 1, -1, 0 }, 2, progress);
    } };
  const shape::Progress abort([](double) { return false; });
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    EXPECT_THROW(parts[i](abort), shape::Aborted) << "part " << i;
  }
  EXPECT_EQ(solid.CellCount(), cone.Kinds.size()) << "nothing is split before a report";
  int reports = 0;
  const shape::Progress count([&](double) { return ++reports > 0; });
  EXPECT_EQ(shape::ComputeLogarithmicSizes(solid, count), sizes);
  EXPECT_GE(reports, 2) << "the iteration reports, too";
}

TEST(Aborts, EndTheWorkForAPointOfACluster)
{
  const shape::Cells cone = InvertedCone(500);
  shape::SolidCells solid(cone, {}, "the cone");
  int reports = 0;
  const shape::Progress abort([&](double) { return ++reports < 20; });
  shape::PointCluster cluster(solid, {}, abort);
  cluster.Begin({ 0 });
  EXPECT_THROW(shape::ClusterSplits(cluster).FindExitByPulling(), shape::Aborted);
  EXPECT_EQ(reports, 20) << "it went on after an abort";
  EXPECT_EQ(solid.PointCount(), cone.Points.rows())
    << "no edge is split before the faces are compared";
}

} // namespace
