#pragma once

#include "Mesh/HexMesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The scaled Jacobian of a hexahedron, as Verdict has it (Stimpson, Ernst, Knupp, Pebay and
 * Thompson, "The Verdict geometric quality library", 2007, section 7.12): the least, over the eight
 * corners and the centre, of the determinant of the three edges there, divided by their lengths. 1
 * for a box, positive in one that solvers accept, -1 where an edge has no length.
 *
 * corners: 8 x 3, in VTK's order.
 */
double ComputeScaledJacobian(const Eigen::Matrix<double, 8, 3>& corners);

/// Those of all hexahedra (m).
Eigen::VectorXd ComputeScaledJacobians(const HexMesh& mesh);

/// The least of hexahedra that have none of these points; 1, that of a box, where there are none.
double FindMinimumScaledJacobianAwayFrom(const std::vector<int>& points, const HexMesh& mesh);

/// Marks, of n points, those of hexahedra with a lower scaled Jacobian; empty where there is none.
std::vector<char> MarkPointsOfBadHexahedra(const HexMesh& mesh, double bad);

} // namespace shape
