#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

enum class SamplingMode
{
  Uniform,         ///< evenly spread over the surface
  GeometryAdaptive ///< more points where the surface bends more
};

/**
 * `count` points spread over a surface: the ones that weighted elimination leaves of several times
 * as many random points (Yuksel, "Sample elimination for generating Poisson disk sample sets",
 * 2015).
 *
 * Uniform: of the greatest mutual distance. GeometryAdaptive: their density goes with the bending
 * of the surface within a spacing of them, so that facets between them would stray from it by the
 * same everywhere, within [0.5, 4] times the mean. Li et al. 2010, section 4.1.1, take the points
 * that quadric simplification leaves; it has no preference in flat parts and leaves them empty. As
 * collocation points and sources of the harmonic map, RMSEInside with the bending here against
 * vtkQuadricDecimation: dented spheres of 3k and 10k points to the ball 3.2e-3 against 3.6e-3 and
 * 3.4e-4 against 3.7e-4, two-torus to its polycube 1.6e-3 against 1.7e-3, twisted bar to its box
 * 3.3e-5 against 1.6e-3, in less time.
 *
 * Throws InvalidInput where count < 4 or the surface has no area, Aborted.
 */
Eigen::MatrixXd SampleSurface(const Mesh& surface, int count, SamplingMode mode,
  unsigned int seed = 1, const Progress& progress = {});

/// The same for several surfaces: `count` points shared out by area, but at least `least` to each.
/// The points of each surface.
std::vector<Eigen::MatrixXd> SampleSurfaces(const std::vector<Mesh>& surfaces, int count,
  int minimum, SamplingMode mode, unsigned int seed = 1, const Progress& progress = {});

/// The radius of the `count` equal discs that pack a plane of this area most densely.
double ComputePackingRadius(double area, int count);

/// The `count` rows of `points` (n x 3) that weighted elimination keeps, ascending, where radii (n)
/// is half the spacing wanted at each. Throws Aborted.
Eigen::VectorXi EliminateSamples(const Eigen::MatrixXd& points, const Eigen::VectorXd& radii,
  int count, const Progress& progress = {});

/**
 * How much area each of the points spread over a surface stands for, as a share of their mean (n):
 * the square of the mean distance to its 6 nearest neighbours, within a factor of 10.
 *
 * As weights they make a sum over the points an integral over the surface, however dense they are.
 * Without them the least squares of the harmonic map are drawn to where there are many.
 * RMSEVertices / RMSEInside of MultiLevel with adaptive samples, without and with: dented sphere of
 * 3k points 3.06e-3 / 2.93e-3 and 3.01e-3 / 2.33e-3, two-torus to its polycube 5.18e-3 / 4.70e-3
 * and 4.96e-3 / 4.34e-3.
 */
Eigen::VectorXd ComputeSampledAreas(const Eigen::MatrixXd& points);

/// The rows of `points` in an order in which neighbours in space are mostly neighbours in the list
/// (Morton's): taking every k-th one spreads a subset evenly.
Eigen::VectorXi FindSpatialOrder(const Eigen::MatrixXd& points);

} // namespace shape
