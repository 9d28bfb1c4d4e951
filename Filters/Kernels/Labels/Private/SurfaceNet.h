#pragma once

#include "Base/Progress.h"
#include "Labels/LabelImage.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// The edges of a net that a smoothing follows: both end points are on a curve where three or more
/// regions meet, or the edge lies inside an interface.
struct NetEdge
{
  int First, Second;
  bool IsOnJunction; ///< whether three or more regions meet along the edge
};

/**
 * The interfaces between the regions of a label image as a net of polygons (Gibson, "Constrained
 * elastic surface nets", 1998; Frisken, "SurfaceNets for multi-label segmentations with
 * preservation of sharp boundaries", 2022, sections 3.1 and 3.2).
 *
 * A cube of eight neighbouring samples has one point for each sheet of interfaces that runs through
 * it. Two neighbouring samples with different labels are separated by a polygon that joins the
 * points of the four cubes around them.
 *
 * Two sheets may pass through the face between two cubes: the labels of its corners are a b a c in
 * cyclic order. Then region a is connected along the face's diagonal, and the sheets stay apart. If
 * both diagonals have one label, the connected one is the inside, or the lower label. If two sheets
 * have the same two points on the sides of a face, each gets a point of its own on the face. So
 * every edge is surrounded by each region at most once.
 *
 * Coordinates are those of the image's indices. No point leaves its cell, a cube with its centre at
 * Centres and half its edge in Reach. Inside an interface, the cell is the point's cube. A region
 * that ends in a sharp edge has samples only where it is about as wide as a voxel, so that the
 * curve along the edge lies ahead of the cubes with three labels: there, the cell reaches one
 * voxel.
 */
struct SurfaceNet
{
  Eigen::MatrixXd Points;     ///< n x 3: the mean of the crossings (FindCrossing) of the sheet
  Eigen::MatrixXd Centres;    ///< n x 3: the centre of the point's cell
  Eigen::VectorXd Reach;      ///< n: 0.5, and 1 at JunctionPoints
  Eigen::MatrixXi Triangles;  ///< m x 3; the normal leaves the first region
  Eigen::MatrixXi Regions;    ///< m x 2: the labels on both sides; the first is the greater
  std::vector<NetEdge> Edges; ///< the edges of the polygons, without their diagonals
  /// Triangles 2 i and 2 i + 1 for i < Quads are the halves of a polygon with four corners.
  int Quads = 0;
  /// Points with three or more regions around them, ascending.
  std::vector<int> JunctionPoints;
};

/// Builds the net. Throws InvalidInput if there are more points or triangles than an int can
/// number; Aborted.
SurfaceNet BuildSurfaceNet(const LabelImage& image, const Progress& progress = {});

} // namespace shape
