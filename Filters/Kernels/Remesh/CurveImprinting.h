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
  /// The snapping tolerance, as a fraction of an edge's length, in [0, 0.5). If a loop crosses an
  /// edge this close to an end of the edge, the crossing is moved to the end. If a loop has a point
  /// inside a triangle this close to an edge, the point is moved to the edge. Nothing is snapped if
  /// that makes loops touch more often.
  double SnapShare = 0.05;
};

/// A surface whose edges contain the given loops.
struct ImprintedCurves
{
  Mesh Surface;                        ///< the given points come first
  shape::Provenance Provenance;        ///< from the given surface
  std::vector<std::vector<int>> Loops; ///< closed, without repeated points, the longest first
  std::vector<int> LoopIds; ///< for each of Loops, the index of the given loop that contains it
};

/**
 * Splits the triangles that loops on a surface pass through, so that the loops run along edges. The
 * shape of the surface does not change. Triangles that are not split keep their points and their
 * order. Where a loop already runs along an edge, nothing is split.
 *
 * A loop that touches or crosses itself becomes several loops. Parts of a loop that are traversed
 * in both directions are left out. Each split triangle becomes a Delaunay triangulation constrained
 * by the loops.
 *
 * surface: triangles of three different points, manifold or not. Throws InvalidInput if an option
 * is out of range, or if a given loop encloses nothing. Throws SolveFailure if loops cross each
 * other or themselves on an edge or too close to one; Aborted.
 */
ImprintedCurves ImprintCurves(const Mesh& surface, const std::vector<SurfaceLoop>& loops,
  const CurveImprintingOptions& options = {}, const Progress& progress = {});

} // namespace shape
