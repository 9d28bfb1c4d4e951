#include "Hex/Releasing.h"
#include "Quality/ScaledJacobian.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace
{

/// Points of the sides of a box stay where they are; the others are free.
class SidesStay : public shape::PointConstraint
{
public:
  explicit SidesStay(std::vector<char> onSide)
    : OnSide(std::move(onSide))
  {
  }
  int Freedom(int point) const override { return this->OnSide[point] ? 0 : 3; }
  shape::PointDirections Directions(int, const Eigen::RowVector3d&) const override
  {
    return Eigen::Matrix<double, 3, 0>();
  }
  Eigen::RowVector3d Nearest(int, const Eigen::RowVector3d& place) const override { return place; }

private:
  const std::vector<char> OnSide;
};

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
  ASSERT_LT(shape::ScaledJacobians(mesh).minCoeff(), 0.0);
  const int released = shape::ReleaseInverted(mesh, SidesStay(onSide));
  EXPECT_GT(shape::ScaledJacobians(mesh).minCoeff(), 0.2);
  EXPECT_GE(released, 2);
  EXPECT_LT(released, (Side + 1) * (Side + 1));
  for (int x = 0; x <= Side; ++x)
  {
    EXPECT_EQ(mesh.Points.row(Id(x, 3, 0)), flat.row(Id(x, 3, 0)));
  }
}

TEST(Releasing, NothingIsMovedWhereNothingIsInverted)
{
  std::vector<char> onSide;
  shape::HexMesh mesh = Cubes(onSide);
  const Eigen::MatrixXd before = mesh.Points;
  EXPECT_EQ(shape::ReleaseInverted(mesh, SidesStay(onSide)), 0);
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
  EXPECT_EQ(shape::ReleaseInverted(mesh, SidesStay(onSide)), 0);
  EXPECT_EQ(mesh.Points, before);
}
