#pragma once

#include "Mesh/Mesh.h"
#include "Solids/IsoSurface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Returns the winding number of a closed surface around each point of a grid: Counts.prod()
 * numbers, in the order of SampledGrid::Values. It is 1 inside a surface that faces outwards, 0
 * outside, and 2 where two solids overlap.
 *
 * Along each grid line in x, the signed crossings with triangles are counted. Exact orientations
 * (Geometry/Orientation.h) decide which triangles a line crosses. A line that meets an edge or a
 * point is treated as if it were moved by an infinitesimal step in y and a still smaller step in z.
 * The numbers are therefore consistent, even if triangles cross each other.
 *
 * mesh: closed and consistently oriented, within the grid's range in y and z. The grid's values are
 * not used.
 */
Eigen::VectorXi ComputeGridWindingNumbers(const Mesh& mesh, const SampledGrid& grid);

} // namespace shape
