#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

struct SheetRepairOptions
{
  /// Whether steps 2 and 4 separate sheets. Otherwise they stay connected, for a computation that
  /// needs no manifold.
  bool Separate = true;
};

/// A surface that is a manifold except for its orientation, if sheets are separated. Unless a sheet
/// is left out, it has the shape of the given one.
struct RepairedSheets
{
  /// All given points, then copies of some. The remaining triangles, in their order.
  Mesh Surface;
  std::vector<int> Points;    ///< for each point, the given point at the same position
  std::vector<int> Triangles; ///< for each triangle, the given triangle
  /// For each given point, the point that represents it: usually itself. For the ends of an edge
  /// without length, it is the first of them.
  std::vector<int> Representatives;

  int NonManifoldEdges = 0;    ///< edges with three or more triangles
  int FirstNonManifold = -1;   ///< a point of the first of them, or -1
  int SharedEdges = 0;         ///< such edges that remain, because sheets are not separated
  int SplitPoints = 0;         ///< copies of points
  int FirstSplit = -1;         ///< the first point that was copied, or -1
  int JoinedPoints = 0;        ///< ends of edges without length that another end replaces
  int DegenerateTriangles = 0; ///< removed: fewer than three different points
  int DuplicateTriangles = 0;  ///< removed: equal to an earlier triangle
  int FinTriangles = 0;        ///< removed: triangles of fins
  int FirstRemoved = -1;       ///< the first given triangle that was removed, or -1

  int RemovedTriangles() const
  {
    return this->DegenerateTriangles + this->DuplicateTriangles + this->FinTriangles;
  }
  bool IsChanged() const { return this->RemovedTriangles() + this->SplitPoints > 0; }
};

/**
 * Repairs what prevents a computation on a surface and can be repaired without a decision about its
 * shape:
 *
 * 1. The ends of an edge without length (1e-12 of the longest edge of a triangle) become one point.
 *    Triangles with fewer than three different points are removed, and so are triangles that have
 *    the corners of an earlier one in the same cyclic order.
 * 2. At an edge with three or more triangles, sheets are separated: sets of triangles that are
 *    connected by edges with two triangles. If two triangles of a sheet meet there with opposite
 *    directions, they stay connected. Of the others, those on both sides of a wedge of the solid
 *    that the triangles bound stay connected; of three, those closest to one plane. All other
 *    triangles end at the edge.
 * 3. A fin is removed. It is a piece that ends at such an edge, each of its triangles has a point
 *    of such an edge, its area is at most 1% of that of the surface, and a larger piece has the
 *    edge, too. Such a piece is no more than noise at the edge.
 * 4. A point where several fans of triangles touch is split: the first fan keeps the point, and
 *    each other fan gets a copy.
 *
 * mesh: indices must be in range, and points finite where triangles use them.
 */
RepairedSheets RepairSheets(const Mesh& mesh, const SheetRepairOptions& options = {});

} // namespace shape
