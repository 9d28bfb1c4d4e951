#include "Hex/FacePatches.h"
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
