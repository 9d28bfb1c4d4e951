#pragma once

#include "Base/Progress.h"
#include "Harmonic/HarmonicMapTypes.h"
#include "Mesh/Surface.h"

namespace shape
{

struct AcceleratedSetup;

/**
 * Computes the harmonic map of a solid from given values on its boundary, by the method of
 * fundamental solutions. Charges outside the solid are fitted so that the sum of their potentials
 * approximates the boundary map (Li, Xu, Wan, Yin and Yu, "Feature-aligned harmonic volumetric
 * mapping using MFS", Computers & Graphics 34, 2010). The affine part is fitted first, so affine
 * maps are exact.
 *
 * Accelerated places one charge outside each boundary point, at a distance of ChargeDistance times
 * the spacing of the points. Up to a few thousand coarse charges lie farther out. The equations at
 * the boundary points and triangle centroids are solved by least squares. GMRES is preconditioned
 * by local blocks, and sums are computed by the fast multipole method (NearSurfaceCharges.h,
 * SchwarzPreconditioner.h, FmmSummation.h). Then the triangles with the largest residual are
 * bisected, and a further map is fitted to the residual. This is repeated until the tolerance is
 * met. Time and memory grow nearly linearly with the boundary. CPU time and RMSEInside of sphere
 * maps (Testing/Benchmarks/VolumeMap.py): bear_bis with 10096 points: 1.8 s, 9.1e-5. bunny00 with
 * 37706 points: 3.0 s, 7.5e-5. bunny00 with 113114 points: 6.0 s, 6.4e-5.
 *
 * MultiLevel fits soft features better; SingleShot is the paper's first method. Both decompose
 * dense matrices and are meant for small boundaries. In the paper, the charges' distance from the
 * boundary is 0.15 times the longest side of its bounding box. Here the default distance of the
 * nearest charges is 1.25 times the spacing of the collocation points, clamped to between 0.01 and
 * 0.15 times that side. RMSEInside of MultiLevel was measured with distances of 0.8, 1.25 and 2
 * times the spacing. Dented ball with 2892 points to ball: 1.4e-3, 2.4e-3, 5.6e-3. Ball to dented
 * ball: 4.1e-4, 2.7e-4, 2.2e-4.
 *
 * Each fitted map is scaled before it is added, by one factor for each coordinate. The factors
 * minimize the residual inside triangles and at features. They differ from 1 if the fit oscillates
 * between the collocation points. The fit of SingleShot can oscillate if it has more sources than
 * collocation points.
 *
 * boundary: the closed surface around one solid and its voids, facing either way. Charges are
 * placed in the voids, too (ChargeShells). targets: n x 3, the image of each boundary point. setup:
 * keeps the system of Accelerated between calls (NearSurfaceCharges.h); it is rebuilt only if the
 * boundary has changed. If it names several processes, they share the work and the memory: all of
 * them call this function with the same arguments, and all return the same map. It differs from
 * that of one process by rounding only. Then the method must be Accelerated, without features.
 *
 * Throws InvalidInput if the surface is not closed or bounds several solids, a value is not finite,
 * an option is out of range, or the method is FiniteElements. Throws InvalidInput, too, if a
 * feature lies outside the domain or a decomposition would exceed MaximumMemory. Throws
 * SolveFailure if LAPACK's decomposition does not converge, or if Accelerated has no room for any
 * charge. Throws Aborted.
 */
HarmonicVolumeMapResult ComputeHarmonicVolumeMap(const Surface& boundary,
  const Eigen::MatrixXd& targets, const VolumeFeatures& features = {},
  const HarmonicVolumeMapOptions& options = {}, const Progress& progress = {},
  AcceleratedSetup* setup = nullptr);

} // namespace shape
