#include "Hex/FacePatches.h"
#include "Mesh/Surface.h"
#include "Support/SimpleSurfaces.h"
#include "Support/SolverMeshes.h"

#include <gtest/gtest.h>

TEST(FacePatches, AreThoseOfTheQuadsWhereverTheyBegin)
{
  const shape::Cells cells = shapetest::Cubes({ 2, 2, 1 }, shapetest::Everywhere);
  shape::HexMesh solid{ cells.Points, cells.Corners.reshaped(8, 4).transpose() };
  Eigen::MatrixXi quads = shape::FindBoundaryQuads(solid);
  const Eigen::VectorXi patches = Eigen::VectorXi::LinSpaced(quads.rows(), 0, quads.rows() - 1);
  const Eigen::MatrixXi first = shape::FindFacePatches(solid, quads, patches);
  // In the middle of each of the four lie two faces inside the block.
  EXPECT_EQ(
    (first.array() < 0).rowwise().count().cast<int>().matrix(), Eigen::Vector4i(2, 2, 2, 2));
  EXPECT_EQ(first.row(0)(1), -1);
  EXPECT_EQ(first.row(0)(3), -1);
  for (Eigen::Index hex = 0; hex < 4; ++hex)
  {
    for (int face = 0; face < 6; ++face)
    {
      if (first(hex, face) >= 0)
      {
        const auto quad = quads.row(first(hex, face));
        int shared = 0;
        for (const int corner : shape::HexFaces[face])
        {
          shared += (quad.array() == solid.Hexahedra(hex, corner)).any() ? 1 : 0;
        }
        EXPECT_EQ(shared, 4);
      }
    }
  }
  // The corner at which a quad begins, and its direction, do not matter.
  quads = quads(Eigen::all, { 2, 1, 0, 3 }).eval();
  EXPECT_EQ(shape::FindFacePatches(solid, quads, patches), first);
}

TEST(FacePatches, AreTheNearestGivenOnesOrThoseOfMostQuads)
{
  const shape::Surface box = shapetest::Box({ 0, 0, 0 }, { 2, 1, 1 });
  // The given patches are the axes across the sides: 0 to 2.
  Eigen::VectorXi given(12);
  for (Eigen::Index t = 0; t < 12; ++t)
  {
    Eigen::Index axis = 0;
    box.AreaVectors().row(t).cwiseAbs().maxCoeff(&axis);
    given(t) = static_cast<int>(axis);
  }
  const shape::Cells cells = shapetest::Cubes({ 2, 1, 1 }, shapetest::Everywhere);
  const Eigen::MatrixXi quads =
    shape::FindBoundaryQuads({ cells.Points, cells.Corners.reshaped(8, 2).transpose() });
  const Eigen::MatrixXd centres = shape::ComputeQuadCentres(cells.Points, quads);
  const Eigen::VectorXi nearest = shape::FindNearestPatches(cells.Points, quads, box, given);
  ASSERT_EQ(nearest.size(), 10);
  for (Eigen::Index q = 0; q < 10; ++q)
  {
    const double across = centres(q, nearest(q)), low = 0.0, high = nearest(q) == 0 ? 2.0 : 1.0;
    EXPECT_TRUE(across == low || across == high) << centres.row(q);
  }
  const Eigen::VectorXi values = Eigen::Vector<int, 5>(4, 9, 9, 4, 4);
  const Eigen::VectorXi patches = Eigen::Vector<int, 5>(0, 0, 0, 1, 1);
  EXPECT_EQ(shape::TakeMostFrequent(values, patches), (Eigen::Vector<int, 5>(9, 9, 9, 4, 4)));
}
