#pragma once

#include "IO/CADModel.h"
#include "IO/Private/OpenCascade.h"

namespace shape
{

/// Joins triangulated faces: the faces of a region share the points on their common edges and
/// vertices. Triangles that become lines or points are left out. OpenEdges is not counted. Throws
/// SolveFailure if a face has no triangles, or an edge has different numbers of points in two
/// faces.
CADModel JoinFaces(CascadeModel faces);

} // namespace shape
