#include "Base/Errors.h"
#include "IO/BoundaryPatches.h"
#include "IO/MeshSets.h"
#include "Mesh/CellFaces.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Support/Refusals.h"
#include "Support/SolverMeshes.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace
{

using namespace shape::cell_kind;

/// How many faces each patch of a mesh has, in rising order.
std::multiset<int> PatchSizes(const shape::Cells& cells, double featureAngle)
{
  const shape::SolidFaces boundary = shape::FindBoundaryFaces(cells);
  const Eigen::VectorXi patches =
    shape::FindBoundaryPatches(cells.Points, boundary.Corners, featureAngle);
  std::map<int, int> counts;
  for (const int patch : patches)
  {
    ++counts[patch];
  }
  std::multiset<int> sizes;
  for (const auto& [patch, count] : counts)
  {
    sizes.insert(count);
  }
  return sizes;
}

Eigen::RowVector3d AreaVector(const shape::Cells& cells, const Eigen::RowVector4i& face)
{
  const auto point = [&](int k) -> Eigen::Vector3d { return cells.Points.row(face(k)); };
  const Eigen::Vector3d area = face(3) < 0 ? (point(1) - point(0)).cross(point(2) - point(0))
                                           : (point(2) - point(0)).cross(point(3) - point(1));
  return 0.5 * area.transpose();
}

} // namespace

TEST(CellFaces, FaceOutwardsAndCloseEachCell)
{
  const shape::Cells all = shapetest::OneOfEach();
  for (Eigen::Index cell = 0; cell < all.Kinds.size(); ++cell)
  {
    shapetest::CellList one;
    one.Add(all.Kinds(cell),
      { all.Corners.begin() + all.Offsets(cell), all.Corners.begin() + all.Offsets(cell + 1) });
    const shape::Cells alone = one.Over(all.Points);
    const shape::SolidFaces faces = shape::FindBoundaryFaces(alone);
    EXPECT_EQ(
      faces.Cell.size(), static_cast<Eigen::Index>(shape::GetFaces(all.Kinds(cell)).size()));
    // The divergence theorem: no area in sum, and three times the volume as the flux of x.
    Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
    double flux = 0.0;
    for (const auto face : faces.Corners.rowwise())
    {
      const int size = face(3) < 0 ? 3 : 4;
      Eigen::RowVector3d centre = Eigen::RowVector3d::Zero();
      for (int k = 0; k < size; ++k)
      {
        centre += all.Points.row(face(k)) / size;
      }
      sum += AreaVector(alone, face);
      flux += AreaVector(alone, face).dot(centre);
    }
    EXPECT_LT(sum.norm(), 1e-15);
    const double volumes[] = { 1.0, 1.0 / 3.0, 0.5, 1.0 / 6.0 };
    EXPECT_NEAR(flux / 3.0, volumes[cell], 1e-15) << cell;
  }
}

TEST(BoundaryPatches, OfACubeAreItsSides)
{
  const shape::Cells cube = shapetest::Cubes({ 3, 4, 5 }, shapetest::Everywhere);
  const std::multiset<int> sides = { 12, 12, 15, 15, 20, 20 };
  EXPECT_EQ(PatchSizes(cube, 40.0), sides);
  EXPECT_EQ(PatchSizes(cube, 0.0), sides);
  EXPECT_EQ(PatchSizes(cube, 89.9), sides);
  EXPECT_EQ(PatchSizes(cube, 90.1), (std::multiset<int>{ 94 }));
  const shape::SolidFaces boundary = shape::FindBoundaryFaces(cube);
  const Eigen::VectorXi patches = shape::FindBoundaryPatches(cube.Points, boundary.Corners, 40.0);
  // All faces of a patch lie in one plane, and patches are numbered by their first faces.
  std::map<int, Eigen::RowVector3d> normals;
  int next = 0;
  for (Eigen::Index face = 0; face < patches.size(); ++face)
  {
    const Eigen::RowVector3d normal = AreaVector(cube, boundary.Corners.row(face));
    EXPECT_EQ(normals.emplace(patches(face), normal).first->second, normal);
    EXPECT_LE(patches(face), next);
    next = std::max(next, patches(face) + 1);
  }
  EXPECT_EQ(next, 6);
}

TEST(BoundaryPatches, OfAnLBracketAreItsEightSides)
{
  // 4 x 4 cells without a corner of 2 x 2, 3 deep.
  const shape::Cells bracket =
    shapetest::Cubes({ 4, 4, 3 }, [](int x, int y, int) { return x < 2 || y < 2; });
  EXPECT_EQ(PatchSizes(bracket, 40.0), (std::multiset<int>{ 6, 6, 6, 6, 12, 12, 12, 12 }));
}

TEST(BoundaryPatches, OfARoundBarAreItsWallAndItsEnds)
{
  // A square bar whose cross section is blown up to a disk: 40 quads around, 9 degrees each.
  shape::Cells bar = shapetest::Cubes({ 10, 10, 4 }, shapetest::Everywhere);
  for (auto point : bar.Points.rowwise())
  {
    const Eigen::RowVector2d square = point.head(2).array() / 5.0 - 1.0;
    const double ring = square.cwiseAbs().maxCoeff();
    const bool steep = std::abs(square(1)) > std::abs(square(0));
    const double longer = square(steep ? 1 : 0), shorter = square(steep ? 0 : 1);
    const double angle = longer == 0.0 ? 0.0 : shorter / longer * std::acos(-1.0) / 4.0;
    const double radius = longer > 0.0 ? ring : -ring;
    point(steep ? 1 : 0) = radius * std::cos(angle);
    point(steep ? 0 : 1) = radius * std::sin(angle);
  }
  EXPECT_EQ(PatchSizes(bar, 40.0), (std::multiset<int>{ 100, 100, 160 }));
  EXPECT_EQ(PatchSizes(bar, 10.0), (std::multiset<int>{ 100, 100, 160 }));
  EXPECT_EQ(PatchSizes(bar, 8.0).size(), 42u);
}

TEST(BoundaryPatches, TouchInAnEdgeWithoutHangingTogether)
{
  // Two cubes that share an edge: four faces around it, none of which goes on across it.
  const shape::Cells cubes =
    shapetest::Cubes({ 2, 2, 1 }, [](int x, int y, int) { return x == y; });
  EXPECT_EQ(PatchSizes(cubes, 180.0), (std::multiset<int>{ 6, 6 }));
  EXPECT_EQ(PatchSizes(cubes, 40.0).size(), 12u);
}

TEST(BoundaryPatches, OfMixedCellsHaveTrianglesToo)
{
  const shape::Cells cells = shapetest::OneOfEach();
  const shape::SolidFaces boundary = shape::FindBoundaryFaces(cells);
  // 6 + 5 + 5 + 4 faces without twice the three that are shared.
  EXPECT_EQ(boundary.Cell.size(), 14);
  EXPECT_EQ((boundary.Corners.col(3).array() < 0).count(), 3 + 2 + 3);
  shape::Mesh surface{ cells.Points, Eigen::MatrixXi(0, 3) };
  for (const auto face : boundary.Corners.rowwise())
  {
    for (int k = 2; k < (face(3) < 0 ? 3 : 4); ++k)
    {
      surface.Triangles.conservativeResize(surface.Triangles.rows() + 1, 3);
      surface.Triangles.bottomRows(1) << face(0), face(k - 1), face(k);
    }
  }
  EXPECT_EQ(shape::RequireClosedSurface(surface, "the boundary").EulerNumber, 2);
  EXPECT_NEAR(shape::ComputeEnclosedVolume(surface), 2.0, 1e-14);
}

TEST(FindRegionInterfaces, LieBetweenEachTwoRegionsSeenFromTheLower)
{
  const shape::Cells cells = shapetest::Cubes({ 3, 2, 2 }, shapetest::Everywhere);
  Eigen::VectorXi regions(12);
  regions << 7, 2, 2, 7, 2, 2, 7, 2, 0, 7, 2, 2;
  const auto interfaces = shape::FindRegionInterfaces(cells, regions);
  ASSERT_EQ(interfaces.size(), 2u);
  EXPECT_EQ(interfaces[0].Lower, 0);
  EXPECT_EQ(interfaces[0].Upper, 2);
  EXPECT_EQ(interfaces[0].Faces.Cell, Eigen::VectorXi::Constant(3, 8));
  EXPECT_EQ(interfaces[1].Lower, 2);
  EXPECT_EQ(interfaces[1].Upper, 7);
  EXPECT_EQ(interfaces[1].Faces.Cell.size(), 4);
  for (const auto face : interfaces[1].Faces.Corners.rowwise())
  {
    EXPECT_EQ(AreaVector(cells, face), Eigen::RowVector3d(-1.0, 0.0, 0.0));
  }
  EXPECT_TRUE(shape::FindRegionInterfaces(cells, Eigen::VectorXi::Zero(12)).empty());
}

TEST(MeshSets, TurnWedgesThatAreNumberedTheOtherWay)
{
  const shape::Cells given = shapetest::OneOfEach();
  shape::Cells turned = given;
  const int first = turned.Offsets(2);
  std::swap(turned.Corners(first + 1), turned.Corners(first + 2));
  std::swap(turned.Corners(first + 4), turned.Corners(first + 5));
  EXPECT_EQ(shape::FindMeshSets(given, {}, 40.0).Mesh.Corners, given.Corners);
  EXPECT_EQ(shape::FindMeshSets(turned, {}, 40.0).Mesh.Corners, given.Corners);
}

TEST(MeshSets, KeepGivenPatchesAndDivideTheOtherFacesByAngle)
{
  const shape::Cells cells = shapetest::Cubes({ 2, 1, 1 }, shapetest::Everywhere);
  // The faces of a hexahedron: -x, +x, -y, +y, -z, +z. One patch lies around two edges.
  Eigen::MatrixXi given(2, 6);
  given << 4, -1, -1, 4, 1, 4, -1, -1, -1, 4, 1, 4;
  const shape::MeshSets sets = shape::FindMeshSets(cells, {}, 40.0, given);
  const auto groups = shape::GroupFacesByPatch(sets);
  std::vector<std::size_t> sizes;
  for (const auto& faces : groups)
  {
    sizes.push_back(faces.size());
  }
  // -z, then +y, +z and -x, then both faces of -y, then +x.
  EXPECT_EQ(sizes, (std::vector<std::size_t>{ 0, 2, 0, 0, 5, 2, 1 }));
  EXPECT_EQ(sets.PatchCount, 7);
  for (const int face : groups[5])
  {
    EXPECT_EQ(AreaVector(cells, sets.Boundary.Corners.row(face)), Eigen::RowVector3d(0, -1, 0));
  }
  given(0, 0) = 12;
  EXPECT_REFUSED(shape::FindMeshSets(cells, {}, 40.0, given), "a face of cell 0 is 12");
}

TEST(MeshSets, RefuseWhatCannotBeWritten)
{
  const shape::Cells good = shapetest::Cubes({ 2, 1, 1 }, shapetest::Everywhere);
  EXPECT_NO_THROW(shape::FindMeshSets(good, {}, 40.0));
  EXPECT_REFUSED(shape::FindMeshSets(good, {}, -1.0), "FeatureAngle is -1");
  EXPECT_REFUSED(shape::FindMeshSets(good, {}, std::nan("")), "FeatureAngle");
  EXPECT_REFUSED(shape::FindMeshSets(good, Eigen::Vector2i(0, -3), 40.0),
    "of 1 cell is negative (first of cell 1");
  EXPECT_REFUSED(shape::FindMeshSets(good, Eigen::Vector3i::Zero(), 40.0), "3 regions for 2 cells");
  shape::Cells bad = good;
  bad.Kinds(1) = 25;
  EXPECT_REFUSED(shape::FindMeshSets(bad, {}, 40.0), "cell 1 has VTK's cell type 25");
  bad = good;
  bad.Corners(9) = 12;
  EXPECT_REFUSED(shape::FindMeshSets(bad, {}, 40.0), "cell 1 refers to a missing point");
  bad = good;
  bad.Points(3, 1) = std::nan("");
  EXPECT_REFUSED(shape::FindMeshSets(bad, {}, 40.0), "not finite");
  bad = shapetest::CellList().Over(good.Points);
  EXPECT_REFUSED(shape::FindMeshSets(bad, {}, 40.0), "no cells");
}
