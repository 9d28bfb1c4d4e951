#pragma once

#include "Base/Progress.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

struct TetrahedralizeOptions
{
  /// Bound on each tetrahedron's circumradius divided by its shortest edge: > 1, or 0 for none.
  /// Beside sharp angles of the surface, and along a boundary that is preserved, it can be missed.
  double MaximumRadiusEdgeRatio = 2.0;

  /// Bound on each tetrahedron's volume, in the model's units cubed; 0 for none. Along a boundary
  /// that is preserved it can be missed, elsewhere by a few hundredths, by flips after refinement.
  double MaximumVolume = 0.0;

  /// Keeps every triangle of the surfaces as it is; else points may be added on them.
  bool PreserveBoundary = true;
};

struct TetrahedralizeResult
{
  /// n x 3: the surface's points that triangles use, in order, one for each position; then those of
  /// the inner surfaces; then the new ones.
  Eigen::MatrixXd Points;
  Eigen::MatrixXi Tetrahedra; ///< m x 4: (b - a) x (c - a) . (d - a) > 0
  Eigen::VectorXi RegionId;   ///< m: see Tetrahedralize
  /// From the surface, whose points alone have a source: see TraceClosestPositions.
  shape::Provenance Provenance;
  int SteinerPoints = 0; ///< how many points are of no surface
  int Regions = 0;       ///< how many regions have tetrahedra
  double Volume = 0.0;   ///< of all tetrahedra
  /// The minimum scaled Jacobian: 6 sqrt(2) volume over the largest product of the three edges at a
  /// corner; 1 for the regular tetrahedron, near 0 for a flat one.
  double MinimumScaledJacobian = 0.0;
};

/**
 * Fills the solid inside a closed surface with tetrahedra: a constrained Delaunay
 * tetrahedralisation, refined until its tetrahedra keep the bounds (Shewchuk, "Tetrahedral mesh
 * generation by Delaunay refinement", 1998; Hang Si, "TetGen, a Delaunay-based quality tetrahedral
 * mesh generator", 2015).
 *
 * surface: closed, oriented consistently, may have several components: one inside an odd number of
 * others bounds a void, which stays empty. innerSurfaces: the same, inside the solid, also inside
 * one another: borders between materials. RegionId is i + 1 if inner surface i is the innermost
 * around a tetrahedron, and 0 if none is. Winding numbers inside its largest tetrahedron decide
 * which region a set of tetrahedra between surfaces has. No two surfaces may cross or touch but in
 * points; points at the same position count as one.
 *
 * The result is checked: every tetrahedron is positive (exactly), each region's volume agrees with
 * the surfaces' to 1e-9, and, if the boundary is preserved, each triangle of a surface is a
 * face.
 *
 * Throws InvalidInput if a surface is not closed, has flat triangles, crosses itself or another,
 * encloses no volume, an inner surface lies outside the solid, an option is out of its range, or
 * ShapeMap was built without TetGen; SolveFailure if TetGen fails or its result does not pass;
 * Aborted.
 */
TetrahedralizeResult Tetrahedralize(const Surface& surface,
  const std::vector<Surface>& innerSurfaces = {}, const TetrahedralizeOptions& options = {},
  const Progress& progress = {});

/// The solid's provenance in which the points that are none of the surface's have the values at the
/// closest positions on it. Throws Aborted.
Provenance TraceClosestPositions(
  const Surface& surface, const TetrahedralizeResult& solid, const Progress& progress = {});

} // namespace shape
