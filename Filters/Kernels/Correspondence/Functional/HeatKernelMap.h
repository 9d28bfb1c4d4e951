#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct HeatKernelMapOptions
{
  int Eigenpairs = 100; ///< maximum number for each surface; >= 2
  int Times = 25;       ///< number of times at which heat is compared; >= 1
};

/**
 * Computes corresponding points of two surfaces that differ by bending. Points correspond if they
 * receive the same heat from a landmark at each of several times (Ovsjanikov, Merigot, Memoli and
 * Guibas, "One point isometric matching with the heat kernel", 2010, equation 3). One landmark is
 * enough if no intrinsic symmetry of the surface keeps it fixed. More landmarks distinguish
 * symmetric points and reduce errors on surfaces that are not isometric.
 *
 * The heat at x from a landmark p at time t is the sum of exp(-lambda t) phi(p) phi(x) over the
 * non-constant eigenfunctions phi with eigenvalues lambda. It is divided by its L2 norm over the
 * surface. The times form a geometric sequence from 4 ln 10 / L to 4 ln 10 / l, for surfaces scaled
 * to area 1. Each surface has a largest computed eigenvalue and a smallest non-zero one. L is the
 * smaller of the two largest ones; l is the larger of the two smallest ones. Each point is mapped
 * to a position with nearly the same heat at all times (FindNearestSurfacePoints).
 *
 * a, b: consistently oriented 2-manifolds, open or closed, with a triangle at each point and a
 * landmark on each component. If no landmarks are given, FindLandmarks finds them; each surface
 * must then have one component. Throws InvalidInput if the input is not as required; SolveFailure;
 * Aborted.
 */
SurfaceMaps ComputeHeatKernelMap(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const HeatKernelMapOptions& options = {}, const Progress& progress = {});

/**
 * Computes the map from a bent part of a surface to the full surface, and the map back, by heat
 * (Ovsjanikov and others, section on partial matching).
 *
 * Both surfaces are brought to the same scale. Heat that has reached the cut differs between the
 * two, and so do the total heat and norms over the surfaces. Compared is therefore the logarithm of
 * the heat at x divided by that at the landmark, both with the constant function. For short times,
 * it is -d^2 / (4 t), where d is the distance from the landmark (Varadhan, "On the behavior of the
 * fundamental solution of the heat equation with variable coefficients", 1967), so it depends
 * little on a far cut. Ratios below 1e-4 are raised to 1e-4: the first of the times is that at
 * which the highest eigenfunction has decayed to this, so that further ones would change less.
 *
 * part: RequireConnected must accept it. whole: as above, with a landmark on each component.
 * landmarks: {point of the part, point of the full surface}, at least one; several tell more, since
 * far points receive little heat. scale: lengths on the full surface divided by those on the part.
 * In the result, AToB maps the part to the full surface. Points of the full surface without a
 * partner go to the part's point with the most similar heat. Throws InvalidInput, SolveFailure,
 * Aborted.
 */
SurfaceMaps ComputePartialHeatKernelMap(const Surface& part, const Surface& whole,
  const Landmarks& landmarks, double scale, const HeatKernelMapOptions& options = {},
  const Progress& progress = {});

} // namespace shape
