#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Computes the scaled Jacobian of a hexahedron as defined by Verdict (Stimpson, Ernst, Knupp, Pebay
 * and Thompson, "The Verdict geometric quality library", 2007, section 7.12). At each corner, the
 * determinant of the three edges is divided by the product of their lengths; at the centre, the
 * axes between opposite faces replace the edges. The scaled Jacobian is the minimum of these nine
 * values. It is 1 for a box, positive for a hexahedron that solvers accept, and -1 if an edge has
 * no length.
 *
 * corners: 8 x 3, in VTK's order.
 */
double ComputeScaledJacobian(const Eigen::Matrix<double, 8, 3>& corners);

/// Computes the scaled Jacobians of the m hexahedra of a mesh.
Eigen::VectorXd ComputeScaledJacobians(const HexMesh& mesh);

/// Returns the minimum scaled Jacobian of the hexahedra that contain none of `points`; 1 if there
/// are no such hexahedra.
double FindMinimumScaledJacobianAwayFrom(const std::vector<int>& points, const HexMesh& mesh);

/// Marks the points of hexahedra with a scaled Jacobian below `bad`. Returns 1 for each marked
/// point and 0 for each other point (n values), or no values if there are no such hexahedra.
std::vector<char> MarkPointsOfBadHexahedra(const HexMesh& mesh, double bad);

/// The same, given the scaled Jacobians of the hexahedra (m x 8) and the number of points.
template <typename Indices>
std::vector<char> MarkPointsOfBadHexahedra(
  const Indices& hexahedra, const Eigen::VectorXd& values, Eigen::Index points, double bad)
{
  std::vector<char> marked;
  for (Eigen::Index hex = 0; hex < values.size(); ++hex)
  {
    if (values(hex) < bad)
    {
      marked.resize(points, 0);
      for (const int point : hexahedra.row(hex))
      {
        marked[point] = 1;
      }
    }
  }
  return marked;
}

} // namespace shape
