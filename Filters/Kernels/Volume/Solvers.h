#pragma once

#include "Volume/BoundaryProblem.h"

namespace shape
{

/// One decomposition of all sources and collocation points. Adds its level to `result`.
void SolveSingleShot(BoundaryProblem& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress);

/**
 * A sum of maps (Li et al. 2010, sections 3.3 and 4.1.2): the first from a coarse boundary map,
 * each later one from the finer map less the sum so far. Each uses one even subset of the sources,
 * in turn. Sources that a decomposition shows to be redundant are deleted, new ones are placed over
 * the points fitted worst, which become collocation points too. A map that does not lower the
 * residual is left out; after as many of those in a row as there are subsets it stops. Adds its
 * levels to `result`.
 */
void SolveMultiLevel(BoundaryProblem& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress);

/// How many points a ratio of the boundary's asks for, at least 16.
int SampleCount(const BoundaryProblem& problem, double ratio);

/// Places of charges: samples of the offset surface `outer`, at the offset distance.
Eigen::MatrixXd PlaceSources(const BoundaryProblem& problem, const Mesh& outer,
  const HarmonicVolumeMapOptions& options, const Progress& progress);

} // namespace shape
