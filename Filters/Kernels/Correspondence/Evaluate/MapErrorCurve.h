#pragma once

#include "Base/Progress.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

struct MapErrorCurveOptions
{
  /// The length by which errors are divided.
  enum class NormalisationType
  {
    None,             ///< 1: errors are in the target's units
    SquareRootOfArea, ///< the square root of the target's area
    GeodesicDiameter  ///< the target's ComputeGeodesicDiameter
  };
  NormalisationType Normalisation = NormalisationType::SquareRootOfArea;
  /// The largest error (> 0) that AreaUnderCurve covers, in units of MapErrorCurveResult::Unit.
  double LargestError = 0.25;
};

/// Positions on one surface and their true images on another.
struct GroundTruth
{
  Eigen::MatrixXd Positions; ///< k x 3, on the first surface
  Eigen::MatrixXd Targets;   ///< k x 3, on the second surface
  /// k x 3: the images after a symmetry of the shape, which are equally true; 0 x 0 if there are
  /// none.
  Eigen::MatrixXd Mirrored;
};

struct MapErrorCurveResult
{
  Eigen::VectorXd Errors; ///< ascending; of positions whose image is connected to the true one
  /// k: the error of each position; -1 if its image is not connected to the true one.
  Eigen::VectorXd PositionErrors;
  Eigen::VectorXd Shares; ///< for each error e, the share of all k positions with errors <= e
  double Mean = 0.0, Median = 0.0, Percentile95 = 0.0, Maximum = 0.0; ///< statistics of Errors
  /// The mean share over errors from 0 to LargestError, in [0, 1]: 1 for the true map.
  double AreaUnderCurve = 0.0;
  double Unit = 1.0;     ///< the length by which errors were divided
  bool Mirrored = false; ///< whether Errors are distances from GroundTruth::Mirrored
  int Unreached = 0;     ///< number of positions mapped to the wrong component
  /// Maximum distance of a position or true image of GroundTruth from its surface, in model units.
  double LargestGap = 0.0;
};

/**
 * Measures how far a map between surfaces is from the true one, as a cumulative curve (Kim, Lipman
 * and Funkhouser, "Blended intrinsic maps", 2011, section 6).
 *
 * An error is the length of the shortest path along `target` from the image of a position to its
 * true image, exact on the polyhedron (ComputeExactGeodesicsBetween). A position is projected to
 * the nearest position on `input`, the map is interpolated there, and the result is projected to
 * the nearest position on `target`. If mirrored images are given, the mean error is computed once
 * with the true images and once with the mirrored ones. The images with the smaller mean error are
 * used for all positions. A map that is mirrored only in parts therefore gains nothing.
 *
 * input, target: 2-manifolds, open or closed. map: the images of the points of `input` (n x 3).
 * truth: at least one position. Throws InvalidInput if a surface is not a 2-manifold, a matrix has
 * the wrong size, a value is not finite, or an option is out of range. Also throws InvalidInput if
 * no image is connected to its true image. Throws Aborted.
 */
MapErrorCurveResult ComputeMapErrorCurve(const Surface& input, const Eigen::MatrixXd& map,
  const Surface& target, const GroundTruth& truth, const MapErrorCurveOptions& options = {},
  const Progress& progress = {});

/**
 * Computes the round-trip error of each point of `input` that a triangle uses: the distance to its
 * image under both maps in turn. map: n x 3, the images on `target` of the points of `input`. back:
 * m x 3, the images on `input` of the points of `target`. Distances are exact along `input` and
 * divided by the root of its area. Returns the errors in ascending order, without the points that
 * return to another component. All errors are 0 if the maps are inverse to each other. Throws
 * InvalidInput if a surface is not a 2-manifold, a matrix has the wrong size, or a value is not
 * finite; Aborted.
 */
Eigen::VectorXd ComputeRoundTripErrors(const Surface& input, const Eigen::MatrixXd& map,
  const Surface& target, const Eigen::MatrixXd& back, const Progress& progress = {});

/// Returns the share of `target`'s area that the image of `input` covers. The image consists of
/// input's triangles, with their points moved to the positions `map` (n x 3). A triangle of
/// `target` is covered if its centroid is at most a hundredth of the root of target's area away
/// from the image. Throws InvalidInput if `map` has the wrong size or a value that is not finite;
/// Aborted.
double ComputeCoverage(const Surface& input, const Eigen::MatrixXd& map, const Surface& target,
  const Progress& progress = {});

/// Estimates the geodesic diameter by exact distances. In each component, the search moves from a
/// point to the farthest point as long as this distance increases, at most ten times. Returns the
/// longest distance found, which is at most the diameter and usually equal to it. surface: a
/// 2-manifold with a triangle. Throws Aborted.
double ComputeGeodesicDiameter(const Surface& surface, const Progress& progress = {});

} // namespace shape
