#include "Base/Errors.h"
#include "Mesh/FaceMesh.h"
#include "Mesh/Surface.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace
{

/// A wedge on top of a hexahedron, as wedge and hexahedron or as two polyhedra.
shape::Cells House(bool turned)
{
  shape::Cells cells;
  cells.Points.resize(10, 3);
  cells.Points << 0, 0, 0, 2, 0, 0, 2, 1, 0, 0, 1, 0, 0, 0, 1, 2, 0, 1, 2, 1, 1, 0, 1, 1, //
    1, 0, 2, 1, 1, 2;
  cells.Kinds.resize(2);
  cells.Kinds << shape::cell_kind::Hexahedron, shape::cell_kind::Wedge;
  cells.Offsets.resize(3);
  cells.Offsets << 0, 8, 14;
  cells.Corners.resize(14);
  cells.Corners << 0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 8, 7, 6, 9;
  if (turned)
  {
    cells.Corners.tail(6) << 7, 6, 9, 4, 5, 8;
  }
  return cells;
}

void ExpectHouse(const shape::Cells& cells, const shape::FaceMesh& faces)
{
  EXPECT_EQ(faces.FaceCount(), 10);
  EXPECT_EQ(std::count(faces.Neighbours.begin(), faces.Neighbours.end(), -1), 9);
  const Eigen::MatrixXi triangles = shape::TriangulateBoundary(faces);
  EXPECT_EQ(triangles.rows(), 7 * 2 + 2);
  const shape::Surface surface(cells.Points, triangles);
  EXPECT_NO_THROW(shape::RequireClosedSurface(surface, "the boundary"));
  EXPECT_NEAR(shape::ComputeEnclosedVolume(surface), 3.0, 1e-14);
}

} // namespace

TEST(FaceMesh, BoundaryOfCellsEnclosesTheirVolume)
{
  for (const bool turned : { false, true })
  {
    const shape::Cells cells = House(turned);
    ExpectHouse(cells, shape::BuildFaceMesh(cells));
  }
}

TEST(FaceMesh, PolyhedraHaveTheSameFaces)
{
  shape::Cells cells = House(false);
  cells.Kinds.setConstant(shape::PolyhedronKind);
  // The first polyhedron faces inwards, the second either way.
  ExpectHouse(cells,
    shape::BuildFaceMesh(cells,
      { { 4, 0, 1, 2, 3, 4, 7, 6, 5, 4, 4, 4, 5, 1, 0, 4, 5, 6, 2, 1, 4, 6, 7, 3, 2, 4, 7, 4, 0,
          3 },
        { 4, 4, 5, 6, 7, 3, 4, 5, 8, 3, 7, 6, 9, 4, 5, 8, 9, 6, 4, 8, 4, 7, 9 } }));
}

TEST(FaceMesh, RefusesThreeCellsAtAFace)
{
  shape::Cells cells = House(false);
  cells.Kinds(0) = shape::cell_kind::Triangle;
  EXPECT_THROW(shape::BuildFaceMesh(cells), shape::InvalidInput);
  cells = House(false);
  cells.Kinds.resize(3);
  cells.Kinds.setConstant(shape::cell_kind::Tetrahedron);
  cells.Offsets.resize(4);
  cells.Offsets << 0, 4, 8, 12;
  cells.Corners.resize(12);
  cells.Corners << 0, 1, 2, 4, 0, 1, 2, 5, 0, 1, 2, 6;
  EXPECT_THROW(shape::BuildFaceMesh(cells), shape::InvalidInput);
}
