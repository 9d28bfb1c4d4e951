#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

namespace shape
{

struct GeneralizedMDSOptions
{
  int Samples = 100; ///< of each surface; >= 8
  int Starts = 8;    ///< starts that are optimised with eight samples; >= 1
  int Sweeps = 30;   ///< maximum number for each number of samples; >= 1
};

struct GeneralizedMDSResult
{
  SurfaceMaps Maps;
  /// The root mean square change of the distance between two samples. Both surfaces are scaled to
  /// area 1.
  double Stress = 0.0;
  bool Reversed = false; ///< whether the maps exchange left and right
};

/**
 * Maps two surfaces onto each other such that distances along them change as little as possible:
 * generalised multidimensional scaling (Bronstein, Bronstein and Kimmel, "Generalized
 * multidimensional scaling: a framework for isometry-invariant partial surface matching", 2006).
 *
 * The samples of each surface have images at any positions on the other one. Samples of A and their
 * images, images on A and the samples of B are pairs of points. The stress is the sum over all two
 * pairs of the squared difference of their distances on A and on B. Distances are exact between the
 * points of a surface, and interpolated linearly in the triangles at both ends. So the stress is a
 * quadratic function of the barycentric coordinates of one image in its triangle. One image after
 * the other moves to the minimum in its triangle, or in one around, until none is lower. The number
 * of samples is then doubled: a new image begins at the point with the smallest stress.
 *
 * Both surfaces are scaled to area 1. Starts are images of three remote samples of A, of those
 * points of B with the most similar distances. Half of them are dropped whenever the number of
 * samples is doubled. A start whose map exchanges left and right counts with 1 / 0.85 of its
 * stress. Landmarks are pairs that do not move. Every point that is no sample is mapped to the
 * position with the smallest stress relative to all pairs, where the weight of a pair falls with
 * its distance.
 *
 * A reflection may change distances as little as the map that keeps orientation, as of a flat
 * figure whose front and back are alike. So a start that exchanges left and right has a second
 * form: the sample that has two almost equally good images gets the other one, and all others
 * follow. The best start that keeps orientation is never dropped. If none is good, Reversed says
 * so; landmarks on one side help.
 *
 * a, b: surfaces that RequireConnected accepts. Each has n x n distances, whose time grows with the
 * cube of n: 2 x 600 points take about 5 seconds. Throws InvalidInput, SolveFailure, Aborted.
 */
GeneralizedMDSResult ComputeGeneralizedMDS(const Surface& a, const Surface& b,
  const Landmarks& landmarks, const GeneralizedMDSOptions& options = {},
  const Progress& progress = {});

} // namespace shape
