#pragma once

#include "Core/Mesh.h"
#include "Core/Progress.h"

namespace shape
{

enum class SamplingMode
{
  Uniform,         ///< evenly spread over the surface
  GeometryAdaptive ///< more points where the surface bends more
};

/**
 * About `count` points on or near a surface (at most `count`, and at least nine tenths of it where
 * the surface is closed).
 *
 * Uniform: exactly `count` points on the surface, of the greatest mutual distance that weighted
 * elimination from five times as many random points gives (Yuksel, "Sample elimination for
 * generating Poisson disk sample sets", 2015). GeometryAdaptive: the points that quadric
 * simplification of the subdivided surface leaves (Li et al. 2010, section 4.1.1); they lie near
 * the surface.
 *
 * Throws InvalidInput where count < 4 or the surface has no area, Aborted.
 */
Eigen::MatrixXd SampleSurface(const Mesh& surface, int count, SamplingMode mode,
  unsigned int seed = 1, const Progress& progress = {});

/// The `count` rows of `points` (on a surface of area `area`) that weighted elimination keeps,
/// ascending. Throws Aborted.
Eigen::VectorXi EliminateSamples(
  const Eigen::MatrixXd& points, double area, int count, const Progress& progress = {});

/// The rows of `points` in an order in which neighbours in space are mostly neighbours in the list
/// (Morton's): taking every k-th one spreads a subset evenly.
Eigen::VectorXi SpatialOrder(const Eigen::MatrixXd& points);

} // namespace shape
