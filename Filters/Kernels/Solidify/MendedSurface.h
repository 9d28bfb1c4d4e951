#pragma once

#include "Mesh/Mesh.h"
#include "Mesh/Provenance.h"

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

} // namespace shape
