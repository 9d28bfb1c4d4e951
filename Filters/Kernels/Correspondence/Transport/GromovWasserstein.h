#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Correspondence/Transport/GromovWassersteinCoupling.h"
#include "Mesh/Surface.h"

#include <vector>

namespace shape
{

struct GromovWassersteinOptions
{
  int Samples = 500;   ///< of each surface, whose distances are compared; >= 10
  int Eigenpairs = 60; ///< of each surface, in which the map is taken from samples to all; >= 2
  EntropicCouplingOptions Coupling;
  /// Without landmarks: pairs, each of which a coupling begins with; none: those of
  /// FindLandmarks and their rival.
  std::vector<Landmarks> Starts;
};

struct GromovWassersteinResult
{
  SurfaceMaps Maps;
  /// The root of the mean square of how much two samples' distance and that of what goes to them
  /// differ, over the root of the area.
  double Distortion = 0.0;
  double Error = 0.0; ///< the share of the masses that is not where the samples' weights want it
  Landmarks Start;    ///< the landmarks or, without, those of the coupling that was taken
};

/**
 * Corresponding points of two surfaces by the coupling of samples that keeps distances along the
 * surfaces best (SolveCoupling; Solomon, Peyre, Kim and Sra, "Entropic metric alignment for
 * correspondence problems", 2016), which may be one to many if shapes differ.
 *
 * Samples weigh as much as the area that is nearest to them. Entropy falls on a quarter of the
 * samples, and once more, from eight times its last value, on all of them. Landmarks are samples
 * that go to each other; the start is how alike samples lie to them (EmbedByLandmarks). Without
 * landmarks nothing is fixed, and of the couplings of all starts, on a quarter of the samples, the
 * one with the smallest distortion is taken.
 *
 * From the samples to all points: each sample's image is the mean of B's eigenfunctions over what
 * goes there, interpolated by the eigenfunctions of A in least squares ("soft" functional maps,
 * section 4 of the paper); each point goes to a position near its row there
 * (FindNearestSurfacePoints).
 *
 * a, b: consistently oriented 2-manifolds of one component, open or closed, of any genus, with a
 * triangle at each point. Sizes may differ. Throws InvalidInput if not, SolveFailure, Aborted.
 */
GromovWassersteinResult ComputeGromovWassersteinMap(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const GromovWassersteinOptions& options = {},
  const Progress& progress = {});

} // namespace shape
