#include "Mesh/RegionSurfaces.h"

#include "Base/Errors.h"
#include "Mesh/Topology.h"

#include <Eigen/Dense>

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace
{

/// Two tetrahedra that share a triangle: region 5 above it and region 3 below.
const shape::Mesh Pair{
  (Eigen::MatrixXd(6, 3) << 9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -2).finished(),
  (Eigen::MatrixXi(7, 3) << 1, 3, 2, 1, 2, 4, 2, 3, 4, 3, 1, 4, 2, 1, 5, 3, 2, 5, 1, 3, 5)
    .finished()
};

} // namespace

TEST(RegionSurfaces, AreClosedAndFaceOutwards)
{
  Eigen::MatrixXi labels(7, 2);
  labels << 5, 3, 5, 0, 5, 0, 5, 0, 3, 0, 3, 0, 3, 0;
  const shape::RegionSurfaces regions(Pair, labels);
  ASSERT_EQ(regions.Triangles().size(), 2U);
  for (const auto& [label, volume] : { std::pair(5, 1.0 / 6.0), std::pair(3, 2.0 / 6.0) })
  {
    const shape::Mesh surface = regions.Extract(label);
    EXPECT_EQ(surface.Points.rows(), 4) << "without the points of others";
    const shape::Topology topology = shape::ComputeTopology(surface);
    EXPECT_EQ(topology.BoundaryLoops, 0);
    EXPECT_EQ(topology.MisorientedEdges, 0);
    EXPECT_EQ(topology.EulerNumber, 2);
    double found = 0.0;
    for (const auto& corners : surface.Triangles.rowwise())
    {
      const Eigen::Matrix3d positions =
        surface.Points(std::vector<int>(corners.begin(), corners.end()), Eigen::all);
      found += positions.determinant() / 6.0;
    }
    EXPECT_NEAR(found, volume, 1e-15);
  }
}

TEST(RegionSurfaces, NameWhatIsWrong)
{
  EXPECT_THROW(shape::RegionSurfaces(Pair, Eigen::MatrixXi::Zero(6, 2)), shape::InvalidInput);
  EXPECT_THROW(
    shape::RegionSurfaces(Pair, Eigen::MatrixXi::Constant(7, 2, 4)), shape::InvalidInput);
}
