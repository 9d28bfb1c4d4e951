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
 * The biharmonic surface with given normals at its boundary loop: positions of the points of a disk
 * (n x 3), the loop first, whose bilaplacian is zero. By mixed finite elements, the conormals at
 * the loop determine the Laplacian there. It depends on how the disk is stretched; an initial
 * surface for SolveFairSurface.
 *
 * disk: n points, in the plane or in space. Throws SolveFailure.
 */
Eigen::MatrixXd SolveBiharmonicSurface(const Mesh& disk, const BoundaryLoop& loop);

struct FairSurfaceOptions
{
  int MaximumIterations = 15; ///< >= 1
  double Tolerance = 1e-3;    ///< how far a point still moves, in mean edges of the loop; > 0
};

struct FairSurfaceResult
{
  Eigen::MatrixXd Points; ///< n x 3: the loop first
  int Iterations = 0;
  bool Converged = false;
};

/**
 * The surface with given normals at its boundary loop whose mean curvature is harmonic on it
 * (Schneider and Kobbelt, "Geometric fairing of irregular meshes for free-form surface design",
 * 2001): it reproduces planes, spheres, cylinders and all other surfaces of constant mean
 * curvature, whatever the triangles.
 *
 * The mean curvature of a point is the normal component of the cotangent Laplacian of the positions
 * over twice the Voronoi area; at the loop, with the triangles and the area of the patch only,
 * which imposes the loop's normals by mixed finite elements. Inside, the normal is that of
 * NormalWeight::Max. So both are exact on any triangles whose corners lie on a sphere. Newton's
 * method moves the points along their normals; in its derivative, the mean curvature changes by the
 * Laplacian of the displacement, and by the displacement times the sum of the squared principal
 * curvatures.
 *
 * start: any surface, the loop its first points; equilateral triangles are best. Near the solution
 * the factorisation is kept from one iteration to the next. If the iterations do not converge, the
 * result is the smoothest surface met, by the Dirichlet energy of the mean curvature. Throws
 * SolveFailure if a sparse factorisation fails; Aborted.
 */
FairSurfaceResult SolveFairSurface(const Mesh& start, const Eigen::MatrixXd& loopNormals,
  const FairSurfaceOptions& options = {}, const Progress& progress = {});

} // namespace shape
