#pragma once

#include "Hex/Features/RegionTargets.h"
#include "Mesh/HexMesh.h"

#include <vector>

namespace shape
{

/**
 * Inserts sheets of hexahedra so that interfaces and curves between regions can be smooth (Ledoux
 * and Shepherd, "Topological and geometrical properties of hexahedral meshes", 2010). The edge
 * chains of a grid have steps. If a quad of an interface has two consecutive edges on a curve, its
 * corner between them becomes a straight angle, and no position of points makes the hexahedra at
 * this corner good.
 *
 * A sheet along the outer side of a region's boundary ends on each interface that meets the region
 * at a curve. It inserts a row of quads there, each with one edge on the curve. Every region gets
 * one that has such a quad beside it, the outside included. If an interface has a single quad at a
 * wide angle between two curves, a sheet inside the union of its two regions makes two of it.
 *
 * New points have the positions of the points that they copy. regionOf: the label of each
 * hexahedron, extended by those of new ones. cellSize: as for MatchRegions.
 */
void InsertRegionSheets(
  HexMesh& mesh, std::vector<int>& regionOf, const RegionTargets& targets, double cellSize);

} // namespace shape
