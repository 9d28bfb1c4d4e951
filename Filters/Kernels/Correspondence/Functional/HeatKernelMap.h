#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct HeatKernelMapOptions
{
  int Eigenpairs = 100; ///< maximum for each surface; >= 2
  int Times = 25;       ///< number of times at which heat is compared; >= 1
};

/**
 * Computes corresponding points of two surfaces that differ by bending. Points correspond if they
 * receive the same heat from a landmark at each of several times (Ovsjanikov, Merigot, Memoli and
 * Guibas, "One point isometric matching with the heat kernel", 2010, equation 3). One landmark is
 * enough if no intrinsic symmetry of the surface keeps it fixed. More landmarks resolve symmetries
 * and deviations from an isometry.
 *
 * Heat at time t is the sum of exp(-lambda t) phi(p) phi(x) over the non-constant eigenfunctions,
 * divided by its L2 norm over the surface. Times form a geometric sequence. It runs from 4 ln 10 /
 * the largest eigenvalue to 4 ln 10 / the smallest non-zero one, for the surfaces scaled to area 1.
 * Each point is mapped to a position with nearly the same heat at all times
 * (FindNearestSurfacePoints).
 *
 * a, b: consistently oriented 2-manifolds, open or closed, with a triangle at each point and a
 * landmark on each component. If there are no landmarks, each surface must have one component, and
 * those of FindLandmarks are used. Throws InvalidInput if they are not, SolveFailure, Aborted.
 */
SurfaceMaps ComputeHeatKernelMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const HeatKernelMapOptions& options = {}, const Progress& progress = {});

} // namespace shape
