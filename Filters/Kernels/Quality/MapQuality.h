#pragma once

#include "Base/Progress.h"
#include "Quality/CellSimplices.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Measures of an affine map with Jacobian J and singular values s_i. The dimension d is 2 for a map
 * between the planes of surface triangles, and 3 for solids. |J| is the Frobenius norm.
 */
enum class MapMeasure
{
  /// area or volume of the image, divided by the area or volume of the source; negative if flipped
  JacobianDeterminant,
  Dirichlet, ///< |J|^2 / 2 (Pinkall & Polthier 1993); d / 2 for an isometry
  /// |J|^2 + |J^-1|^2 (Smith & Schaefer 2015); minimum 2 d, for an isometry
  SymmetricDirichlet,
  /// |J|^2 / (d |det J|^(2/d)), the inverse mean ratio (Knupp 2001); minimum 1, for a similarity.
  /// On surfaces it equals (s_1 / s_2 + s_2 / s_1) / 2.
  ConformalDistortion,
  /// sum of (s_i - 1)^2 (Liu et al. 2008); 0 for an isometry. If the map flips, the smallest s_i is
  /// taken as negative.
  ARAP,
  /// sum of log(|s_i|)^2, the Hencky strain squared (Rabinovich et al. 2017, table 1); 0 for an
  /// isometry
  Hencky,
  /// exp(c + a / 2) with a = AreaDistortion and c = (s_1 / s_2 + s_2 / s_1) / 2 on surfaces,
  /// (|J|^2 |J^-1|^2 - 1) / 8 in solids (Fu, Liu and Guo 2015); minimum exp(3/2), for an isometry
  AMIPS,
  /// (|det J| + 1 / |det J|) / 2, of area or volume; minimum 1, where size is preserved
  AreaDistortion,
  /// How much the image must be stretched to get the source back (Sander et al. 2001): the root
  /// mean square |J^-1| / sqrt(d) over all directions, and the maximum 1 / min |s_i|; both are 1
  /// for an isometry.
  L2Stretch,
  LinfStretch,
  SmallestSingularValue, ///< min |s_i|: the minimum factor of a length
  LargestSingularValue   ///< max |s_i|: the maximum factor of a length
};
constexpr int MapMeasureCount = 12;

/// Replaces infinite values, so no measure exceeds it.
constexpr double LargestMeasure = 1e30;

/// The maximum distances of the points from the plane z = 0 and from the unit sphere. If all points
/// lie in that plane or on that sphere, the plane or sphere defines the orientation of triangles.
/// The extent of data in several parts consists of the maximum of each value over the parts.
struct MapExtent
{
  double SourceHeight = 0.0; ///< maximum |z| of the points of surface cells
  /// maximum distance of these points from the unit sphere around the origin
  double SourceOffSphere = 0.0;
  double ImageHeight = 0.0; ///< maximum |z| of the images of these points
  double ImageOffSphere = 0.0;
  int Dimension = 0; ///< highest dimension of a cell: 3 with solids, 2 with surfaces only, else 0
};

/// Computes the extent of the map from `points` to `images` (n x 3).
MapExtent ComputeMapExtent(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const CellSimplices& cells);

struct MapQualityResult
{
  Eigen::MatrixXd Measures; ///< m x MapMeasureCount: the measures of each cell
  Eigen::VectorXd Sizes;    ///< m: area or volume; 0 if a cell is not counted or has no size
  Eigen::VectorXi Counted;  ///< m: 1 for cells of the extent's dimension
  Eigen::VectorXi Flipped;  ///< m: 1 if JacobianDeterminant < 0
  /// m: 1 if a counted cell, or the image of one of its simplices, has no size, or if a measure
  /// other than AMIPS, which grows exponentially, is LargestMeasure
  Eigen::VectorXi Degenerate;
};

/**
 * Measures how far the map from `points` to `images` (n x 3, finite) is from an isometry. The map
 * is affine on each simplex. JacobianDeterminant of a cell is the minimum over its simplices; every
 * other measure is the mean over its simplices, weighted by size. Only cells of extent.Dimension
 * are counted. All other cells, and cells without size, get the values of an isometry. A simplex
 * without size is ignored. If an image has no size, JacobianDeterminant and SmallestSingularValue
 * are 0, and the measures that divide by them are LargestMeasure. A simplex has no size if the
 * determinant of its edges is at most 1e-14 of its longest edge squared (triangles) or cubed
 * (tetrahedra).
 *
 * Sign on surfaces: a triangle is flipped if it faces different sides before and after the map. Its
 * side is the sign of the dot product of its normal and a reference vector. The reference is +z if
 * all points lie in the plane z = 0, and the radius vector if all points lie on the unit sphere.
 * Otherwise it is the sum of the area vectors of the other triangles around its corners. This
 * detects folds, but not the interior of a region that is flipped as a whole. If the source and the
 * image do not use the same kind of reference, the source is assumed to face outwards.
 *
 * extent: the result of ComputeMapExtent for the complete data; the given cells may be only a part
 * of these. Throws Aborted.
 */
MapQualityResult EvaluateMapQuality(const Eigen::MatrixXd& points, const Eigen::MatrixXd& images,
  const CellSimplices& cells, const MapExtent& extent, const Progress& progress = {});

/// Sums, minima and maxima of the measures over cells. The summaries of several parts of the data
/// can be combined.
struct MapQualitySums
{
  Eigen::Array<double, MapMeasureCount, 1> Minima; ///< LargestMeasure if there are no cells
  Eigen::Array<double, MapMeasureCount, 1> Maxima; ///< -LargestMeasure if there are no cells
  /// sums of measure times size, over the cells where the measure is defined
  Eigen::Array<double, MapMeasureCount, 1> Sums;
  Eigen::Array<double, MapMeasureCount, 1> Weights; ///< total size of these cells
  /// Number of cells where a measure is undefined: the cell has no size, or the measure is
  /// LargestMeasure.
  Eigen::Array<double, MapMeasureCount, 1> Undefined;
  double Cells = 0.0, Flipped = 0.0, Degenerate = 0.0; ///< numbers of cells

  MapQualitySums();
  /// Adds each counted cell c with use(c) != 0.
  void Add(const MapQualityResult& result, const Eigen::VectorXi& use);
  /// Returns the mean of a measure, weighted by size, over the cells where it is defined;
  /// LargestMeasure if there are none.
  double Mean(MapMeasure measure) const;
};

} // namespace shape
