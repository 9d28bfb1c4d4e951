#include "Support/Refusals.h"
#include "Support/SimpleSurfaces.h"
#include "Support/TetrahedralSolids.h"
#include "Tetrahedra/Tetrahedralize.h"

#include <gtest/gtest.h>

using shapetest::BoundaryOf;
using shapetest::Box;
using shapetest::Joined;
using shapetest::RegionVolume;

namespace
{

/// Two unit cubes that share the square at x = 1. Region 4 is the cube at the origin, and region 7
/// the other one.
struct TwoCubes
{
  TwoCubes()
  {
    this->Mesh.Points.resize(12, 3);
    for (int i = 0; i < 12; ++i)
    {
      this->Mesh.Points.row(i) << i % 3, i / 3 % 2, i / 6;
    }
    // Of each square: corners counter-clockwise seen from outside the first region.
    const int squares[11][6] = { { 0, 6, 9, 3, 4, 0 }, { 0, 1, 7, 6, 4, 0 }, { 3, 9, 10, 4, 4, 0 },
      { 0, 3, 4, 1, 4, 0 }, { 6, 7, 10, 9, 4, 0 }, { 1, 2, 8, 7, 7, 0 }, { 4, 10, 11, 5, 7, 0 },
      { 1, 4, 5, 2, 7, 0 }, { 7, 8, 11, 10, 7, 0 }, { 2, 5, 11, 8, 7, 0 }, { 1, 7, 10, 4, 7, 4 } };
    this->Mesh.Triangles.resize(22, 3);
    this->Labels.resize(22, 2);
    for (int i = 0; i < 11; ++i)
    {
      const int* q = squares[i];
      this->Mesh.Triangles.row(2 * i) << q[0], q[1], q[2];
      this->Mesh.Triangles.row(2 * i + 1) << q[0], q[2], q[3];
      this->Labels.row(2 * i) << q[4], q[5];
      this->Labels.row(2 * i + 1) << q[4], q[5];
    }
  }

  shape::Mesh Mesh;
  Eigen::MatrixXi Labels;
};

} // namespace

TEST(TetrahedralizeRegions, RegionsThatTouchShareTheirInterface)
{
  const TwoCubes cubes;
  shape::TetrahedralizeOptions options;
  for (const double maximum : { 0.0, 0.01 })
  {
    options.MaximumVolume = maximum;
    options.PreserveBoundary = maximum == 0.0;
    const auto solid = shape::TetrahedralizeRegions(cubes.Mesh, cubes.Labels, options);
    EXPECT_EQ(solid.Regions, 2);
    EXPECT_NEAR(RegionVolume(solid, 4), 1.0, 1e-12);
    EXPECT_NEAR(RegionVolume(solid, 7), 1.0, 1e-12);
    // The boundary of the tetrahedra is that of the box: they are connected at the interface.
    const shape::Mesh boundary = BoundaryOf(solid);
    EXPECT_NEAR(shape::ComputeEnclosedVolume(boundary), 2.0, 1e-12);
    for (const Eigen::RowVector3d centroid : shape::ComputeCentroids(boundary).rowwise())
    {
      EXPECT_GT((centroid - Eigen::RowVector3d(1.0, 0.5, 0.5)).cwiseAbs().maxCoeff(), 0.49);
    }
    for (Eigen::Index i = 0; i < solid.Tetrahedra.rows(); ++i)
    {
      const double x = solid.Points(solid.Tetrahedra.row(i), 0).mean();
      EXPECT_EQ(solid.RegionId(i), x < 1.0 ? 4 : 7);
    }
  }
}

TEST(TetrahedralizeRegions, ThePocketsOfTheOutsideStayEmpty)
{
  // A box with a pocket: the normals of the pocket's triangles leave the region, too.
  shape::Mesh pocket = Box({ 1.0, 1.0, 1.0 }, { 2.0, 2.0, 2.0 });
  pocket.Triangles.rowwise().reverseInPlace();
  const shape::Mesh surfaces = Joined({ Box({ 0.0, 0.0, 0.0 }, { 3.0, 3.0, 3.0 }), pocket });
  Eigen::MatrixXi labels(surfaces.Triangles.rows(), 2);
  labels.col(0).setConstant(2);
  labels.col(1).setZero();
  shape::TetrahedralizeOptions options;
  options.MaximumVolume = 0.05;
  options.PreserveBoundary = false;
  const auto solid = shape::TetrahedralizeRegions(surfaces, labels, options);
  EXPECT_NEAR(RegionVolume(solid, 2), 26.0, 1e-10);
  EXPECT_NEAR(solid.Volume, 26.0, 1e-10);
  // No point is left in the pocket.
  for (const Eigen::RowVector3d point : solid.Points.rowwise())
  {
    EXPECT_GE((point - Eigen::RowVector3d::Constant(1.5)).cwiseAbs().maxCoeff(), 0.5 - 1e-12);
  }
}

TEST(TetrahedralizeRegions, RefusesRegionsThatAreNotClosed)
{
  TwoCubes open;
  open.Mesh.Triangles.conservativeResize(21, 3);
  open.Labels.conservativeResize(21, 2);
  EXPECT_REFUSED(shape::TetrahedralizeRegions(open.Mesh, open.Labels), "region 4");
  TwoCubes same;
  same.Labels(3, 1) = 4;
  EXPECT_REFUSED(shape::TetrahedralizeRegions(same.Mesh, same.Labels), "triangle 3 has region 4");
  TwoCubes inwards;
  inwards.Mesh.Triangles.col(0).swap(inwards.Mesh.Triangles.col(1));
  EXPECT_REFUSED(shape::TetrahedralizeRegions(inwards.Mesh, inwards.Labels), "faces inwards");
}
