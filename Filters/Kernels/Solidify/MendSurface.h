#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Provenance.h"
#include "Solidify/SurfaceDefects.h"

#include <Eigen/Core>

namespace shape
{

/// Where a triangle of a mended surface comes from.
enum class TriangleOrigin
{
  Kept,   ///< a triangle of the input: the same positions in the same order
  Mended, ///< a triangle of the input that was reversed, split, or has a moved corner
  Made    ///< a new triangle
};

struct MendedSurface
{
  Mesh Surface; ///< closed, see MendSurface; the triangles of the input come first, in order
  Eigen::VectorXi Origin;       ///< for each triangle, its TriangleOrigin
  shape::Provenance Provenance; ///< from the input
  int SplitPoints = 0;          ///< number of copies of points, where sheets of the surface touched
  int ReversedTriangles = 0;    ///< number of triangles whose orientation was changed
  int RemovedTriangles = 0;     ///< number of triangles that were removed or replaced
  int RemovedPieces = 0;        ///< number of pieces smaller than SmallestPiece
  int GapsClosed = 0;       ///< number of holes that were filled, also in place of intersections
  double GridSpacing = 0.0; ///< if the surface was made on a grid, its spacing
};

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
 * 4. Holes are filled (FillHoles). Triangles that intersect others are replaced by fills, then
 *    those that the fills intersect, or a ring of triangles around them. They must be at most a
 *    tenth of all triangles, and the number of components and the Euler number must stay the same.
 * 5. Pieces are oriented by nesting.
 *
 * surface: any triangles. Parts that cross each other are not united.
 * Throws InvalidInput, with the number and first position of the defects, if the result does not
 * bound a solid, or under the conditions of FindSurfaceDefects; SolveFailure if a hole cannot be
 * filled; Aborted.
 */
MendedSurface MendSurface(
  const Mesh& surface, const SurfaceDefectOptions& options = {}, const Progress& progress = {});

} // namespace shape
