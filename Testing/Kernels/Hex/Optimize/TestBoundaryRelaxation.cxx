#include "Hex/Optimize/BoundaryRelaxation.h"
#include "Quality/ScaledJacobian.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace
{

/// Points of the sides of a box stay where they are, although there is a surface that they are on;
/// the others are free.
class SidesStay : public shape::PointConstraint
{
public:
  explicit SidesStay(std::vector<char> onSide, int freedom = 0)
    : OnSide(std::move(onSide))
    , OfSides(freedom)
  {
  }
  int Freedom(int point) const override { return this->OnSide[point] ? this->OfSides : 3; }
  shape::PointDirections Directions(int, const Eigen::RowVector3d&) const override
  {
    return Eigen::Matrix<double, 3, 0>();
  }
  Eigen::RowVector3d Nearest(int, const Eigen::RowVector3d& position) const override
  {
    return position;
  }

private:
  const std::vector<char> OnSide;
  const int OfSides;
};

int Freed(const shape::OverridableConstraint& freedoms, const shape::PointConstraint& given)
{
  int count = 0;
  for (int point = 0; point < static_cast<int>(freedoms.Freedoms.size()); ++point)
  {
    count += freedoms.Freedom(point) > given.Freedom(point) ? 1 : 0;
  }
  return count;
}

constexpr int Side = 6; // unit cubes along each edge of the box

int Id(int x, int y, int z)
{
  return x + (Side + 1) * (y + (Side + 1) * z);
}

shape::HexMesh Cubes(std::vector<char>& onSide)
{
  shape::HexMesh mesh{ Eigen::MatrixXd(Id(Side, Side, Side) + 1, 3),
    Eigen::MatrixXi(Side * Side * Side, 8) };
  onSide.assign(mesh.Points.rows(), 0);
  const auto isEnd = [](int i) { return i == 0 || i == Side; };
  for (int z = 0, hex = 0; z <= Side; ++z)
  {
    for (int y = 0; y <= Side; ++y)
    {
      for (int x = 0; x <= Side; ++x)
      {
        mesh.Points.row(Id(x, y, z)) << x, y, z;
        onSide[Id(x, y, z)] = isEnd(x) || isEnd(y) || isEnd(z) ? 1 : 0;
        if (x < Side && y < Side && z < Side)
        {
          mesh.Hexahedra.row(hex++) << Id(x, y, z), Id(x + 1, y, z), Id(x + 1, y + 1, z),
            Id(x, y + 1, z), Id(x, y, z + 1), Id(x + 1, y, z + 1), Id(x + 1, y + 1, z + 1),
            Id(x, y + 1, z + 1);
        }
      }
    }
  }
  return mesh;
}

} // namespace

TEST(Releasing, PointsThatHoldAHexahedronInvertedAreFreedAndOthersStay)
{
  std::vector<char> onSide;
  shape::HexMesh mesh = Cubes(onSide);
  const Eigen::MatrixXd flat = mesh.Points;
  // Two points of the top change places: what is under the edge between them is inverted.
  mesh.Points.row(Id(3, 3, Side)).swap(mesh.Points.row(Id(4, 3, Side)));
  ASSERT_LT(shape::ComputeScaledJacobians(mesh).minCoeff(), 0.0);
  const SidesStay sides(onSide);
  shape::OverridableConstraint freedoms(sides, mesh.Points.rows());
  shape::RelaxBoundaryOfInverted(mesh, freedoms);
  const int released = Freed(freedoms, sides);
  EXPECT_GT(shape::ComputeScaledJacobians(mesh).minCoeff(), 0.2);
  EXPECT_GE(released, 2);
  EXPECT_LT(released, (Side + 1) * (Side + 1));
  for (int x = 0; x <= Side; ++x)
  {
    EXPECT_EQ(mesh.Points.row(Id(x, 3, 0)), flat.row(Id(x, 3, 0)));
  }
}

TEST(Releasing, PointsOnCreasesStayIfPointsOnPatchesSuffice)
{
  std::vector<char> onSide;
  shape::HexMesh mesh = Cubes(onSide);
  // Beside an edge of the box, whose points are fixed, while others of the sides are on patches.
  mesh.Points.row(Id(3, 1, Side)).swap(mesh.Points.row(Id(4, 1, Side)));
  ASSERT_LT(shape::ComputeScaledJacobians(mesh).minCoeff(), 0.0);
  const SidesStay sides(onSide, 2);
  shape::OverridableConstraint freedoms(sides, mesh.Points.rows());
  const Eigen::MatrixXd before = mesh.Points;
  for (int x = 0; x <= Side; ++x)
  {
    freedoms.Freedoms[Id(x, 0, Side)] = 0;
  }
  shape::RelaxBoundaryOfInverted(mesh, freedoms);
  EXPECT_GT(shape::ComputeScaledJacobians(mesh).minCoeff(), 0.0);
  EXPECT_EQ(freedoms.Freedom(Id(3, 1, Side)), 3);
  for (int x = 0; x <= Side; ++x)
  {
    EXPECT_EQ(freedoms.Freedom(Id(x, 0, Side)), 0);
    EXPECT_EQ(mesh.Points.row(Id(x, 0, Side)), before.row(Id(x, 0, Side)));
  }
}

TEST(Releasing, NothingIsMovedWhereNothingIsInverted)
{
  std::vector<char> onSide;
  shape::HexMesh mesh = Cubes(onSide);
  const Eigen::MatrixXd before = mesh.Points;
  const SidesStay sides(onSide);
  shape::OverridableConstraint freedoms(sides, mesh.Points.rows());
  shape::RelaxBoundaryOfInverted(mesh, freedoms);
  EXPECT_EQ(Freed(freedoms, sides), 0);
  EXPECT_EQ(mesh.Points, before);
}

// Two hexahedra of the same points, one the mirror image of the other: one is always inverted.
TEST(Releasing, NothingIsMovedWhereItDoesNotHelp)
{
  std::vector<char> onSide;
  shape::HexMesh mesh = Cubes(onSide);
  const Eigen::RowVectorXi hex = mesh.Hexahedra.row(0);
  mesh.Hexahedra.conservativeResize(mesh.Hexahedra.rows() + 1, 8);
  mesh.Hexahedra.bottomRows(1) << hex.tail(4), hex.head(4);
  const Eigen::MatrixXd before = mesh.Points;
  const SidesStay sides(onSide);
  shape::OverridableConstraint freedoms(sides, mesh.Points.rows());
  shape::RelaxBoundaryOfInverted(mesh, freedoms);
  EXPECT_EQ(Freed(freedoms, sides), 0);
  EXPECT_EQ(mesh.Points, before);
}

namespace
{

constexpr double Wanted = 0.7;

/// A point of the top is near another one: what is between them is thin.
shape::HexMesh Pressed(std::vector<char>& onSide)
{
  shape::HexMesh mesh = Cubes(onSide);
  mesh.Points(Id(3, 3, Side), 0) = 3.9;
  return mesh;
}

} // namespace

TEST(Releasing, PointsOfASurfaceThatHoldAHexahedronBadAreFreedButNotThoseOfCreases)
{
  for (const int freedom : { 2, 1 })
  {
    std::vector<char> onSide;
    shape::HexMesh mesh = Pressed(onSide);
    const double minimum = shape::ComputeScaledJacobians(mesh).minCoeff();
    ASSERT_GT(minimum, 0.0);
    ASSERT_LT(minimum, Wanted);
    const SidesStay sides(onSide, freedom);
    shape::OverridableConstraint freedoms(sides, mesh.Points.rows());
    shape::RelaxBoundaryOfWorst(mesh, freedoms, Wanted, [](const shape::HexMesh&) { return true; });
    if (freedom == 2)
    {
      EXPECT_GE(shape::ComputeScaledJacobians(mesh).minCoeff(), Wanted);
      EXPECT_GE(Freed(freedoms, sides), 1);
      EXPECT_LT(Freed(freedoms, sides), (Side + 1) * (Side + 1));
    }
    else
    {
      EXPECT_EQ(Freed(freedoms, sides), 0);
    }
  }
}

TEST(Releasing, NothingIsFreedWhereTheResultIsNotAccepted)
{
  std::vector<char> onSide;
  shape::HexMesh mesh = Pressed(onSide);
  const Eigen::MatrixXd before = mesh.Points;
  const SidesStay sides(onSide, 2);
  shape::OverridableConstraint freedoms(sides, mesh.Points.rows());
  shape::RelaxBoundaryOfWorst(mesh, freedoms, Wanted, [](const shape::HexMesh&) { return false; });
  EXPECT_EQ(Freed(freedoms, sides), 0);
  EXPECT_EQ(mesh.Points, before);
}
