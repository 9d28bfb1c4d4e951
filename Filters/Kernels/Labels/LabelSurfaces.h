#pragma once

#include "Base/Progress.h"
#include "Labels/LabelImage.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

struct LabelSurfacesOptions
{
  /// Waves of the interfaces that are shorter than this many voxels, such as the voxels' steps, are
  /// smoothed away; in [0, 40]. No point moves more than half a voxel along each axis of the image,
  /// or one voxel where three regions meet.
  double Smoothing = 12.0;
  /// Connected parts of a region with fewer voxels get the label around them; >= 0.
  int SmallestIsland = 0;
  /// The labels that are kept; all others become the outside. If empty, all are kept.
  std::vector<int> Labels;
};

/// What became of a label.
struct LabelRegion
{
  int Label = 0;
  double ImageVolume = 0.0;   ///< of its voxels, in the image's units cubed
  double SurfaceVolume = 0.0; ///< that its surfaces enclose
  int Components = 0;         ///< of its surface
  int EulerNumber = 0;        ///< of its surface
};

/// The interfaces between the regions of an image: one surface, whose triangles occur once each.
struct LabelSurfacesResult
{
  Eigen::MatrixXd Points;    ///< n x 3
  Eigen::MatrixXi Triangles; ///< m x 3
  /// m x 2: the labels on both sides; the normal leaves the first, which is the greater.
  Eigen::MatrixXi Regions;
  /// Curves where three or more regions meet, each as a sequence of points. The first and last
  /// points of a closed curve are equal. Other curves end at Corners.
  std::vector<std::vector<int>> Curves;
  std::vector<int> Corners;                ///< points where curves end or meet, ascending
  std::vector<LabelRegion> RegionsByLabel; ///< ascending, without the outside
  int Islands = 0;                         ///< number of parts that got the label around them
  double IslandVoxels = 0.0;               ///< their number of voxels
  int Intersections = 0;                   ///< number of pairs of triangles that intersect
  int SplitPoints = 0; ///< points that were split because a region touched itself there
};

/**
 * Extracts the interfaces between the regions of a label image as one conforming surface.
 *
 * A net of polygons separates samples with different labels (SurfaceNet: Gibson 1998; Frisken
 * 2022). It is smoothed within its cells by an energy of second order, so that interfaces become
 * flat without shrinking (SmoothNet). Then each point moves across the surface by a multiple of the
 * gradients of the volumes of the regions around it, such that each region has the volume of its
 * voxels, or of the net if the labels come from grey values. The multiples are the pressures of the
 * regions.
 *
 * The surface of each region is closed, oriented and manifold: voxels of a region that touch along
 * an edge are connected, or separated by the region that is connected across; where a region
 * touches itself in a point, the point is split.
 *
 * Throws InvalidInput if the image has no sample, if its axes are not finite and independent, if no
 * label remains, if there are more points or triangles than an int can number or if an option is
 * out of range; Aborted.
 */
LabelSurfacesResult ExtractLabelSurfaces(
  LabelImage image, const LabelSurfacesOptions& options = {}, const Progress& progress = {});

} // namespace shape
