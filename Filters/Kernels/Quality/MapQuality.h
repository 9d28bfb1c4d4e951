#pragma once

#include "Base/Progress.h"
#include "Quality/CellSimplices.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Measures of an affine map with Jacobian J and singular values s_i in d = 2 (surfaces, between the
 * planes of the triangles) or 3 (solids) dimensions. |J| is the Frobenius norm.
 */
enum class MapMeasure
{
  JacobianDeterminant, ///< ratio of the areas or volumes; negative where flipped
  Dirichlet,           ///< |J|^2 / 2 (Pinkall & Polthier 1993): d / 2 for an isometry
  SymmetricDirichlet,  ///< |J|^2 + |J^-1|^2 (Smith & Schaefer 2015): 2 d for an isometry, the least
  /// |J|^2 / (d |det J|^(2/d)), the inverse mean ratio (Knupp 2001): 1 for a similarity, the least;
  /// on surfaces (s_1 / s_2 + s_2 / s_1) / 2.
  ConformalDistortion,
  ARAP ///< sum of (s_i - 1)^2 (Liu et al. 2008), the least s_i negative where flipped: 0 for an
       ///< isometry
};
constexpr int MapMeasureCount = 5;

/// What stands for infinity, and no measure exceeds.
constexpr double LargestMeasure = 1e30;

/// How far points are from where a map's sign has a meaning of its own; the greatest of several
/// parts' is the whole's.
struct MapExtent
{
  double SourceHeight = 0.0;    ///< greatest |z| of the points of surface cells
  double SourceOffSphere = 0.0; ///< greatest distance from the unit sphere around the origin
  double ImageHeight = 0.0;     ///< the same of the images
  double ImageOffSphere = 0.0;
  int Dimension = 0; ///< greatest of the cells': 3 with solids, 2 with surfaces alone, else 0
};

/// points, images: n x 3.
MapExtent ComputeMapExtent(
  const Eigen::MatrixXd& points, const Eigen::MatrixXd& images, const CellSimplices& cells);

struct MapQualityResult
{
  Eigen::MatrixXd Measures;   ///< m x MapMeasureCount, for each cell
  Eigen::VectorXd Sizes;      ///< m: area or volume; 0 where a cell is not counted or has none
  Eigen::VectorXi Counted;    ///< m: 1 for cells of the extent's dimension
  Eigen::VectorXi Flipped;    ///< m: 1 where JacobianDeterminant < 0
  Eigen::VectorXi Degenerate; ///< m: 1 where the cell, or the image of a part, has no size
};

/**
 * How far the map that takes `points` to `images` (n x 3, finite), and is affine on each simplex,
 * is from an isometry. Of a cell with several simplices JacobianDeterminant is the least, each
 * other measure the mean weighted by their sizes. Only cells of extent.Dimension are counted; the
 * others, and cells without size, have the values of an isometry. A part of a cell without size is
 * left out; where an image has none, SymmetricDirichlet and ConformalDistortion are LargestMeasure.
 * Without size means: at most 1e-14 of the longest edge squared or cubed.
 *
 * A surface's sign: a triangle is flipped where it changes sides. Its side is that of its order
 * against +z where all lies in the plane z = 0, against the radius where all lies on the unit
 * sphere, else against the summed area vectors of the other triangles around its corners, so that
 * folds show, but not the inside of a region that is turned as a whole. A source that does not lie
 * in the image's plane or sphere counts as facing outwards.
 *
 * extent: ComputeMapExtent the whole of which this may be a part. Throws Aborted.
 */
MapQualityResult EvaluateMapQuality(const Eigen::MatrixXd& points, const Eigen::MatrixXd& images,
  const CellSimplices& cells, const MapExtent& extent, const Progress& progress = {});

/// Sums over cells, to which those of other parts can be added.
struct MapQualitySums
{
  Eigen::Array<double, MapMeasureCount, 1> Minima;  ///< LargestMeasure without cells
  Eigen::Array<double, MapMeasureCount, 1> Maxima;  ///< -LargestMeasure without cells
  Eigen::Array<double, MapMeasureCount, 1> Sums;    ///< weighted by size, where defined
  Eigen::Array<double, MapMeasureCount, 1> Weights; ///< sizes of these cells
  /// Cells where a measure is not defined: without size, or at LargestMeasure.
  Eigen::Array<double, MapMeasureCount, 1> Undefined;
  double Cells = 0.0, Flipped = 0.0, Degenerate = 0.0; ///< counts

  MapQualitySums();
  /// Adds the counted cells for which use(m) is not 0.
  void Add(const MapQualityResult& result, const Eigen::VectorXi& use);
  /// The mean where it is defined, weighted by size; LargestMeasure where it is nowhere.
  double Mean(MapMeasure measure) const;
};

} // namespace shape
