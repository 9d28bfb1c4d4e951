#pragma once

#include "Hex/Voxels/RegionMeetings.h"
#include "Solids/IsoSurface.h"

#include <vector>

namespace shape
{

/**
 * Changes the regions of single cells of a grid until, at each corner of a cell, the cells of each
 * region are connected by faces, and so are all other cells: the boundary of each region is then a
 * manifold (Latecki, "3D well-composed pictures", 1997, for each region). If possible, only regions
 * that meet share faces and edges, so that a region thinner than a cell keeps its neighbours
 * apart.
 *
 * A change must lower the number of faults around the cell. Among equal changes, the one whose cell
 * is closest to an interface is taken.
 *
 * grid: its values are the distances of the cells' centres from the interfaces. regionOf: the
 * region of each cell; the outermost cells are outside and stay so. Returns the number of corners
 * that stay faulty.
 */
int RepairRegions(
  const SampledGrid& grid, const RegionMeetings& meetings, std::vector<int>& regionOf);

/// Gives parts of a region beyond its largest `wanted` parts to the region that shares most faces
/// with them. Parts are connected by faces. wanted: for each region, also the outside. Returns the
/// number of these parts.
int DissolveParts(
  const SampledGrid& grid, const std::vector<int>& wanted, std::vector<int>& regionOf);

} // namespace shape
