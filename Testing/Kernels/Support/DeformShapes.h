#pragma once

#include "Deform/BoundaryHandle.h"
#include "Geometry/PointGraph.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Mesh.h"
#include "Support/TestShapes.h"

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

// Functions shared by the tests of deformations.
namespace shapetest
{

inline shape::ShapeElements ElementsOf(const shape::Mesh& mesh)
{
  return { mesh.Points, Eigen::MatrixXi(0, 2), mesh.Triangles, Eigen::MatrixXi(0, 4) };
}

/// Returns a bumpy cap over the unit disk. Its boundary is that of the disk.
inline shape::Mesh Cap(int rings)
{
  shape::Mesh cap = FlatDisk(rings);
  for (auto row : cap.Points.rowwise())
  {
    const double r = row.head<2>().norm();
    row(2) = 0.8 * (1.0 - r * r) + 0.1 * std::sin(7.0 * row(0)) * std::cos(5.0 * row(1));
  }
  return cap;
}

/// Returns an open tube of radius 1 around the z axis from 0 to `height`. It consists of `around` x
/// `along` quads of two triangles each; point j + around i is at height i.
inline shape::Mesh Tube(int around, int along, double height)
{
  shape::Mesh tube{ Eigen::MatrixXd(around * (along + 1), 3),
    Eigen::MatrixXi(2 * around * along, 3) };
  for (int i = 0; i <= along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const double angle = 2.0 * M_PI * j / around;
      tube.Points.row(around * i + j) << std::cos(angle), std::sin(angle), height * i / along;
    }
  }
  for (int i = 0; i < along; ++i)
  {
    for (int j = 0; j < around; ++j)
    {
      const int a = around * i + j, b = around * i + (j + 1) % around;
      tube.Triangles.row(2 * (around * i + j)) << a, b, b + around;
      tube.Triangles.row(2 * (around * i + j) + 1) << a, b + around, a + around;
    }
  }
  return tube;
}

/// Returns the box [-1, 1] x [-1, 1] x [0, height] as cells x cells x layers cubes of six
/// tetrahedra each.
inline shape::ShapeElements Block(int cells, int layers, double height)
{
  const auto at = [&](int i, int j, int k) { return i + (cells + 1) * (j + (cells + 1) * k); };
  shape::ShapeElements block;
  block.Points.resize((cells + 1) * (cells + 1) * (layers + 1), 3);
  block.Tetrahedra.resize(6 * cells * cells * layers, 4);
  const int corners[6][2] = { { 1, 3 }, { 3, 2 }, { 2, 6 }, { 6, 4 }, { 4, 5 }, { 5, 1 } };
  int row = 0;
  for (int k = 0; k <= layers; ++k)
  {
    for (int j = 0; j <= cells; ++j)
    {
      for (int i = 0; i <= cells; ++i)
      {
        block.Points.row(at(i, j, k)) << 2.0 * i / cells - 1.0, 2.0 * j / cells - 1.0,
          height * k / layers;
        if (i == cells || j == cells || k == layers)
        {
          continue;
        }
        const auto corner = [&](int c) { return at(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)); };
        for (const auto& pair : corners) // all around the diagonal from corner 0 to corner 7
        {
          block.Tetrahedra.row(row++) << corner(0), corner(pair[0]), corner(pair[1]), corner(7);
        }
      }
    }
  }
  return block;
}

/// Returns the longest boundary loop as a handle.
inline shape::BoundaryHandle LoopOf(const shape::Mesh& surface)
{
  const std::vector<int> loop = shape::FindManifoldBoundaryLoops(surface).front();
  return shape::BuildCurveHandle(surface.Points(loop, Eigen::all), true);
}

inline Eigen::Matrix3d SomeRotation()
{
  return Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
}

inline Eigen::MatrixXd Moved(const Eigen::MatrixXd& points, const Eigen::Matrix3d& turn,
  double scale, const Eigen::RowVector3d& shift)
{
  return (scale * points * turn.transpose()).rowwise() + shift;
}

/// Bends positions about the y axis like a strip on a cylinder of this radius: x becomes an angle.
inline Eigen::MatrixXd Bent(Eigen::MatrixXd positions, double radius)
{
  for (auto row : positions.rowwise())
  {
    const double angle = row(0) / radius, distance = radius + row(2);
    row(0) = distance * std::sin(angle);
    row(2) = distance * std::cos(angle) - radius;
  }
  return positions;
}

inline double Largest(const Eigen::MatrixXd& difference)
{
  return difference.rowwise().norm().maxCoeff();
}

} // namespace shapetest
