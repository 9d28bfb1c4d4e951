#include "IO/MeditReader.h"
#include "IO/MeditWriter.h"
#include "Support/Refusals.h"
#include "Support/SolverMeshes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <sstream>

using namespace shape::cell_kind;

TEST(MeditReader, ReadsWhatTheWriterWroteToTheBit)
{
  shape::Cells cells = shapetest::Cubes({ 3, 2, 2 }, shapetest::Everywhere);
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (double& x : cells.Points.reshaped())
  {
    x = uniform(generator) * std::pow(10.0, 100.0 * uniform(generator));
  }
  Eigen::VectorXi regions = Eigen::VectorXi::Zero(12);
  regions(4) = 6;
  std::stringstream file;
  shape::WriteMedit(file, shape::FindMeshSets(cells, regions, 180.0));
  const shape::MeditMesh read = shape::ReadMedit(file.str());
  EXPECT_EQ(read.Mesh.Points, cells.Points);
  EXPECT_EQ(read.PointReferences, Eigen::VectorXi::Zero(cells.Points.rows()));
  // The quadrilaterals of the boundary and of the interface come first.
  const Eigen::Index quads = read.Mesh.Kinds.size() - 12;
  EXPECT_EQ(quads, 2 * (6 + 6 + 4) + 4);
  EXPECT_TRUE((read.Mesh.Kinds.head(quads).array() == Quadrilateral).all());
  EXPECT_TRUE((read.Mesh.Kinds.tail(12).array() == Hexahedron).all());
  EXPECT_EQ(read.Mesh.Corners.tail(96), cells.Corners);
  EXPECT_EQ(read.CellReferences.tail(12), (regions.array() + 1).matrix());
}

TEST(MeditReader, ReadsEveryKind)
{
  const shape::Cells solid = shapetest::OneOfEach();
  shapetest::CellList list;
  list.Add(Vertex, { 6 });
  list.Add(Line, { 0, 1 });
  list.Add(Triangle, { 0, 2, 1 });
  list.Add(Quadrilateral, { 0, 3, 2, 1 });
  list.Add(Tetrahedron, { 5, 6, 8, 11 });
  list.Add(Pyramid, { 4, 5, 6, 7, 8 });
  list.Add(Wedge, { 1, 5, 9, 2, 6, 10 });
  list.Add(Hexahedron, { 0, 1, 2, 3, 4, 5, 6, 7 });
  const shape::Cells mixed = list.Over(solid.Points);
  std::stringstream file;
  shape::WriteMedit(file, shape::FindMeshSets(mixed, Eigen::VectorXi::LinSpaced(8, 0, 7), 40.0));
  const shape::MeditMesh read = shape::ReadMedit(file.str());
  EXPECT_EQ(read.Mesh.Kinds, mixed.Kinds);
  EXPECT_EQ(read.Mesh.Offsets, mixed.Offsets);
  EXPECT_EQ(read.Mesh.Corners, mixed.Corners);
  EXPECT_EQ(read.CellReferences, (Eigen::VectorXi(8) << 0, 2, 3, 4, 5, 6, 7, 8).finished());
}

TEST(MeditReader, SkipsSectionsThatAreNoCells)
{
  const shape::MeditMesh read = shape::ReadMedit(
    "# a comment\nMeshVersionFormatted\n1\nDimension\n2\nVertices 3\n0 0 5\n1 0 6\n0 1 7 # last\n"
    "RequiredVertices\n2\n1\n3\nNormals\n1\n0 0 -1.0\n.5 .5 .5\nTriangles\n1\n1 2 3 9\nEnd\n");
  EXPECT_EQ(read.Mesh.Points.row(2), Eigen::RowVector3d(0.0, 1.0, 0.0));
  EXPECT_EQ(read.PointReferences, Eigen::Vector3i(5, 6, 7));
  EXPECT_EQ(read.Mesh.Corners, Eigen::Vector3i(0, 1, 2));
  EXPECT_EQ(read.CellReferences(0), 9);
}

TEST(MeditReader, RefusesWrongFilesWithTheLine)
{
  const std::string start = "MeshVersionFormatted 2\nDimension 3\n";
  const std::string points = start + "Vertices\n2\n0 0 0 1\n1 0 0 1\n";
  EXPECT_REFUSED(shape::ReadMedit(""), "does not begin with MeshVersionFormatted");
  EXPECT_REFUSED(shape::ReadMedit("$MeshFormat\n"), "line 1", "choose a Medit file");
  EXPECT_REFUSED(shape::ReadMedit("MeshVersionFormatted 2\nDimension 4\n"), "Dimension is 4");
  EXPECT_REFUSED(shape::ReadMedit(start + "End\n"), "the file has no Vertices");
  EXPECT_REFUSED(
    shape::ReadMedit(start + "Vertices\n-1\n"), "line 4: the file declares -1 Vertices");
  EXPECT_REFUSED(shape::ReadMedit(start + "Vertices\n2000000000\n1 2 3\n"), "too short for them");
  EXPECT_REFUSED(shape::ReadMedit(start + "Triangles\n1\n1 2 3 0\n"), "refer to vertex 1");
  EXPECT_REFUSED(
    shape::ReadMedit(points + "Edges\n1\n1 3 0\n"), "line 9: Edges refer to vertex 3", "1 to 2");
  EXPECT_REFUSED(shape::ReadMedit(points + "Edges\n1\n1 0 0\n"), "Edges refer to vertex 0");
  EXPECT_REFUSED(shape::ReadMedit(points + "Edges\n2\n1 2 0\n\n"), "the file ends before Edges");
  EXPECT_REFUSED(shape::ReadMedit(points + "TrianglesP2\n0\n"), "higher order");
  EXPECT_REFUSED(shape::ReadMedit(points + "edges?\n0\n"), "'edges?' is no keyword");
}
