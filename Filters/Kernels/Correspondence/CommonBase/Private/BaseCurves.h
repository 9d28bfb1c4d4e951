#pragma once

#include "Correspondence/CommonBase/Private/PathSurface.h"
#include "Correspondence/CommonBase/SurfaceCurves.h"

#include <array>
#include <vector>

namespace shape
{

/// A piece of a curve between two nodes of the base domain: its points on both surfaces.
struct CurvePiece
{
  std::array<int, 2> Nodes;
  std::array<std::vector<int>, 2> Points;
};

/**
 * Divides curves at the nodes on them, into pieces with different ends, of which no two have the
 * same ends: patches have three sides. A closed piece is divided into three equal lengths, and one
 * with the ends of an earlier piece into two. The points where it is divided are new nodes.
 *
 * surfaces: edges of curves are split where a new node lies inside one. nodes: for each surface,
 * the points of all nodes. The ends of curves and the new nodes are appended. Throws InvalidInput
 * if a curve is closed on one surface only, if curves meet at a point that is no node, if they pass
 * nodes in different orders on both surfaces, or if two points of a curve have no edge.
 */
std::vector<CurvePiece> DivideCurves(const std::vector<CurvePair>& curves,
  const std::array<PathSurface*, 2>& surfaces, const std::array<std::vector<int>*, 2>& nodes);

} // namespace shape
