#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/SparseCore>

namespace shape
{

/// The shape of each triangle, well defined even if it is degenerate. Rows are triangles, columns
/// their corners.
struct TriangleAngles
{
  /// m x 3: cotangent of the angle at each corner; at most a few million
  Eigen::MatrixXd Cotangents;
  Eigen::VectorXd Areas; ///< m, in the model's units squared
};

/**
 * Computes the cotangents of the corner angles, from the edge lengths.
 *
 * If a triangle is nearly degenerate, its three lengths are increased by the same minimum amount.
 * Then the sum of any two exceeds the third by 1e-6 of the longest (intrinsic mollification: Sharp
 * & Crane 2020, section 4.5, for each triangle). So each triangle's Dirichlet form is positive
 * semi-definite and finite even for needles, caps and triangles without area. A triangle whose
 * corners coincide is treated as equilateral.
 */
TriangleAngles ComputeTriangleAngles(const Mesh& mesh);

/// Computes the same from the lengths of the edges (m x 3) opposite each corner.
TriangleAngles ComputeAnglesFromLengths(const Eigen::MatrixXd& lengths);

/**
 * Builds the cotangent stiffness matrix L (n x n, positive semi-definite, both triangular parts
 * stored). L_ij is -(cot a + cot b) / 2 over the two angles opposite the edge ij, and rows sum to
 * zero. The quadratic form x^T L x / 2 is the Dirichlet energy (Pinkall & Polthier 1993). Every
 * diagonal entry is stored.
 */
Eigen::SparseMatrix<double> BuildCotangentStiffness(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& cotangents, Eigen::Index points);

/// Computes the lumped masses of points (n): a third of the area of the triangles around each; 0 at
/// points without a triangle.
Eigen::VectorXd ComputeLumpedMasses(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& areas, Eigen::Index points);

/**
 * Returns `stiffness` with every edge weight -L_ij raised to `minimum`, and the diagonal to match.
 * The result is an M-matrix, so solutions obey the maximum principle, which obtuse angles may
 * otherwise violate. Edges whose weight is raised no longer preserve angles.
 */
Eigen::SparseMatrix<double> BuildPositiveStiffness(
  const Eigen::SparseMatrix<double>& stiffness, double minimum);

} // namespace shape
