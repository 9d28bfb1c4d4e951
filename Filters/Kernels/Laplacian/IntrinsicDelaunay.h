#pragma once

#include "Laplacian/CotangentWeights.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>

namespace shape
{

/// Triangles given by their edge lengths instead of positions. Two triangles may share two edges,
/// and two edges of the same triangle may be glued together.
struct IntrinsicTriangles
{
  Eigen::MatrixXi Triangles; ///< m x 3, indices of points
  Eigen::MatrixXd Sides;     ///< m x 3: length of the edge opposite each corner
};

/**
 * Builds the intrinsic Delaunay triangulation of a surface on the same points. Its edges are
 * straight on the surface, and the two angles opposite an edge add up to at most pi. So no inner
 * edge has a negative cotangent weight, whatever the triangles of the surface (Bobenko and
 * Springborn, "A discrete Laplace-Beltrami operator for simplicial surfaces", 2007).
 *
 * First all edges are lengthened by the same amount: the smallest with which the sum of any two
 * edges of a triangle exceeds the third by 1e-6 of the mean edge length. This is the intrinsic
 * mollification of Sharp and Crane, "A Laplacian for nonmanifold triangle meshes", 2020, section
 * 4.5. Then edges that are not Delaunay are flipped until none is left (section 3.1). Boundary
 * edges are kept.
 *
 * If an edge has three or more triangles, or two triangles with the same direction, the triangles
 * are those of the tufted cover (BuildTuftedCover): each triangle twice, glued to a closed surface.
 *
 * surface: triangles with three different points. Throws SolveFailure if the flips do not end.
 */
IntrinsicTriangles BuildIntrinsicDelaunay(const Surface& surface);

/// The Laplacian of a surface on its intrinsic Delaunay triangulation.
struct IntrinsicLaplacian
{
  IntrinsicTriangles Flat;               ///< the result of BuildIntrinsicDelaunay
  int Copies = 1;                        ///< of each triangle in Flat: 2 if it is a tufted cover
  TriangleAngles Angles;                 ///< ComputeAnglesFromLengths of Flat
  Eigen::SparseMatrix<double> Stiffness; ///< n x n: BuildCotangentStiffness of Flat / Copies
  Eigen::VectorXd Masses;                ///< n: ComputeLumpedMasses of Flat / Copies
};

/// Returns the intrinsic Laplacian of a surface, which is built once and cached in the surface.
/// Takes the same argument and throws the same exceptions as BuildIntrinsicDelaunay.
std::shared_ptr<const IntrinsicLaplacian> GetIntrinsicLaplacian(const Surface& surface);

} // namespace shape
