#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct MapErrorCurveOptions
{
  /// What errors are divided by.
  enum class NormalisationType
  {
    None,             ///< errors are in the target's units
    SquareRootOfArea, ///< of the target's area
    GeodesicDiameter  ///< of the target: see ComputeGeodesicDiameter
  };
  NormalisationType Normalisation = NormalisationType::SquareRootOfArea;
  /// Upper limit of the area under the curve, in the units of Normalisation; > 0.
  double LargestError = 0.25;
};

/// Positions on one surface and their true images on another.
struct GroundTruth
{
  Eigen::MatrixXd Positions; ///< k x 3, on the first surface
  Eigen::MatrixXd Targets;   ///< k x 3, on the second surface
  Eigen::MatrixXd Mirrored;  ///< k x 3: equally true images, by a symmetry of the shape; or 0 x 0
};

struct MapErrorCurveResult
{
  Eigen::VectorXd Errors; ///< ascending; of the positions whose image is connected to the true one
  Eigen::VectorXd Shares; ///< equally many: the share of all k positions with at most this error
  double Mean = 0.0, Median = 0.0, Percentile95 = 0.0, Maximum = 0.0; ///< statistics of Errors
  /// The mean share over errors from 0 to LargestError, in [0, 1]: 1 for the true map.
  double AreaUnderCurve = 0.0;
  double Unit = 1.0;     ///< the length that errors were divided by
  bool Mirrored = false; ///< whether errors are relative to the mirrored truth
  int Unreached = 0;     ///< positions mapped to another component than the true one
  /// Maximum distance of the truth's positions from their surface, in model units.
  double LargestGap = 0.0;
};

/**
 * Measures how far a map between surfaces is from the true one, as a cumulative curve (Kim, Lipman
 * and Funkhouser, "Blended intrinsic maps", 2011, section 6).
 *
 * An error is the length of the shortest path along `target` from the image of a position to the
 * true one, exact on the polyhedron (ComputeExactGeodesicsBetween). A position is projected to the
 * nearest one on `input`, the map is interpolated there, and the result is projected to the nearest
 * position on `target`. With a mirrored truth, errors are relative to whichever truth has the
 * smaller mean error, for all positions together. So a map that is mirrored only in parts gains
 * nothing.
 *
 * input, target: 2-manifolds, open or closed. map: the images of the points of `input` (n x 3).
 * truth: at least one position. Throws InvalidInput if they are not, a value is not finite, an
 * option is out of range or no image is connected to its truth; Aborted.
 */
MapErrorCurveResult ComputeMapErrorCurve(const Surface& input, const Eigen::MatrixXd& map,
  const Surface& target, const GroundTruth& truth, const MapErrorCurveOptions& options = {},
  const Progress& progress = {});

/**
 * Computes the distance between each point of `input` that a triangle uses and its image under both
 * maps in turn: `map` (n x 3) to `target`, and `back` (m x 3, of the points of target). Distances
 * are exact along `input`, divided by the root of its area, ascending. Those of points that return
 * to another component are left out. All are 0 if the maps are inverse to each other. Arguments and
 * exceptions as above.
 */
Eigen::VectorXd ComputeRoundTripErrors(const Surface& input, const Eigen::MatrixXd& map,
  const Surface& target, const Eigen::MatrixXd& back, const Progress& progress = {});

/// Returns the share of `target`'s area that the image of `input` covers. A triangle is covered if
/// its centroid is at most a hundredth of the root of the area from the surface of input's
/// triangles at `map`.
double ComputeCoverage(const Surface& input, const Eigen::MatrixXd& map, const Surface& target,
  const Progress& progress = {});

/// Estimates the geodesic diameter: starting from a point, it moves to the farthest point by exact
/// distances as long as the distance increases. Returns the longest distance of all components,
/// which is at most the diameter and usually equal to it. surface: a 2-manifold with a triangle.
/// Throws Aborted.
double ComputeGeodesicDiameter(const Surface& surface, const Progress& progress = {});

} // namespace shape
