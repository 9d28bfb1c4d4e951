#pragma once

#include "Hex/Features/PatchedBoundary.h"

#include <vector>

namespace shape
{

/**
 * A layer of hexahedra under some patches. It ends at their border, with a row of quads in the
 * patches beyond: then no quad there has two edges in a row on a curve (each surface and each curve
 * has sheets of its own, as in Ledoux and Shepherd, "Topological and geometrical properties of
 * hexahedral meshes", 2010). New points lie where those they are copies of do.
 *
 * PatchOf and Quads change; curves and corners have to be found anew.
 */
void PillowPatches(HexMesh& mesh, const std::vector<int>& patches, PatchedBoundary& boundary);

/// A layer of hexahedra under the whole boundary, whose quads and points stay.
void PillowBoundary(HexMesh& mesh, PatchedBoundary& boundary);

/// Puts the copies under each point of the boundary evenly between the lowest of them and the
/// point.
void SmoothPillows(const PatchedBoundary& boundary, Eigen::MatrixXd& points);

} // namespace shape
