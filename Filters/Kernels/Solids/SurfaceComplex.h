#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <string>
#include <vector>

namespace shape
{

/// Surfaces as one set of triangles over distinct points that are all used.
struct SurfaceComplex
{
  Mesh Surfaces;                  ///< the triangles of the first surface, then of the others
  std::vector<int> FirstTriangle; ///< where each surface's triangles begin
  Eigen::VectorXi OriginalPoint;  ///< of the first surface's points: their indices in it
};

/// Throws InvalidInput unless `surface` is a closed, consistently oriented 2-manifold
/// (RequireClosedSurface); if it is open only because points are duplicated, the message says
/// so.
void RequireClosed(const Surface& surface, const std::string& name);

/// Points at the same position become the first of them, points that no triangle uses are left out.
/// The first surface's points come first, each surface's in order.
SurfaceComplex JoinSurfaces(const std::vector<Surface>& surfaces);

/// Throws InvalidInput if triangles are flat, cross or coincide, with the number of them, the
/// first and where it lies in units of `unit`; Aborted. names: what errors call the surfaces.
void RequireConformingComplex(const SurfaceComplex& complex, const std::vector<std::string>& names,
  double unit, const Progress& progress = {});

} // namespace shape
