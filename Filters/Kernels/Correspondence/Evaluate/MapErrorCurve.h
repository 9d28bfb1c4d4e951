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
    SquareRootOfArea, ///< of the target
    GeodesicDiameter  ///< of the target: see GeodesicDiameter
  };
  NormalisationType Normalisation = NormalisationType::SquareRootOfArea;
  /// The area under the curve is that up to here, > 0, in the units of Normalisation.
  double LargestError = 0.25;
};

/// Where positions on one surface truly go on another.
struct GroundTruth
{
  Eigen::MatrixXd Positions; ///< k x 3, on the first surface
  Eigen::MatrixXd Targets;   ///< k x 3, on the second
  Eigen::MatrixXd Mirrored;  ///< k x 3: as true, by a symmetry of the shape; or 0 x 0
};

struct MapErrorCurveResult
{
  Eigen::VectorXd Errors; ///< ascending; of positions from which a path leads to the truth
  Eigen::VectorXd Shares; ///< as many, of all k positions: whose error is at most this
  double Mean = 0.0, Median = 0.0, Percentile95 = 0.0, Maximum = 0.0; ///< of Errors
  /// The mean share over errors from 0 to LargestError: 1 for the true map, at least 0.
  double AreaUnderCurve = 0.0;
  double Unit = 1.0;       ///< what errors were divided by
  bool Mirrored = false;   ///< whether they are to the mirrored truth
  int Unreached = 0;       ///< positions on another component than their truth
  double LargestGap = 0.0; ///< from a position of the truth to its surface, in their units
};

/**
 * How far a map between surfaces is from the true one, as a cumulative curve (Kim,
 * Lipman and Funkhouser, "Blended intrinsic maps", 2011, section 6).
 *
 * An error is the length of the shortest path along `target`, exact on the polyhedron
 * (ComputeExactGeodesicsBetween), from the image of a position to the true one. A position is
 * projected to the nearest one on `input`, the map interpolated there, and the result projected to
 * the nearest one on `target`. With a mirrored truth the errors are those to the truth that has the
 * smaller mean, one of the two for all positions: a map that is mirrored in parts has no merit.
 *
 * input, target: 2-manifolds, open or closed. map: where the points of `input` go (n x 3). truth:
 * at least one position. Throws InvalidInput if they are not such ones, a value is not finite, an
 * option is out of range or no path leads to any truth; Aborted.
 */
MapErrorCurveResult ComputeMapErrorCurve(const Surface& input, const Eigen::MatrixXd& map,
  const Surface& target, const GroundTruth& truth, const MapErrorCurveOptions& options = {},
  const Progress& progress = {});

/**
 * How far each point of `input` that a triangle uses comes back from itself by `map` (n x 3) to
 * `target` and `back` (m x 3, of the points of target): exact distances along `input`, divided by
 * the root of its area, ascending; those of positions on another component left out. 0 if the maps
 * are each other's inverses. Arguments and exceptions as above.
 */
Eigen::VectorXd ComputeRoundTripErrors(const Surface& input, const Eigen::MatrixXd& map,
  const Surface& target, const Eigen::MatrixXd& back, const Progress& progress = {});

/// The share of `target`'s area that the image of `input` lies on: of triangles whose centroid is
/// at most a hundredth of the root of the area away from the surface of its triangles at `map`.
double ComputeCoverage(const Surface& input, const Eigen::MatrixXd& map, const Surface& target,
  const Progress& progress = {});

/// The longest of the distances found by going to the farthest point, and from that on, while it is
/// farther, by exact distances; of the component where it is longest. At most the diameter, which
/// it mostly is. surface: a 2-manifold with a triangle. Throws Aborted.
double ComputeGeodesicDiameter(const Surface& surface, const Progress& progress = {});

} // namespace shape
