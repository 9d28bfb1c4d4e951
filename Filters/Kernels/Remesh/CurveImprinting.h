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
  /// How near to an end of an edge, as a share of its length, the loop is moved to the end, and how
  /// near to an edge, as a share of its length, a point inside a triangle to the edge: in [0, 0.5).
  /// If that would make loops touch they are left where they are.
  double SnapShare = 0.05;
};

/// A surface that loops run along the edges of.
struct ImprintedCurves
{
  Mesh Surface;                        ///< the given points come first
  shape::Provenance Provenance;        ///< from the given surface
  std::vector<std::vector<int>> Loops; ///< closed; no point twice in one; the longest first
  std::vector<int> LoopIds;            ///< of each of them: the given loop that it is a part of
};

/**
 * Splits the triangles of a surface that loops run through such that they run along edges. The
 * surface has the same shape; triangles that are not split keep their points and their order. A
 * stretch of a loop along edges splits none.
 *
 * A loop that touches or crosses itself becomes several; what it runs along there and back is left
 * out. Parts of a triangle are Delaunay triangles in its plane but for the loops.
 *
 * surface: triangles of three different points, manifold or not. Throws InvalidInput if an
 * option is not as above or a given loop encloses nothing, SolveFailure if loops cross too near
 * to an edge, Aborted.
 */
ImprintedCurves ImprintCurves(const Mesh& surface, const std::vector<SurfaceLoop>& loops,
  const CurveImprintingOptions& options = {}, const Progress& progress = {});

} // namespace shape
