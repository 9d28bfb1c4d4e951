#pragma once

#include "Base/Progress.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes a lower bound of the Gromov-Hausdorff distance of two finite metric spaces. If a
 * correspondence pairs x with y and changes no distance by more than 2 d, then each distance from x
 * is within 2 d of a distance from y, and the reverse. So d is at least half the Hausdorff distance
 * of these two sets of numbers. Every point has a partner, so the bound is the largest over all
 * points of the smallest over all partners. It is no smaller than half the difference of the
 * diameters, nor than the bound by eccentricities (Memoli, "Some properties of Gromov-Hausdorff
 * distances", 2012).
 *
 * distancesA, distancesB: square and symmetric, with zero diagonals; the sizes may differ.
 */
double BoundGromovHausdorff(const Eigen::MatrixXd& distancesA, const Eigen::MatrixXd& distancesB,
  const Progress& progress = {});

struct GromovHausdorffOptions
{
  int Samples = 50; ///< of each surface; >= 2
};

/// How much two maps change distances. Lengths are in the model's units.
struct GromovHausdorffResult
{
  double Maximum = 0.0;        ///< the largest change of a distance: the distortion
  double RootMeanSquare = 0.0; ///< of the changes
  double Upper = 0.0;          ///< half of Maximum
  double Lower = 0.0;          ///< by BoundGromovHausdorff
  /// The largest distance of a point of a surface from the nearest sample of that surface, added
  /// for both surfaces.
  double SamplingError = 0.0;
};

/**
 * Bounds the Gromov-Hausdorff distance of two surfaces by the maps between them.
 *
 * The samples of A (SampleFarthestPoints) and their images, and the samples of B and their images,
 * are pairs of corresponding points (Bronstein, Bronstein and Kimmel, "Generalized multidimensional
 * scaling", 2006: the distortion of each map and of both together). Two finite spaces result, of
 * twice as many points on each surface. Lower and Upper bound their distance, with exact distances
 * along the triangles. Those of more than four edges are exact at the points of the surface, and
 * linear in the triangle of an image. The distance of the surfaces is at least Lower -
 * SamplingError and at most Upper + SamplingError.
 *
 * a, b: surfaces that RequireConnected accepts. The time grows with the number of samples and the
 * square of the number of points. Throws InvalidInput, SolveFailure, Aborted.
 */
GromovHausdorffResult MeasureGromovHausdorff(const Surface& a, const Surface& b,
  const SurfaceMaps& maps, const GromovHausdorffOptions& options = {},
  const Progress& progress = {});

} // namespace shape
