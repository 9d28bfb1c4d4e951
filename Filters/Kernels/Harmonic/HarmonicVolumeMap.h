#pragma once

#include "Base/Progress.h"
#include "Harmonic/HarmonicMapTypes.h"
#include "Mesh/Surface.h"

namespace shape
{

struct AcceleratedSetup;

/**
 * The harmonic map of a solid whose values on the boundary are given, by the method of fundamental
 * solutions: charges outside the solid, fitted so that the sum of their potentials meets the
 * boundary map (Li, Xu, Wan, Yin and Yu, "Feature-aligned harmonic volumetric mapping using MFS",
 * Computers & Graphics 34, 2010). The affine part is fitted first, so affine maps are exact.
 *
 * Accelerated: a charge for each point of the boundary, 0.9 spacings outside of it, and a few
 * hundred farther ones; equations at its points and centroids, by least squares; GMRES
 * preconditioned by local blocks, sums by the multipole method (NearSurfaceCharges.h,
 * SchwarzPreconditioner.h, FmmSummation.h). Then triangles that hold most of what is left are
 * halved and a further map is fitted to that, until the tolerance is met. Time and memory grow
 * nearly as the boundary does. CPU seconds of sphere maps: bear_bis of 10096 points 1.8,
 * RMSEInside 9.1e-5; bunny00 of 37706, 3.0, 7.5e-5; the same in 113114, 6.0, 6.4e-5
 * (Testing/Benchmarks/VolumeMap.py). MultiLevel meets soft features better, SingleShot is the
 * paper's first method: both decompose dense matrices, and are for small boundaries.
 *
 * Of these two: the paper's offset is 0.15 of the size; by default that of the nearest charges
 * is 1.25 times the spacing of the points where the map is fitted, between 0.01 and 0.15.
 * RMSEInside of MultiLevel at 0.8, 1.25 and 2 times the spacing: dented ball of 2892 points to
 * ball 1.4e-3, 2.4e-3, 5.6e-3, and back 4.1e-4, 2.7e-4, 2.2e-4. Each fitted map is added with the
 * factor, one for each coordinate, that leaves the least over inside triangles and at features: it
 * differs from 1 where the fit swings between the collocation points, as SingleShot's can with more
 * sources than those.
 *
 * boundary: the closed surface of one solid in the space of the domain, and of its voids, facing
 * any way; charges sit in the voids, too (ChargeShells). targets (n x 3): the image of each of its
 * points. Throws InvalidInput for a surface that is not closed or bounds several solids, values
 * that are not finite, options out of range, a feature outside the domain or a decomposition beyond
 * MaximumMemory; SolveFailure where LAPACK's does not converge, or no charge of Accelerated finds
 * room; Aborted. A decomposition is a single library call that cannot be interrupted.
 *
 * setup: what Accelerated sets up for a boundary (NearSurfaceCharges.h), kept from call to call: it
 * is made again only where the boundary differs.
 */
HarmonicVolumeMapResult ComputeHarmonicVolumeMap(const Surface& boundary,
  const Eigen::MatrixXd& targets, const VolumeFeatures& features = {},
  const HarmonicVolumeMapOptions& options = {}, const Progress& progress = {},
  AcceleratedSetup* setup = nullptr);

} // namespace shape
