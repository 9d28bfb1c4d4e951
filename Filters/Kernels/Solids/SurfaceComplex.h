#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>
#include <vector>

namespace shape
{

/// Several surfaces as one set of triangles over distinct points; every point is used.
struct SurfaceComplex
{
  Mesh Surfaces;                  ///< the triangles of the first surface, then of the others
  std::vector<int> FirstTriangle; ///< the index of each surface's first triangle
  Eigen::VectorXi OriginalPoint;  ///< for the first surface's points: their indices in it
};

/// Throws InvalidInput unless `surface` is a closed, consistently oriented 2-manifold
/// (RequireClosedSurface). If it is open only because of duplicated points, the message says so.
void RequireClosed(const Surface& surface, const std::string& name);

/// Joins surfaces. Points at the same position are merged into the first of them, and points that
/// no triangle uses are removed. The first surface's points come first; all keep their order.
SurfaceComplex JoinSurfaces(const std::vector<Surface>& surfaces);

/// Throws InvalidInput if triangles are degenerate, cross or coincide. The message contains their
/// number, the first one and its position in units of `unit`. names: used for the surfaces in
/// messages. Throws Aborted.
void RequireConformingComplex(const SurfaceComplex& complex, const std::vector<std::string>& names,
  double unit, const Progress& progress = {});

} // namespace shape
