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
 * Computes the biharmonic surface with given normals at its boundary loop. Returns the positions of
 * the disk's points (n x 3), whose bilaplacian is zero. In mixed finite elements, the conormals at
 * the loop determine the Laplacian there. The surface depends on how the disk is stretched. It is
 * an initial surface for SolveFairSurface.
 *
 * disk: n points in the plane or in space, the loop's points first. Throws SolveFailure.
 */
Eigen::MatrixXd SolveBiharmonicSurface(
  const Mesh& disk, const BoundaryLoop& loop, const Progress& progress = {});

struct FairSurfaceOptions
{
  int MaximumIterations = 15; ///< maximum number of Newton steps; >= 1
  /// The iterations have converged when no point's Newton step is longer than this, in mean edges
  /// of the loop; > 0.
  double Tolerance = 1e-3;
};

struct FairSurfaceResult
{
  Eigen::MatrixXd Points; ///< n x 3, the loop's points first
  int Iterations = 0;
  bool Converged = false;
};

/**
 * Computes a surface with given normals at its boundary loop. Its mean curvature is a harmonic
 * function on the surface (Schneider and Kobbelt, "Geometric fairing of irregular meshes for
 * free-form surface design", 2001). It reproduces planes, spheres, cylinders and all other surfaces
 * of constant mean curvature, for any triangulation.
 *
 * The mean curvature at a point is the normal component of the cotangent Laplacian of the
 * positions, divided by twice the Voronoi area. At the loop, only the triangles and the area of the
 * patch are used, which imposes the loop's normals as in mixed finite elements. Inside, the normals
 * are computed with NormalWeight::Max. Normals and mean curvature are therefore exact if the
 * corners of the triangles lie on a sphere.
 *
 * Newton's method moves the points along their normals. The derivative of the mean curvature has
 * two terms: the Laplacian of the displacement, and the displacement times the sum of the squared
 * principal curvatures.
 *
 * start: any surface, with the loop's points first; equilateral triangles are best. loopNormals: k
 * x 3. Near the solution, the factorisation is reused in the next iterations. If the iterations do
 * not converge, the result is, of all surfaces found, the one whose mean curvature has the smallest
 * Dirichlet energy. Throws SolveFailure if a sparse factorisation fails; Aborted.
 */
FairSurfaceResult SolveFairSurface(const Mesh& start, const Eigen::MatrixXd& loopNormals,
  const FairSurfaceOptions& options = {}, const Progress& progress = {});

} // namespace shape
