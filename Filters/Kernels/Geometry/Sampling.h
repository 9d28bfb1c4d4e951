#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

enum class SamplingMode
{
  Uniform = 0,          ///< evenly spread over the surface
  GeometryAdaptive = 1, ///< denser where the surface is more curved
  Quadric = 2           ///< the points that quadric simplification leaves
};

/**
 * Returns `count` points spread over a surface. Except with Quadric, weighted elimination selects
 * them from several times as many random points (Yuksel, "Sample elimination for generating Poisson
 * disk sample sets", 2015).
 *
 * Uniform: maximises the distances between points. GeometryAdaptive: the density follows the
 * curvature of the surface, measured within one spacing. If the points were joined by facets, these
 * would deviate from the surface by the same amount everywhere. The density stays within [0.5, 4]
 * times its mean.
 *
 * Quadric: the points that remain after quadric simplification of the surface, which leaves flat
 * parts empty (Li et al. 2010, section 4.1.1). They lie near the surface, and on a surface that
 * is not a sphere there may be a few less. The seed has no effect. RMSEInside of the harmonic map
 * with GeometryAdaptive (first value) and Quadric (second value): Dented sphere of 3k points to the
 * ball: 3.2e-3 and 3.6e-3. Dented sphere of 10k points to the ball: 3.4e-4 and 3.7e-4. Two-torus to
 * its polycube: 1.6e-3 and 1.7e-3. Twisted bar to its box: 3.3e-5 and 1.6e-3.
 *
 * Throws InvalidInput if count < 4 or the surface has no area; Aborted.
 */
Eigen::MatrixXd SampleSurface(const Mesh& surface, int count, SamplingMode mode,
  unsigned int seed = 1, const Progress& progress = {});

/// The same for several surfaces. The `count` points are distributed in proportion to area, with at
/// least `minimum` on each surface. Returns the points of each surface.
std::vector<Eigen::MatrixXd> SampleSurfaces(const std::vector<Mesh>& surfaces, int count,
  int minimum, SamplingMode mode, unsigned int seed = 1, const Progress& progress = {});

/// Returns the radius of `count` equal disks that are packed as densely as possible in a plane
/// region of this area.
double ComputePackingRadius(double area, int count);

/// Returns the `count` rows of `points` (n x 3) that weighted elimination keeps, ascending. radii
/// (n): half the wanted spacing at each point. Throws Aborted.
Eigen::VectorXi EliminateSamples(const Eigen::MatrixXd& points, const Eigen::VectorXd& radii,
  int count, const Progress& progress = {});

/**
 * Estimates the area that each of n points on a surface represents, divided by the mean of these
 * areas (n values). The estimate is the square of the mean distance to the 6 nearest neighbours,
 * divided by its mean and clamped to between 0.1 and 10.
 *
 * With these weights a sum over the points approximates an integral over the surface, whatever the
 * density. Without them dense regions dominate the least squares of the harmonic map. RMSEVertices
 * and RMSEInside of MultiLevel were measured with adaptive samples. Dented sphere of 3k points:
 * 3.06e-3 and 2.93e-3 without weights, 3.01e-3 and 2.33e-3 with weights. Two-torus to its polycube:
 * 5.18e-3 and 4.70e-3 without weights, 4.96e-3 and 4.34e-3 with weights.
 */
Eigen::VectorXd ComputeSampledAreas(const Eigen::MatrixXd& points);

/// Returns the row indices of `points` in Morton order: neighbours in space are mostly neighbours
/// in the list. Every k-th entry therefore forms an evenly spread subset.
Eigen::VectorXi FindSpatialOrder(const Eigen::MatrixXd& points);

} // namespace shape
