#pragma once

#include "Base/Progress.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

struct TetrahedralizeOptions
{
  /// Upper bound on the ratio of each tetrahedron's circumradius to its shortest edge: > 1, or 0
  /// for no bound. Near sharp angles of the surface and along a preserved boundary, the ratio may
  /// exceed the bound.
  double MaximumRadiusEdgeRatio = 2.0;

  /// Upper bound on each tetrahedron's volume, in the model's units cubed; 0 for no bound. Along a
  /// preserved boundary, the volume may exceed the bound. Elsewhere it may exceed the bound by a
  /// few percent, because of flips after refinement.
  double MaximumVolume = 0.0;

  /// Whether every triangle of the surfaces stays unchanged. If false, points may be added on the
  /// triangles.
  bool PreserveBoundary = true;

  /// Maximum number of new points, > 0, or 0: a million and more, depending on the bounds and the
  /// surface. The processor time that TetGen may take is in proportion to it, and 10 s.
  int MaximumNewPoints = 0;
};

struct TetrahedralizeResult
{
  /// n x 3: first the points that triangles of the surface use, in order and without duplicates.
  /// The points of the inner surfaces follow, and then the new points.
  Eigen::MatrixXd Points;
  Eigen::MatrixXi Tetrahedra; ///< m x 4: (b - a) x (c - a) . (d - a) > 0
  Eigen::VectorXi RegionId;   ///< m: the region of each tetrahedron, see Tetrahedralize
  /// The origin of the points in the surface. Only points of the surface have a source; see
  /// TraceClosestPositions.
  shape::Provenance Provenance;
  int SteinerPoints = 0; ///< number of points that belong to no surface
  int Regions = 0;       ///< number of regions that contain tetrahedra
  double Volume = 0.0;   ///< total volume of the tetrahedra
  /// The minimum scaled Jacobian. For one tetrahedron, it is 6 sqrt(2) V / P, where V is the volume
  /// and P the largest product of the three edge lengths at a corner. It is 1 for a regular
  /// tetrahedron and near 0 for a flat one.
  double MinimumScaledJacobian = 0.0;
  /// Number of tetrahedra with a scaled Jacobian below 1e-10: positive, but by rounding only.
  int Flat = 0;
};

/**
 * Fills the solid inside a closed surface with tetrahedra: a constrained Delaunay
 * tetrahedralisation, refined until its tetrahedra satisfy the bounds (Shewchuk, "Tetrahedral mesh
 * generation by Delaunay refinement", 1998; Hang Si, "TetGen, a Delaunay-based quality tetrahedral
 * mesh generator", 2015).
 *
 * surface: closed and consistently oriented. It may have several components. A component inside an
 * odd number of others bounds a void, which stays empty.
 *
 * innerSurfaces: closed and consistently oriented borders between materials inside the solid; they
 * may be nested. A tetrahedron's RegionId is i + 1 if inner surface i is the innermost around it,
 * and 0 if no inner surface is around it. For each connected set of tetrahedra between surfaces,
 * winding numbers at its largest tetrahedron decide the region. Surfaces may touch each other at
 * single points only. Points at the same position are merged.
 *
 * The result is checked. Every tetrahedron is positive (by exact predicates). The volume of each
 * region agrees with the volume that the surfaces enclose, to 1e-9 of the total volume. If the
 * boundary is preserved, each triangle of a surface is a face of a tetrahedron.
 *
 * Throws InvalidInput if a surface is not closed, has degenerate triangles, crosses itself or
 * another surface, or encloses no volume. Throws it also if an inner surface lies outside the
 * solid, an option is out of range, or ShapeMap was built without TetGen. Throws SolveFailure if
 * TetGen fails, or if its result does not pass the checks; Aborted.
 */
TetrahedralizeResult Tetrahedralize(const Surface& surface,
  const std::vector<Surface>& innerSurfaces = {}, const TetrahedralizeOptions& options = {},
  const Progress& progress = {});

/**
 * Fills the regions between the triangles of a conforming surface with tetrahedra, in the same way.
 * Regions that touch share the points of their interface.
 *
 * surfaces: the triangles. labels: m x 2, the labels of the regions on both sides of each triangle;
 * the normal leaves the first. A tetrahedron's RegionId is its label. Label 0 is the outside, which
 * stays empty.
 *
 * The same is checked. Throws InvalidInput if the two labels of a triangle are equal, or if the
 * triangles of a region are not closed, manifold and consistently oriented, or face inwards; and
 * what Tetrahedralize throws.
 */
TetrahedralizeResult TetrahedralizeRegions(const Mesh& surfaces, const Eigen::MatrixXi& labels,
  const TetrahedralizeOptions& options = {}, const Progress& progress = {});

/// Returns the solid's provenance, with a source for every point. A point that is not a point of
/// the surface gets the values at the closest position on the surface. Throws Aborted.
Provenance TraceClosestPositions(
  const Surface& surface, const TetrahedralizeResult& solid, const Progress& progress = {});

} // namespace shape
