#include "IO/PolyMesh.h"

#include "Mesh/CellFaces.h"
#include "Support/Refusals.h"
#include "Support/SolverMeshes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <random>
#include <set>
#include <string>
#include <tuple>
#include <vector>

namespace
{

using namespace shape::cell_kind;

/// Returns the cells in another order.
shape::Cells Shuffled(const shape::Cells& cells)
{
  std::vector<int> order(cells.Kinds.size());
  std::iota(order.begin(), order.end(), 0);
  std::mt19937 generator(3);
  std::shuffle(order.begin(), order.end(), generator);
  shapetest::CellList list;
  for (const int cell : order)
  {
    list.Add(cells.Kinds(cell),
      { cells.Corners.begin() + cells.Offsets(cell),
        cells.Corners.begin() + cells.Offsets(cell + 1) });
  }
  return list.Over(cells.Points);
}

/// Unit cubes with bent faces in random order.
shape::Cells BentCubes()
{
  shape::Cells cells = Shuffled(shapetest::Cubes({ 3, 4, 5 }, shapetest::Everywhere));
  std::mt19937_64 generator(7);
  std::uniform_real_distribution<double> uniform(-0.15, 0.15);
  for (double& x : cells.Points.reshaped())
  {
    x += uniform(generator);
  }
  return cells;
}

/// The cubes of a block, each divided into six tetrahedra around a diagonal.
shape::Cells Tetrahedra()
{
  const shape::Cells cubes = shapetest::Cubes({ 2, 3, 2 }, shapetest::Everywhere);
  const std::array<int, 7> ring = { 1, 2, 3, 7, 4, 5, 1 }; // the corners beside the diagonal 0, 6
  shapetest::CellList list;
  for (Eigen::Index cube = 0; cube < cubes.Kinds.size(); ++cube)
  {
    const int* corners = cubes.Corners.data() + cubes.Offsets(cube);
    for (int k = 0; k < 6; ++k)
    {
      list.Add(Tetrahedron, { corners[0], corners[ring[k]], corners[ring[k + 1]], corners[6] });
    }
  }
  return Shuffled(list.Over(cubes.Points));
}

shape::PolyMesh Make(const shape::Cells& cells, const Eigen::VectorXi& regions = {})
{
  return shape::MakePolyMesh(shape::FindMeshSets(cells, regions, 40.0));
}

int CountCorners(const shape::PolyMesh& mesh, Eigen::Index face)
{
  return mesh.Faces(face, 3) < 0 ? 3 : 4;
}

/// The area vector of a face, and the integral of the position over it times its normal.
std::pair<Eigen::RowVector3d, double> Flux(const shape::PolyMesh& mesh, Eigen::Index face)
{
  const auto point = [&](int k) -> Eigen::RowVector3d
  { return mesh.Points.row(mesh.Faces(face, k)); };
  Eigen::RowVector3d area = Eigen::RowVector3d::Zero(), mean = Eigen::RowVector3d::Zero();
  for (int k = 0; k < CountCorners(mesh, face); ++k)
  {
    mean += point(k) / CountCorners(mesh, face);
  }
  double flux = 0.0;
  for (int k = 0; k < CountCorners(mesh, face); ++k)
  {
    const Eigen::RowVector3d a = point(k), b = point((k + 1) % CountCorners(mesh, face));
    const Eigen::RowVector3d part = 0.5 * (a - mean).cross(b - mean);
    area += part;
    flux += part.dot(a + b + mean) / 3.0;
  }
  return { area, flux };
}

/// The volume of each cell by the divergence theorem, and what is left of the sum of its outward
/// area vectors.
struct Closure
{
  explicit Closure(const shape::PolyMesh& mesh)
    : Volumes(Eigen::VectorXd::Zero(mesh.CellCount))
    , Gaps(Eigen::MatrixX3d::Zero(mesh.CellCount, 3))
  {
    for (Eigen::Index face = 0; face < mesh.Faces.rows(); ++face)
    {
      const auto [area, flux] = Flux(mesh, face);
      this->Volumes(mesh.Owners(face)) += flux / 3.0;
      this->Gaps.row(mesh.Owners(face)) += area;
      if (face < mesh.Neighbours.size())
      {
        this->Volumes(mesh.Neighbours(face)) -= flux / 3.0;
        this->Gaps.row(mesh.Neighbours(face)) -= area;
      }
    }
  }
  Eigen::VectorXd Volumes;
  Eigen::MatrixX3d Gaps;
};

/// The faces of each cell, by the positions of their points.
using Position = std::array<double, 3>;
using FaceSets = std::vector<std::multiset<std::set<Position>>>;

Position At(const Eigen::MatrixXd& points, int point)
{
  return { points(point, 0), points(point, 1), points(point, 2) };
}

FaceSets FacesOf(const shape::Cells& cells)
{
  FaceSets sets(cells.Kinds.size());
  for (int cell = 0; cell < static_cast<int>(sets.size()); ++cell)
  {
    for (const std::vector<int>& face : shape::GetFaces(cells.Kinds(cell)))
    {
      std::set<Position> positions;
      for (const int corner : face)
      {
        positions.insert(At(cells.Points, cells.Corners(cells.Offsets(cell) + corner)));
      }
      sets[cell].insert(positions);
    }
  }
  return sets;
}

FaceSets FacesOf(const shape::PolyMesh& mesh)
{
  FaceSets sets(mesh.CellCount);
  for (Eigen::Index face = 0; face < mesh.Faces.rows(); ++face)
  {
    std::set<Position> positions;
    for (int k = 0; k < CountCorners(mesh, face); ++k)
    {
      positions.insert(At(mesh.Points, mesh.Faces(face, k)));
    }
    sets[mesh.Owners(face)].insert(positions);
    if (face < mesh.Neighbours.size())
    {
      sets[mesh.Neighbours(face)].insert(positions);
    }
  }
  return sets;
}

/// Checks what is true of the faces of any mesh.
void CheckFaces(const shape::PolyMesh& mesh, const shape::Cells& cells)
{
  EXPECT_EQ(FacesOf(mesh), FacesOf(cells));
  std::set<std::set<int>> once;
  for (Eigen::Index face = 0; face < mesh.Faces.rows(); ++face)
  {
    const Eigen::RowVectorXi corners = mesh.Faces.row(face).head(CountCorners(mesh, face));
    EXPECT_TRUE(once.insert({ corners.begin(), corners.end() }).second) << face;
  }
  for (Eigen::Index face = 0; face < mesh.Neighbours.size(); ++face)
  {
    EXPECT_LT(mesh.Owners(face), mesh.Neighbours(face));
    if (face > 0)
    {
      EXPECT_LT(std::tie(mesh.Owners(face - 1), mesh.Neighbours(face - 1)),
        std::tie(mesh.Owners(face), mesh.Neighbours(face)));
    }
  }
  auto next = static_cast<int>(mesh.Neighbours.size());
  for (const shape::FacePatch& patch : mesh.Patches)
  {
    EXPECT_EQ(patch.First, next);
    EXPECT_GT(patch.Count, 0);
    next += patch.Count;
  }
  EXPECT_EQ(next, mesh.Faces.rows());
  const Closure closure(mesh);
  EXPECT_LT(closure.Gaps.cwiseAbs().maxCoeff(), 1e-14 * cells.Points.cwiseAbs().maxCoeff());
  EXPECT_GT(closure.Volumes.minCoeff(), 0.0);
}

} // namespace

TEST(PolyMesh, HasEachFaceOnceInUpperTriangularOrder)
{
  for (const shape::Cells& cells : { BentCubes(), Tetrahedra(), shapetest::OneOfEach() })
  {
    CheckFaces(Make(cells), cells);
  }
}

TEST(PolyMesh, FillsTheVolumeOfTheCells)
{
  const Eigen::Vector4d volumes = Closure(Make(shapetest::OneOfEach())).Volumes;
  EXPECT_LT((volumes - Eigen::Vector4d(1.0, 1.0 / 3.0, 0.5, 1.0 / 6.0)).norm(), 1e-15);
  const Eigen::VectorXd sixths = Closure(Make(Tetrahedra())).Volumes;
  EXPECT_LT((sixths.array() - 1.0 / 6.0).abs().maxCoeff(), 1e-14);
}

TEST(PolyMesh, TurnsCellsThatAreNumberedInsideOut)
{
  // All of them, as in a mirror, and some of them.
  shape::Cells cells = BentCubes();
  cells.Points.col(1) *= -1.0;
  CheckFaces(Make(cells), cells);
  cells = Tetrahedra();
  for (Eigen::Index cell = 0; cell < cells.Kinds.size(); cell += 3)
  {
    std::swap(cells.Corners(cells.Offsets(cell)), cells.Corners(cells.Offsets(cell) + 1));
  }
  CheckFaces(Make(cells), cells);
}

TEST(PolyMesh, TakesFlatCellsAsTheyAreNumbered)
{
  // The apex of the tetrahedron lies in its base, but for rounding.
  shape::Cells cells = shapetest::OneOfEach();
  cells.Points.rowwise() += Eigen::RowVector3d(0.1, 0.7, 0.3);
  std::mt19937_64 generator(13);
  std::uniform_real_distribution<double> uniform(0.1, 0.4);
  int negative = 0;
  for (int i = 0; i < 500; ++i)
  {
    const double a = uniform(generator), b = uniform(generator);
    cells.Points.row(11) =
      a * cells.Points.row(5) + b * cells.Points.row(6) + (1.0 - a - b) * cells.Points.row(8);
    const shape::PolyMesh mesh = Make(cells);
    EXPECT_EQ(FacesOf(mesh), FacesOf(cells));
    EXPECT_NEAR(Closure(mesh).Volumes(3), 0.0, 1e-15);
    negative += Closure(mesh).Volumes(3) < 0.0 ? 1 : 0;
  }
  EXPECT_GT(negative, 0) << "the case is among them";
}

TEST(PolyMesh, DividesCellsIntoZonesAndOrientsInterfaces)
{
  const shape::Cells cells = BentCubes();
  Eigen::VectorXi regions(cells.Kinds.size());
  std::mt19937 generator(11);
  for (int& region : regions)
  {
    region = 4 * static_cast<int>(generator() % 3);
  }
  const shape::PolyMesh mesh = Make(cells, regions);
  CheckFaces(mesh, cells);
  std::map<std::string, Eigen::RowVector3d> open; // sums of the area vectors of each region
  for (const shape::CellZone& zone : mesh.CellZones)
  {
    for (const int cell : zone.Cells)
    {
      EXPECT_EQ(zone.Name, "Region" + std::to_string(regions(cell)));
    }
    EXPECT_EQ(static_cast<Eigen::Index>(zone.Cells.size()),
      (regions.array() == regions(zone.Cells[0])).count());
    open[zone.Name.substr(6)] = Eigen::RowVector3d::Zero();
  }
  ASSERT_EQ(mesh.CellZones.size(), 3u);
  for (Eigen::Index face = mesh.Neighbours.size(); face < mesh.Faces.rows(); ++face)
  {
    open[std::to_string(regions(mesh.Owners(face)))] += Flux(mesh, face).first;
  }
  ASSERT_EQ(mesh.FaceZones.size(), 3u);
  std::size_t count = 0;
  for (const shape::FaceZone& zone : mesh.FaceZones)
  {
    const std::string lower = zone.Name.substr(9, 1), upper = zone.Name.substr(11, 1);
    ASSERT_EQ(zone.Name, "Interface" + lower + "_" + upper);
    EXPECT_LT(lower, upper);
    for (std::size_t i = 0; i < zone.Faces.size(); ++i)
    {
      const Eigen::RowVector3d area =
        (zone.Flips[i] ? -1.0 : 1.0) * Flux(mesh, zone.Faces[i]).first;
      open[lower] += area;
      open[upper] -= area;
    }
    count += zone.Faces.size();
  }
  // The patches and the interfaces close each region.
  for (const auto& [region, gap] : open)
  {
    EXPECT_LT(gap.norm(), 1e-13) << region;
  }
  std::size_t between = 0;
  for (Eigen::Index face = 0; face < mesh.Neighbours.size(); ++face)
  {
    between += regions(mesh.Owners(face)) != regions(mesh.Neighbours(face)) ? 1 : 0;
  }
  EXPECT_EQ(count, between);
}

TEST(PolyMesh, LeavesOutPointsWithoutCellsAndPatchesWithoutFaces)
{
  const shape::Cells cells =
    shapetest::Cubes({ 3, 3, 3 }, [](int x, int y, int z) { return x + y + z < 4; });
  Eigen::MatrixXi patches = Eigen::MatrixXi::Constant(cells.Kinds.size(), 6, 7);
  const shape::PolyMesh mesh = shape::MakePolyMesh(shape::FindMeshSets(cells, {}, 40.0, patches));
  CheckFaces(mesh, cells);
  const std::set<int> used(cells.Corners.begin(), cells.Corners.end());
  ASSERT_LT(used.size(), static_cast<std::size_t>(cells.Points.rows()));
  const std::vector<int> kept(used.begin(), used.end());
  EXPECT_EQ(mesh.Points, cells.Points(kept, Eigen::all).eval());
  ASSERT_EQ(mesh.Patches.size(), 1u);
  EXPECT_EQ(mesh.Patches[0].Name, "Patch7");
}

TEST(PolyMesh, RefusesWhatTheFormatDoesNotHave)
{
  const Eigen::MatrixXd points = shapetest::OneOfEach().Points;
  const auto refusal = [&](const std::vector<std::pair<int, std::vector<int>>>& cells)
  {
    shapetest::CellList list;
    for (const auto& [kind, corners] : cells)
    {
      list.Add(kind, corners);
    }
    return shapetest::Refusal([&] { Make(list.Over(points)); });
  };
  const std::vector<int> cube = { 0, 1, 2, 3, 4, 5, 6, 7 };
  EXPECT_TRUE(
    shapetest::HasWords(refusal({ { Hexahedron, cube }, { Quadrilateral, { 0, 1, 2, 3 } } }),
      { "1 cell without a volume (first cell 1)", "Extract Cells By Type" }));
  EXPECT_TRUE(shapetest::HasWords(
    refusal({ { Hexahedron, { 0, 1, 2, 3, 4, 4, 6, 7 } } }), { "cell 0 has the point 4 twice" }));
  EXPECT_TRUE(shapetest::HasWords(refusal({ { Pyramid, { 4, 5, 6, 7, 8 } }, { Hexahedron, cube },
                                    { Pyramid, { 4, 5, 6, 7, 11 } } }),
    { "3 cells of the Input have the same face (0, 1 and 2)", "remove" }));
  // The pyramid's apex is in the cube.
  Eigen::MatrixXd inverted = points;
  inverted.row(8) << 0.5, 0.5, 0.5;
  shapetest::CellList list;
  list.Add(Hexahedron, cube);
  list.Add(Pyramid, { 4, 5, 6, 7, 8 });
  EXPECT_REFUSED(Make(list.Over(inverted)), "both cells of 1 face are on the same side",
    "first cells 0 and 1", "Shape Untangle");
}
