#pragma once

#include "Harmonic/Private/FundamentalSolutionFit.h"

#include <chrono>

namespace shape
{

// In this file options.OffsetDistance is the distance of the nearest charges.

/// Fits one map by one decomposition of all sources and collocation points. Appends its level to
/// `result`.
void SolveSingleShot(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress);

/**
 * Fits a sum of maps (Li et al. 2010, sections 3.3 and 4.1.2). The first fits a coarse boundary
 * map, each later one the residual of the sum so far on the finer boundary map. The levels use the
 * evenly spread subsets of the sources in turn. Sources that a decomposition shows to be redundant
 * are deleted. New ones are placed near the points with the largest errors, which become
 * collocation points too.
 *
 * Beyond the paper, coarse subsets lie farther out: the first lies farther from the boundary than
 * the last by the ratio of their spacings, with geometric steps in between. At the distance that
 * suits all sources together, the fields of a few sources are bumps that cannot form a smooth map.
 * Stops when two levels in a row decrease the residual by less than LeastGain. Appends its levels
 * to `result`.
 */
void SolveMultiLevel(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress);

/// Appends the level that has just been fitted: its errors and the seconds since `start`. Sets
/// `start` to now.
void AddLevel(const FundamentalSolutionFit& problem, Eigen::Index sources, Eigen::Index rows,
  double gain, std::chrono::steady_clock::time_point& start, HarmonicVolumeMapResult& result);

/// Returns the number of subsets that MultiLevel divides the sources into, at least 16 in each.
int ComputeSubsetCount(const Surface& boundary, const HarmonicVolumeMapOptions& options);

/// Returns the distance of the first of `subsets` from the boundary / that of the last: the spacing
/// of its sources / the spacing of all sources.
double ComputeCoarseness(int subsets);

} // namespace shape
