#pragma once

#include "Base/Progress.h"
#include "Quality/CellSimplices.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Measures of an affine map with Jacobian J and singular values s_i in d dimensions: d = 2 between
 * the planes of surface triangles, d = 3 for solids. |J| is the Frobenius norm.
 */
enum class MapMeasure
{
  JacobianDeterminant, ///< ratio of the areas or volumes; negative if flipped
  Dirichlet,           ///< |J|^2 / 2 (Pinkall & Polthier 1993): d / 2 for an isometry
  SymmetricDirichlet,  ///< |J|^2 + |J^-1|^2 (Smith & Schaefer 2015): minimum 2 d for an isometry
  /// |J|^2 / (d |det J|^(2/d)), the inverse mean ratio (Knupp 2001): minimum 1 for a similarity; on
  /// surfaces (s_1 / s_2 + s_2 / s_1) / 2.
  ConformalDistortion,
  /// sum of (s_i - 1)^2 (Liu et al. 2008); the smallest s_i is negative if flipped; 0 for an
  /// isometry
  ARAP
};
constexpr int MapMeasureCount = 5;

/// Replaces infinity; no measure exceeds it.
constexpr double LargestMeasure = 1e30;

/// Maximum distances of the points from the plane z = 0 and from the unit sphere. If all points lie
/// in one of these, it defines the orientation of triangles. The extent of several parts has the
/// maximum of each value.
struct MapExtent
{
  double SourceHeight = 0.0;    ///< maximum |z| of the points of surface cells
  double SourceOffSphere = 0.0; ///< maximum distance from the unit sphere around the origin
  double ImageHeight = 0.0;     ///< SourceHeight of the images
  double ImageOffSphere = 0.0;
  int Dimension = 0; ///< highest dimension of a cell: 3 with solids, 2 with surfaces only, else 0
};

/// Computes the extent of a map. points, images: n x 3.
MapExtent ComputeMapExtent(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const CellSimplices& cells);

struct MapQualityResult
{
  Eigen::MatrixXd Measures; ///< m x MapMeasureCount, for each cell
  Eigen::VectorXd Sizes;    ///< m: area or volume; 0 if a cell is not counted or has no size
  Eigen::VectorXi Counted;  ///< m: 1 for cells of the extent's dimension
  Eigen::VectorXi Flipped;  ///< m: 1 if JacobianDeterminant < 0
  /// m: 1 if the cell, or the image of one of its simplices, has no size
  Eigen::VectorXi Degenerate;
};

/**
 * Measures how far the map from `points` to `images` (n x 3, finite), affine on each simplex, is
 * from an isometry. For a cell with several simplices JacobianDeterminant is their minimum; each
 * other measure is their mean weighted by size. Only cells of extent.Dimension are counted. The
 * others, and cells without size, have the values of an isometry. A simplex without size is
 * ignored. If an image has no size, SymmetricDirichlet and ConformalDistortion are LargestMeasure.
 * A simplex has no size if its area or volume is at most 1e-14 of its longest edge squared or
 * cubed.
 *
 * Sign on surfaces: a triangle is flipped if it faces different sides before and after the map. The
 * side is the sign of its normal relative to a reference. The reference is +z if all points lie in
 * the plane z = 0, and the radius if all lie on the unit sphere. Otherwise it is the sum of the
 * area vectors of the other triangles around its corners. This detects folds, but not the interior
 * of a region that is flipped as a whole. If the source does not lie in the same plane or sphere as
 * the image, it is assumed to face outwards.
 *
 * extent: ComputeMapExtent of the complete data, of which this may be a part. Throws Aborted.
 */
MapQualityResult EvaluateMapQuality(const Eigen::MatrixXd& points, const Eigen::MatrixXd& images,
  const CellSimplices& cells, const MapExtent& extent, const Progress& progress = {});

/// Sums over cells; the sums of several parts can be added.
struct MapQualitySums
{
  Eigen::Array<double, MapMeasureCount, 1> Minima; ///< LargestMeasure without cells
  Eigen::Array<double, MapMeasureCount, 1> Maxima; ///< -LargestMeasure without cells
  /// weighted by size, over cells where the measure is defined
  Eigen::Array<double, MapMeasureCount, 1> Sums;
  Eigen::Array<double, MapMeasureCount, 1> Weights; ///< total size of these cells
  /// Number of cells where a measure is undefined: without size, or at LargestMeasure.
  Eigen::Array<double, MapMeasureCount, 1> Undefined;
  double Cells = 0.0, Flipped = 0.0, Degenerate = 0.0; ///< numbers of cells

  MapQualitySums();
  /// Adds the counted cells m with use(m) != 0.
  void Add(const MapQualityResult& result, const Eigen::VectorXi& use);
  /// Returns the mean over cells where it is defined, weighted by size; LargestMeasure if there are
  /// none.
  double Mean(MapMeasure measure) const;
};

} // namespace shape
