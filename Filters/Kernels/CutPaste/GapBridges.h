#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Remesh/CurveImprinting.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Finds triangles that bridge the gaps between components of a surface, such as the slots between
 * panels, so that paths can cross them.
 *
 * Two boundary edges of different components face each other if they run in opposite directions,
 * are at most `width` apart, and one lies on the outer side of the other. Each boundary edge gets a
 * triangle to that end of the edges facing it from which it is seen under the largest angle: the
 * constrained Delaunay triangle of a flat gap. Positions are moved by 1e-6 of the edge for this
 * only, so that points on a circle have one triangulation. Of triangles that share an edge in the
 * same direction, the one with the smallest circumscribed circle is kept. Where three or more
 * components meet, a hole may remain.
 *
 * surface: triangles of three different points, oriented alike on both sides of a gap; otherwise
 * the gap is not bridged. Returns k x 3 points of the surface, oriented like its triangles. Throws
 * Aborted.
 */
Eigen::MatrixXi FindGapBridges(const Mesh& surface, double width, const Progress& progress = {});

/// The gaps that loops cross.
struct CrossedGaps
{
  int Count = 0;       ///< number of sides of the loops that cross a gap
  double Widest = 0.0; ///< the length of the longest such side
};

/**
 * Removes the bridges from a surface on which loops were imprinted. given: number of triangles
 * before the bridges, which follow them. isFeature: for each triangle of `split`, whether it is on
 * the feature's side; afterwards for each remaining one. loops: of points of `split`. A point that
 * is not on triangles of both sides is left out: it is in a gap, which the loop then crosses in a
 * straight line. Afterwards the feature is to the left. Throws InvalidInput if fewer than 3 points
 * of a loop remain.
 */
CrossedGaps RemoveGapBridges(int given, ImprintedCurves& split, std::vector<char>& isFeature,
  std::vector<std::vector<int>>& loops);

} // namespace shape
