#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Computes the scaled Jacobian of a hexahedron as defined by Verdict (Stimpson, Ernst, Knupp, Pebay
 * and Thompson, "The Verdict geometric quality library", 2007, section 7.12). It is the minimum,
 * over the eight corners and the centre, of the determinant of the three edges there divided by
 * their lengths. It is 1 for a box, positive for a hexahedron that solvers accept, and -1 if an
 * edge has no length.
 *
 * corners: 8 x 3, in VTK's order.
 */
double ComputeScaledJacobian(const Eigen::Matrix<double, 8, 3>& corners);

/// Computes the scaled Jacobians of all hexahedra (m).
Eigen::VectorXd ComputeScaledJacobians(const HexMesh& mesh);

/// Returns the minimum over the hexahedra without any of these points; 1 if there are none.
double FindMinimumScaledJacobianAwayFrom(const std::vector<int>& points, const HexMesh& mesh);

/// Marks the points (n) of hexahedra with a scaled Jacobian below `bad`; empty if there are none.
std::vector<char> MarkPointsOfBadHexahedra(const HexMesh& mesh, double bad);

} // namespace shape
