#pragma once

#include "Harmonic/Private/FundamentalSolutionFit.h"

#include <chrono>

namespace shape
{

// In this file options.OffsetDistance is the distance of the nearest charges.

/// Fits one map, by one decomposition of the matrix of all sources and collocation points. Appends
/// its level to `result`.
void SolveSingleShot(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress);

/**
 * Fits a sum of maps (Li et al. 2010, sections 3.3 and 4.1.2). The first map fits a coarse boundary
 * map. Each later map fits the residual of the sum so far on the finer boundary map. The sources
 * are divided into evenly spread subsets, which the levels use in turn. Sources that a
 * decomposition shows to be redundant are deleted. New sources are placed near the points with the
 * largest errors, and these points become collocation points, too.
 *
 * Beyond the paper, coarse subsets lie farther out. The distances of the subsets from the boundary
 * form a geometric sequence; the first is ComputeCoarseness times the last. At the distance that
 * suits all sources together, the fields of a few sources are separate bumps, which cannot form a
 * smooth map. The iteration stops when two levels in a row decrease the residual by less than
 * LeastGain. Appends its levels to `result`.
 */
void SolveMultiLevel(FundamentalSolutionFit& problem, const HarmonicVolumeMapOptions& options,
  HarmonicVolumeMapResult& result, const Progress& progress);

/// Appends a level to `result`, with the errors of `problem` and the seconds since `start`. Then
/// sets `start` to the current time.
void AddLevel(const FundamentalSolutionFit& problem, Eigen::Index sources, Eigen::Index rows,
  double gain, std::chrono::steady_clock::time_point& start, HarmonicVolumeMapResult& result);

/// Returns the number of subsets into which MultiLevel divides the sources. Each subset has at
/// least 16 sources.
int ComputeSubsetCount(const Surface& boundary, const HarmonicVolumeMapOptions& options);

/// Returns the ratio of the first subset's distance from the boundary to the last subset's
/// distance. It is sqrt(subsets), the ratio of the spacing of one subset's sources to the spacing
/// of all sources.
double ComputeCoarseness(int subsets);

} // namespace shape
