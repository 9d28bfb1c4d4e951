#pragma once

#include "Mesh/Mesh.h"
#include "Solids/IsoSurface.h"

#include <Eigen/Core>

namespace shape
{

/**
 * How often a closed surface winds around each point of a grid: Counts.prod() numbers in the order
 * of its values, 1 inside one that faces outwards, 0 outside; 2 where two such solids overlap.
 *
 * Along each of the grid's lines in x the crossings with triangles are counted with their sign.
 * Exact orientations (Geometry/Orientation.h) decide which triangles a line crosses; one that meets
 * an edge or a point counts as if it were moved by an infinitesimal step in y and a smaller one in
 * z, so that the numbers are consistent whatever the triangles are like: they may cross each other.
 *
 * mesh: closed and consistently oriented, within the grid in y and z where its lines are to be
 * right. The grid's values are not used.
 */
Eigen::VectorXi ComputeGridWindingNumbers(const Mesh& mesh, const SampledGrid& grid);

} // namespace shape
