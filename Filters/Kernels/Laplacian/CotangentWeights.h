#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/SparseCore>

namespace shape
{

/// The shape of each triangle, well defined even for degenerate triangles. Rows are triangles,
/// columns their corners.
struct TriangleAngles
{
  /// m x 3: cotangent of the angle at each corner; its absolute value is at most a few million
  Eigen::MatrixXd Cotangents;
  Eigen::VectorXd Areas; ///< m areas, in the model's units squared
};

/**
 * Computes the cotangents of the corner angles and the areas of triangles, from their edge lengths.
 *
 * If a triangle is nearly degenerate, its three lengths are increased by the same amount: the
 * smallest with which the sum of any two exceeds the third by 1e-6 of the longest (intrinsic
 * mollification: Sharp & Crane 2020, section 4.5, for each triangle). So each triangle's Dirichlet
 * form is positive semi-definite and finite even for needles, caps and triangles without area. A
 * triangle whose corners coincide is treated as equilateral.
 */
TriangleAngles ComputeTriangleAngles(const Mesh& mesh);

/// Computes the same from edge lengths (m x 3): entry (t, k) is the length of the edge opposite
/// corner k of triangle t.
TriangleAngles ComputeAnglesFromLengths(const Eigen::MatrixXd& lengths);

/**
 * Builds the cotangent stiffness matrix L (n x n, positive semi-definite, both triangular parts
 * stored). L_ij is -(cot a + cot b) / 2, where a and b are the two angles opposite the edge ij, and
 * rows sum to zero. The quadratic form x^T L x / 2 is the Dirichlet energy (Pinkall & Polthier
 * 1993). Every diagonal entry is stored.
 */
Eigen::SparseMatrix<double> BuildCotangentStiffness(
  const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& cotangents, Eigen::Index points);

/// Computes the lumped masses of n points. The mass of a point is a third of the area of the
/// triangles around it, and 0 if it has no triangle.
Eigen::VectorXd ComputeLumpedMasses(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& areas, Eigen::Index points);

/**
 * Returns `stiffness` with every edge weight -L_ij below `minimum` raised to `minimum`. The
 * diagonal is changed so that rows still sum to zero. The result is an M-matrix, so solutions obey
 * the maximum principle, which obtuse angles may otherwise violate. Where a weight is raised,
 * harmonic maps no longer preserve angles.
 */
Eigen::SparseMatrix<double> BuildPositiveStiffness(
  const Eigen::SparseMatrix<double>& stiffness, double minimum);

} // namespace shape
