#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

namespace shape
{

/// A closed curve that bounds a surface, with the surface's normals. The surface is to its left,
/// seen from the tips of the normals.
struct BoundaryLoop
{
  Eigen::MatrixXd Points;  ///< k x 3
  Eigen::MatrixXd Normals; ///< k x 3: unit normals of the surface
};

/**
 * Computes the biharmonic surface with given normals at its boundary loop: the positions of the
 * points of a disk (n x 3), the loop first, with zero bilaplacian. By mixed finite elements, the
 * conormals at the loop determine the Laplacian there. The surface depends on the stretch of the
 * disk. It is an initial surface for SolveFairSurface.
 *
 * disk: n points, in the plane or in space. Throws SolveFailure.
 */
Eigen::MatrixXd SolveBiharmonicSurface(const Mesh& disk, const BoundaryLoop& loop);

struct FairSurfaceOptions
{
  int MaximumIterations = 15; ///< >= 1
  /// The maximum movement of a point at convergence, in mean edges of the loop; > 0.
  double Tolerance = 1e-3;
};

struct FairSurfaceResult
{
  Eigen::MatrixXd Points; ///< n x 3: the loop first
  int Iterations = 0;
  bool Converged = false;
};

/**
 * Computes the surface with given normals at its boundary loop whose mean curvature is harmonic on
 * it (Schneider and Kobbelt, "Geometric fairing of irregular meshes for free-form surface design",
 * 2001). It reproduces planes, spheres, cylinders and all other surfaces of constant mean
 * curvature, for any triangulation.
 *
 * The mean curvature of a point is the normal component of the cotangent Laplacian of the positions
 * over twice the Voronoi area. At the loop it uses the triangles and the area of the patch only,
 * which imposes the loop's normals by mixed finite elements. Inside, the normal is that of
 * NormalWeight::Max. So both are exact on any triangles whose corners lie on a sphere.
 *
 * Newton's method moves the points along their normals. In its derivative, the mean curvature
 * changes by the Laplacian of the displacement, and by the displacement times the sum of the
 * squared principal curvatures.
 *
 * start: any surface, the loop its first points; equilateral triangles are best. Near the solution
 * the factorisation is reused in the next iterations. If the iterations do not converge, the result
 * is the smoothest surface found, by the Dirichlet energy of the mean curvature. Throws
 * SolveFailure if a sparse factorisation fails; Aborted.
 */
FairSurfaceResult SolveFairSurface(const Mesh& start, const Eigen::MatrixXd& loopNormals,
  const FairSurfaceOptions& options = {}, const Progress& progress = {});

} // namespace shape
