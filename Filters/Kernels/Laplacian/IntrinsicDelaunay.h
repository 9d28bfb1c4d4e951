#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// Triangles that know the lengths of their sides but not where they are. Two may share two sides,
/// and a side may be glued to another one of the same triangle.
struct IntrinsicTriangles
{
  Eigen::MatrixXi Triangles; ///< m x 3, points
  Eigen::MatrixXd Sides;     ///< m x 3: the side opposite each corner, for ComputeAnglesFromLengths
};

/**
 * The Delaunay triangulation of the surface that a mesh is, over the same points: its edges are
 * straight on the surface, and no two angles opposite an edge are more than pi together. So no
 * cotangent weight of an edge inside is negative, whatever the mesh's triangles are (Bobenko and
 * Springborn, "A discrete Laplace-Beltrami operator for simplicial surfaces", 2007).
 *
 * First all sides are made longer by the same least length that makes every two of a triangle
 * exceed the third by 1e-6 of the mean side: the "intrinsic mollification" of Sharp and Crane, "A
 * Laplacian for nonmanifold triangle meshes", 2020, section 4.5; then edges are flipped that are
 * not Delaunay, until none is (section 3.1 there). Edges on the border stay.
 *
 * mesh: a consistently oriented 2-manifold, open or closed (RequireManifold). Throws SolveFailure
 * where flips do not end.
 */
IntrinsicTriangles BuildIntrinsicDelaunay(const Mesh& mesh);

} // namespace shape
