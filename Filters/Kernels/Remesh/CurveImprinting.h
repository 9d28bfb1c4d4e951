#pragma once

#include "Base/Progress.h"
#include "Geodesics/SurfaceLoop.h"
#include "Mesh/Mesh.h"
#include "Mesh/Provenance.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct CurveImprintingOptions
{
  /// Snapping tolerances, as a fraction of an edge's length, in [0, 0.5). A loop this close to an
  /// end of an edge is moved to the end. A point inside a triangle this close to an edge is moved
  /// to the edge. If snapping would make loops touch, it is not done.
  double SnapShare = 0.05;
};

/// A surface whose edges contain the given loops.
struct ImprintedCurves
{
  Mesh Surface;                        ///< the given points come first
  shape::Provenance Provenance;        ///< from the given surface
  std::vector<std::vector<int>> Loops; ///< closed; none repeats a point; the longest first
  std::vector<int> LoopIds;            ///< for each of these, the given loop that contains it
};

/**
 * Splits the triangles that loops on a surface pass through, so that the loops run along edges. The
 * shape of the surface does not change. Triangles that are not split keep their points and their
 * order. Parts of a loop that already run along edges split nothing.
 *
 * A loop that touches or crosses itself becomes several loops; parts that are traversed back and
 * forth are left out. The parts of a triangle form a Delaunay triangulation constrained by the
 * loops.
 *
 * surface: triangles of three different points, manifold or not. Throws InvalidInput if an option
 * is out of range or a given loop encloses nothing. Throws SolveFailure if loops cross too close to
 * an edge; Aborted.
 */
ImprintedCurves ImprintCurves(const Mesh& surface, const std::vector<SurfaceLoop>& loops,
  const CurveImprintingOptions& options = {}, const Progress& progress = {});

} // namespace shape
