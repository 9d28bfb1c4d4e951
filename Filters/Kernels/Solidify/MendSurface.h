#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Solidify/MendedSurface.h"
#include "Solidify/SurfaceDefects.h"

namespace shape
{

/**
 * Makes triangles bound a solid without a change to those that are right already. The result is
 * closed, a manifold, oriented outwards (OrientByNesting), and does not intersect itself; all of
 * this is checked exactly.
 *
 * 1. Points within the tolerance are joined (JoinSoup). Triangles without area are removed, and
 *    their neighbours are split (SplitAtCollinearCorners). Only one of duplicate triangles is kept,
 *    and none of a wall between two solids (RemoveSameTriangles).
 * 2. At edges with three or more triangles, sheets that do not bound the solid are removed. Where
 *    parts of the solid touch along an edge or at a point, they are separated (SheetPairing.h).
 *    Copies of a point are moved apart by 1/1000 of their shortest edge.
 * 3. Triangles are reversed until neighbours agree. Small pieces are removed.
 * 4. Holes are filled (FillHoles), each with at most about 2000 points. A hole whose area vector
 *    has a fifth of the area or more is filled by a membrane, as a smooth fill may bulge far.
 *    Triangles that intersect others are replaced by fills, then those that the fills intersect, or
 *    a ring of triangles around them. They must be at most a tenth of all triangles, and the number
 *    of components and the Euler number must stay the same.
 * 5. Pieces are oriented by nesting.
 *
 * surface: any triangles. Parts that cross each other are not united. A component is a sheet if the
 * area vectors of its holes, whose lengths no fill undercuts, have 45 % of the area or more of
 * both: it encloses little, and no fill is the right one. Throws InvalidInput, with the number and
 * first position of the defects, if the result does not bound a solid; if sheets make up a tenth of
 * the area or more; or under the conditions of FindSurfaceDefects. Throws SolveFailure if a hole
 * cannot be filled; Aborted.
 */
MendedSurface MendSurface(
  const Mesh& surface, const SurfaceDefectOptions& options = {}, const Progress& progress = {});

} // namespace shape
