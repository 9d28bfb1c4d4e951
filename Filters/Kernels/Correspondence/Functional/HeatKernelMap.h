#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct HeatKernelMapOptions
{
  int Eigenpairs = 100; ///< of each surface, at most; >= 2
  int Times = 25;       ///< at which heat is compared; >= 1
};

/**
 * Corresponding points of two surfaces that differ by bending: those that receive as much heat
 * from a landmark, at each of several times (Ovsjanikov, Merigot, Memoli and Guibas, "One point
 * isometric matching with the heat kernel", 2010, equation 3). If a surface has no intrinsic
 * symmetry that keeps the landmark, one is enough; more resolve a symmetry and deviations from an
 * isometry.
 *
 * Heat at time t is the sum of exp(-lambda t) phi(p) phi(x) over the eigenfunctions but the
 * constants, made of norm 1 in the area; times are in a geometric sequence from 4 ln 10 / the
 * largest eigenvalue to 4 ln 10 / the smallest that is not 0, of the surfaces with area 1. Each
 * point goes to a position near in all of this heat (FindNearestSurfacePoints).
 *
 * a, b: consistently oriented 2-manifolds, open or closed, with a triangle at each point and a
 * landmark on each component. Without any landmark, of one component each: those of
 * FindLandmarks. Throws InvalidInput if not, SolveFailure, Aborted.
 */
SurfaceMaps ComputeHeatKernelMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const HeatKernelMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
