#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Solids/IsoSurface.h"

#include <Eigen/Core>

#include <functional>

namespace shape
{

/// Where a grid line meets a triangle.
struct GridCrossing
{
  int Triangle;
  /// The grid point on the line before the crossing, or -1 if the line begins beyond it: x, y, z.
  Eigen::RowVector3i Before;
  double Position; ///< along the line's axis, in the model's units
  int Side;        ///< 1 if the line leaves through the front of the triangle, -1 if it enters
};

/**
 * Calls visit for each crossing of the grid's lines along an axis with triangles, triangle by
 * triangle. Exact orientations (Geometry/Orientation.h) decide which triangles a line crosses. A
 * line that meets an edge or a point is treated as if it were moved by an infinitesimal step along
 * the next axis (x, y, z, x) and a still smaller step along the one after it. On each line that
 * leaves a closed surface, the sides therefore sum to 0, even if triangles cross each other.
 *
 * mesh: any triangles. The grid's values are not used. Throws Aborted.
 */
void ForEachGridCrossing(const Mesh& mesh, const SampledGrid& grid, int axis,
  const std::function<void(const GridCrossing&)>& visit, const Progress& progress = {});

/**
 * Returns the winding number of a closed surface around each point of a grid: Counts.prod()
 * numbers, in the order of SampledGrid::Values. It is 1 inside a surface that faces outwards, 0
 * outside, and 2 where two solids overlap.
 *
 * Along each grid line in x, the signed crossings with triangles are counted (ForEachGridCrossing).
 *
 * mesh: closed and consistently oriented, within the grid's range in y and z. The grid's values are
 * not used. Throws Aborted.
 */
Eigen::VectorXi ComputeGridWindingNumbers(
  const Mesh& mesh, const SampledGrid& grid, const Progress& progress = {});

} // namespace shape
