#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// A rim: a closed curve, and which way a surface leaves it. The surface is to its left, seen from
/// the tips of the normals.
struct BoundaryLoop
{
  Eigen::MatrixXd Points;  ///< k x 3
  Eigen::MatrixXd Normals; ///< k x 3: unit normals of the surface
};

/**
 * A surface tangent to the rim's normals, as smooth as a linear equation makes it: places of the
 * points of a disk (n x 3), the rim first, whose bilaplacian is zero, by mixed finite elements: the
 * Laplacian at the rim is what the conormals there ask for. Not invariant to how the disk is
 * stretched; a start for SolveFairSurface.
 *
 * disk: n points, in the plane or in space. Throws SolveFailure.
 */
Eigen::MatrixXd SolveBiharmonicSurface(const Mesh& disk, const BoundaryLoop& loop);

struct FairSurfaceOptions
{
  int MaximumIterations = 15; ///< >= 1
  double Tolerance = 1e-3;    ///< how far a point still moves, in mean edges of the rim; > 0
};

struct FairSurfaceResult
{
  Eigen::MatrixXd Points; ///< n x 3: the rim first
  int Iterations = 0;
  bool Converged = false;
};

/**
 * The surface through a rim, tangent to its normals, whose mean curvature is harmonic on it
 * (Schneider and Kobbelt, "Geometric fairing of irregular meshes for free-form surface design",
 * 2001): planes, spheres, cylinders and all other surfaces of constant mean curvature come out as
 * they are, whatever the triangles.
 *
 * The mean curvature of a point is the part along its normal of the cotangent Laplacian of the
 * places over twice the Voronoi area, at the rim with the triangles and the area on the patch's
 * side only, which asks for the rim's normals by mixed finite elements; inside, the normal is that
 * of Max, "Weights for computing vertex normals from facet normals", 1999. With these both are
 * exact on any triangles whose corners lie on a sphere. Newton's method moves the points along
 * their normals; in its derivative the mean curvature changes by the Laplacian of the displacement
 * and by it times the sum of the squared principal curvatures.
 *
 * start: any surface, the rim its first points; better are the triangles of equal sides. Near the
 * solution the factorisation is kept from one iteration to the next. Where the iterations do not
 * converge the smoothest surface met, by the Dirichlet energy of the mean curvature, is the result.
 * Throws SolveFailure where a sparse factorisation breaks down; Aborted.
 */
FairSurfaceResult SolveFairSurface(const Mesh& start, const Eigen::MatrixXd& loopNormals,
  const FairSurfaceOptions& options = {}, const Progress& progress = {});

} // namespace shape
