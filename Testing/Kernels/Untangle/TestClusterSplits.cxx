#include "Base/Errors.h"
#include "Untangle/Private/ClusterSplits.h"

#include <gtest/gtest.h>

#include <cmath>

namespace
{

TEST(ClusterSplits, CanBeAbortedWithinTheWorkForAPoint)
{
  // A double cone over a polygon. All its tetrahedra have the centre, the only point of the
  // cluster.
  constexpr int sides = 500, centre = 0, top = 1, bottom = 2;
  shape::Cells cone{ Eigen::MatrixXd(3 + sides, 3), Eigen::VectorXi::Constant(2 * sides, 10),
    Eigen::VectorXi::LinSpaced(2 * sides + 1, 0, 8 * sides), Eigen::VectorXi(8 * sides) };
  cone.Points.topRows(3) << 0, 0, 0, 0, 0, 1, 0, 0, -1;
  for (int side = 0; side < sides; ++side)
  {
    const double angle = 2.0 * M_PI * side / sides;
    const int here = 3 + side, next = 3 + (side + 1) % sides;
    cone.Points.row(here) << std::cos(angle), std::sin(angle), 0.0;
    cone.Corners.segment<8>(8 * side) << centre, here, next, top, centre, next, here, bottom;
  }
  shape::SolidCells solid(cone, {}, "the cone");
  double work = 0.0;
  shape::PointCluster cluster(solid, { centre }, true, work);
  cluster.MoveTo({ 3.0, 0.5, 0.25 });
  int reports = 0;
  const shape::Progress abort([&](double) { return ++reports < 20; });
  EXPECT_THROW(shape::ClusterSplits(cluster).FindExitByPulling(abort), shape::Aborted);
  EXPECT_EQ(reports, 20) << "it went on after an abort";
  EXPECT_EQ(solid.PointCount(), 3 + sides) << "no edge is split before the faces are compared";
}

} // namespace
