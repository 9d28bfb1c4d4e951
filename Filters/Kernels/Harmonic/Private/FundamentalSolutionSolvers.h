#pragma once

#include "Harmonic/Private/FundamentalSolutionFit.h"

#include <chrono>

namespace shape
{

// options.OffsetDistance is the distance of the nearest charges here.

/// One decomposition of all sources and collocation points. Adds its level to `result`.
void SolveSingleShot(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress);

/**
 * A sum of maps (Li et al. 2010, sections 3.3 and 4.1.2): the first from a coarse boundary map,
 * each later one from the finer map less the sum so far. Each uses one even subset of the sources,
 * in turn. Sources that a decomposition shows to be redundant are deleted, new ones are placed over
 * the points fitted worst, which become collocation points too.
 *
 * Beyond the paper: the first subset lies farther from the boundary than the last, as much as it is
 * coarser than all of them, and those between in geometric steps. Charges at the distance that
 * suits all of them together are too near for a few: their fields are bumps, of which no smooth
 * map can be made. Stops when neither of two levels in a row lowers what is left by the least
 * gain. Adds its levels to `result`.
 */
void SolveMultiLevel(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress);

/// Adds the level that has just been fitted: its errors and, since `start`, which becomes now, its
/// seconds.
void AddLevel(const FundamentalSolutionFit& problem, Eigen::Index sources, Eigen::Index rows,
  double gain, std::chrono::steady_clock::time_point& start, HarmonicVolumeMapResult& result);

/// Into how many subsets MultiLevel divides the sources, at least 16 in each.
int ComputeSubsetCount(const Surface& boundary, const HarmonicVolumeMapOptions& options);

/// How many times farther from the boundary the first of `subsets` lies than the last: as much as
/// the spacing of its sources is wider than that of all.
double ComputeCoarseness(int subsets);

} // namespace shape
