#include "Mesh/CellFaces.h"
#include "Quality/SolidQuality.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace
{

using namespace shape::cell_kind;

/// One cell of a kind at these points.
shape::Cells One(int kind, const std::vector<std::array<double, 3>>& points)
{
  shape::Cells cells;
  const auto count = static_cast<int>(points.size());
  cells.Points.resize(count, 3);
  for (int i = 0; i < count; ++i)
  {
    cells.Points.row(i) << points[i][0], points[i][1], points[i][2];
  }
  cells.Kinds = Eigen::VectorXi::Constant(1, kind);
  cells.Offsets.resize(2);
  cells.Offsets << 0, count;
  cells.Corners = Eigen::VectorXi::LinSpaced(count, 0, count - 1);
  return cells;
}

std::vector<shape::Cells> RegularCells()
{
  const double h = std::sqrt(0.75), top = std::sqrt(0.5);
  return {
    One(Tetrahedron, { { 1, 1, 1 }, { -1, 1, -1 }, { 1, -1, -1 }, { -1, -1, 1 } }),
    One(Pyramid, { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0.5, 0.5, top } }),
    One(
      Wedge, { { 0, 0, 0 }, { 1, 0, 0 }, { 0.5, h, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0.5, h, 1 } }),
    One(Hexahedron,
      { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 1, 1, 1 },
        { 0, 1, 1 } }),
  };
}

/// Two boxes, one on the other, the upper one moved sideways by `slip` of its width at the top.
shape::Cells Stack(double slip)
{
  shape::Cells cells;
  cells.Points.resize(12, 3);
  cells.Points << 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1, slip, 0,
    2, 1 + slip, 0, 2, 1 + slip, 1, 2, slip, 1, 2;
  cells.Kinds = Eigen::VectorXi::Constant(2, Hexahedron);
  cells.Offsets.resize(3);
  cells.Offsets << 0, 8, 16;
  cells.Corners.resize(16);
  cells.Corners << 0, 1, 2, 3, 4, 5, 6, 7, 4, 5, 6, 7, 8, 9, 10, 11;
  return cells;
}

} // namespace

TEST(SolidQuality, RegularCellsAreTheBestAndReflectedOnesInverted)
{
  for (shape::Cells cells : RegularCells())
  {
    const shape::FaceMesh faces = shape::BuildFaceMesh(cells);
    const shape::SolidQuality quality = shape::ComputeSolidQuality(cells, faces);
    EXPECT_NEAR(quality.ScaledJacobian(0), 1.0, 1e-12);
    EXPECT_EQ(quality.Inverted(0), 0);
    // The centre of a pyramid is not above the centres of its sides.
    EXPECT_TRUE(cells.Kinds(0) == Pyramid || quality.Skewness(0) < 1e-12);
    cells.Points.col(0) *= -1.0;
    const shape::SolidQuality reflected = shape::ComputeSolidQuality(cells, faces);
    EXPECT_NEAR(reflected.ScaledJacobian(0), -1.0, 1e-12);
    EXPECT_EQ(reflected.Inverted(0), 1);
  }
}

TEST(SolidQuality, WedgesMayBeNumberedEitherWay)
{
  shape::Cells cells = RegularCells()[2];
  const Eigen::VectorXi corners = cells.Corners;
  cells.Corners << corners.tail(3), corners.head(3);
  EXPECT_NEAR(
    shape::ComputeSolidQuality(cells, shape::BuildFaceMesh(cells)).ScaledJacobian(0), 1.0, 1e-12);
}

TEST(SolidQuality, ShearGivesTheAngleAndTheSkewness)
{
  // The centre of the upper box moves by half of the slip, and that of the face by nothing. So the
  // line is at the angle atan(slip / 2) to the normal, and passes the face's centre at a quarter of
  // the slip, half of the face's width away from the edge.
  for (const double slip : { 0.0, 0.4, 1.0 })
  {
    const shape::Cells cells = Stack(slip);
    const shape::SolidQuality quality =
      shape::ComputeSolidQuality(cells, shape::BuildFaceMesh(cells));
    EXPECT_NEAR(quality.NonOrthogonality(0), std::atan(0.5 * slip) * 180.0 / M_PI, 1e-9);
    EXPECT_EQ(quality.NonOrthogonality(0), quality.NonOrthogonality(1));
    EXPECT_NEAR(quality.Skewness(0), 0.25 * slip / 0.5, 1e-12);
  }
}

TEST(SolidQuality, DoesNotDependOnPositionAndSize)
{
  shape::Cells cells = Stack(0.3);
  cells.Points(9, 2) += 0.2;
  const shape::FaceMesh faces = shape::BuildFaceMesh(cells);
  const shape::SolidQuality one = shape::ComputeSolidQuality(cells, faces);
  const Eigen::Matrix3d turn =
    Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  cells.Points = ((1e-3 * cells.Points * turn).rowwise() + Eigen::RowVector3d(4, -2, 1)).eval();
  const shape::SolidQuality other = shape::ComputeSolidQuality(cells, faces);
  EXPECT_LT((one.ScaledJacobian - other.ScaledJacobian).norm(), 1e-9);
  EXPECT_LT((one.NonOrthogonality - other.NonOrthogonality).norm(), 1e-6);
  EXPECT_LT((one.Skewness - other.Skewness).norm(), 1e-9);
}

TEST(SolidQuality, APolyhedronIsInvertedIfAPointPassesThroughAFace)
{
  shape::Cells cells = RegularCells()[3];
  const std::vector<std::vector<int>>& faces = shape::GetFaces(Hexahedron);
  std::vector<int> stream;
  for (const std::vector<int>& face : faces)
  {
    stream.push_back(4);
    stream.insert(stream.end(), face.begin(), face.end());
  }
  cells.Kinds(0) = shape::PolyhedronKind;
  const shape::FaceMesh mesh = shape::BuildFaceMesh(cells, { stream });
  EXPECT_NEAR(shape::ComputeSolidQuality(cells, mesh).ScaledJacobian(0), 1.0, 1e-12);
  for (const int top : { 4, 5, 6, 7 })
  {
    cells.Points(top, 2) = -1.0;
  }
  EXPECT_EQ(shape::ComputeSolidQuality(cells, mesh).Inverted(0), 1);
}
