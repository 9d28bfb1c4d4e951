#pragma once

#include "Support/SolverMeshes.h"

#include <random>
#include <vector>

// Cubes of cells to untangle.
namespace shapetest
{

/// Returns the cube [0, 1]^3 of n^3 cells: hexahedra, or six tetrahedra, two wedges or six pyramids
/// each.
inline shape::Cells BuildCube(int n, int kind)
{
  std::vector<Eigen::RowVector3d> points;
  CellList cells;
  const auto at = [&](int i, int j, int k) { return (k * (n + 1) + j) * (n + 1) + i; };
  for (int k = 0; k <= n; ++k)
  {
    for (int j = 0; j <= n; ++j)
    {
      for (int i = 0; i <= n; ++i)
      {
        points.push_back(Eigen::RowVector3d(i, j, k) / n);
      }
    }
  }
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        const int h[8] = { at(i, j, k), at(i + 1, j, k), at(i + 1, j + 1, k), at(i, j + 1, k),
          at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1) };
        if (kind == 12)
        {
          cells.Add(kind, { h, h + 8 });
        }
        else if (kind == 13)
        {
          cells.Add(kind, { h[0], h[1], h[2], h[4], h[5], h[6] });
          cells.Add(kind, { h[0], h[2], h[3], h[4], h[6], h[7] });
        }
        else if (kind == 10)
        {
          const int around[7] = { 1, 2, 3, 7, 4, 5, 1 };
          for (int t = 0; t < 6; ++t)
          {
            cells.Add(kind, { h[0], h[around[t]], h[around[t + 1]], h[6] });
          }
        }
        else
        {
          const int faces[6][4] = { { 0, 1, 2, 3 }, { 4, 7, 6, 5 }, { 0, 4, 5, 1 }, { 3, 2, 6, 7 },
            { 0, 3, 7, 4 }, { 1, 5, 6, 2 } };
          points.push_back((points[h[0]] + points[h[6]]) / 2.0);
          for (const auto& f : faces)
          {
            const int apex = static_cast<int>(points.size()) - 1;
            cells.Add(kind, { h[f[0]], h[f[1]], h[f[2]], h[f[3]], apex });
          }
        }
      }
    }
  }
  Eigen::MatrixXd positions(points.size(), 3);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    positions.row(static_cast<Eigen::Index>(i)) = points[i];
  }
  return cells.Over(positions);
}

/// Whether a point of it is not on its boundary.
inline bool IsInCube(const Eigen::RowVector3d& p)
{
  return p.minCoeff() > 1e-9 && p.maxCoeff() < 1.0 - 1e-9;
}

/// Moves its inner points by up to `reach` along each axis.
inline Eigen::MatrixXd ShakeInCube(Eigen::MatrixXd points, double reach, unsigned int seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-reach, reach);
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    if (IsInCube(points.row(i)))
    {
      points.row(i) += Eigen::RowVector3d(uniform(random), uniform(random), uniform(random));
    }
  }
  return points;
}

} // namespace shapetest
