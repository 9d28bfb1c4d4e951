#pragma once

#include "Laplacian/CotangentWeights.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace shape
{

/// Triangles given by the lengths of their edges, without positions. Two may share two edges, and
/// an edge may be glued to another one of the same triangle.
struct IntrinsicTriangles
{
  Eigen::MatrixXi Triangles; ///< m x 3, points
  Eigen::MatrixXd Sides;     ///< m x 3: lengths of the edges opposite each corner
};

/**
 * The intrinsic Delaunay triangulation of a surface, over the same points: its edges are straight
 * on the surface, and the two angles opposite an edge add up to pi at most. So no cotangent weight
 * of an inner edge is negative, whatever the triangles of the surface are (Bobenko and Springborn,
 * "A discrete Laplace-Beltrami operator for simplicial surfaces", 2007).
 *
 * First all edges are lengthened by the same minimum length for which every two edges of a triangle
 * exceed the third by 1e-6 of the mean edge: the "intrinsic mollification" of Sharp and Crane, "A
 * Laplacian for nonmanifold triangle meshes", 2020, section 4.5. Then edges that are not Delaunay
 * are flipped until none is left (section 3.1 there). Boundary edges stay.
 *
 * surface: a consistently oriented 2-manifold, open or closed (RequireManifold). Throws
 * SolveFailure if the flips do not end.
 */
IntrinsicTriangles BuildIntrinsicDelaunay(const Surface& surface);

/// The Laplacian of a surface on its intrinsic Delaunay triangulation.
struct IntrinsicLaplacian
{
  IntrinsicTriangles Flat;               ///< BuildIntrinsicDelaunay
  TriangleAngles Angles;                 ///< ComputeAnglesFromLengths of it
  Eigen::SparseMatrix<double> Stiffness; ///< n x n: BuildCotangentStiffness of these
  Eigen::VectorXd Masses;                ///< n: ComputeLumpedMasses of these
};

/// The intrinsic Laplacian, which is built once and kept with the surface. Arguments and exceptions
/// as above.
std::shared_ptr<const IntrinsicLaplacian> GetIntrinsicLaplacian(const Surface& surface);

} // namespace shape
