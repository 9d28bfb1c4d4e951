#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/SparseCore>

namespace shape
{

/// The shape of each triangle, whatever the triangle: rows are triangles, columns their corners.
struct TriangleAngles
{
  Eigen::MatrixXd Cotangents; ///< m x 3: of the angle at each corner; within a few million
  Eigen::VectorXd Areas;      ///< m, in the model's units squared
};

/**
 * Cotangents of the corner angles, from edge lengths.
 *
 * If a triangle is nearly degenerate, its three lengths are raised by the minimum for which every
 * two of them exceed the third by 1e-6 of the longest: "intrinsic mollification" of Sharp &
 * Crane 2020, section 4.5, triangle by triangle. So each triangle's Dirichlet form is positive
 * semi-definite and finite even for needles, caps and triangles without area; a triangle whose
 * corners coincide counts as equilateral.
 */
TriangleAngles ComputeTriangleAngles(const Mesh& mesh);

/// The same from the lengths of the edges (m x 3) opposite each corner.
TriangleAngles ComputeAnglesFromLengths(const Eigen::MatrixXd& lengths);

/**
 * The cotangent stiffness matrix (n x n, both triangles stored, positive semi-definite):
 * L_ij = -(cot a + cot b) / 2 over the two angles opposite the edge ij, rows sum to zero; x^T L x /
 * 2 is the Dirichlet energy (Pinkall & Polthier 1993). Every diagonal entry is stored.
 */
Eigen::SparseMatrix<double> BuildCotangentStiffness(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& cotangents, Eigen::Index points);

/// The masses of points (n): a third of the area of the triangles around each, in their units
/// squared; 0 at points without a triangle.
Eigen::VectorXd ComputeLumpedMasses(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& areas, Eigen::Index points);

/**
 * `stiffness` with every edge weight -L_ij raised to `minimum` and the diagonal to match: an
 * M-matrix, whose solutions obey the maximum principle, which obtuse angles break otherwise. Edges
 * whose weight is raised no longer keep angles.
 */
Eigen::SparseMatrix<double> BuildPositiveStiffness(
  const Eigen::SparseMatrix<double>& stiffness, double minimum);

} // namespace shape
