#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>
#include <vector>

namespace shape
{

/// Several surfaces as one mesh. No two points have the same position, and each point belongs to a
/// triangle.
struct SurfaceComplex
{
  Mesh Surfaces;                  ///< the triangles of the first surface, then those of the others
  std::vector<int> FirstTriangle; ///< the index of each surface's first triangle
  Eigen::VectorXi OriginalPoint; ///< for each point of the first surface, its index in that surface
};

/// Throws InvalidInput unless `surface` is a closed, consistently oriented 2-manifold
/// (RequireClosedSurface). If it is open only because of duplicated points, the message says so.
void RequireClosed(const Surface& surface, const std::string& name);

/// Joins surfaces. Points at the same position are merged into the first of them. Points that no
/// triangle uses are removed. The first surface's points come first; all points keep their order.
SurfaceComplex JoinSurfaces(const std::vector<Surface>& surfaces);

/// Throws InvalidInput if triangles are degenerate, cross or coincide; Aborted. The message gives
/// the number of such triangles or pairs, and lists the first of them with their positions, which
/// are multiplied by `unit`. names: denote the surfaces in messages.
void RequireConformingComplex(const SurfaceComplex& complex, const std::vector<std::string>& names,
  double unit, const Progress& progress = {});

} // namespace shape
