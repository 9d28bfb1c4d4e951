#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Solids/IsoSurface.h"

#include <Eigen/Core>

#include <cstdint>
#include <vector>

namespace shape
{

/// A solid as a set of grid points. No point on the grid's border is inside.
struct GridSolid
{
  SampledGrid Grid;         ///< its values are not used
  std::vector<char> Inside; ///< for each grid point, in the order of SampledGrid::Values
};

/// An edge of a grid: 3 times its first point, plus its axis.
using GridEdge = std::int64_t;

/// Returns the edges that have one end inside, ascending.
std::vector<GridEdge> FindBoundaryEdges(const GridSolid& solid);

/// The boundary of a solid on an edge of the grid.
struct EdgeCrossing
{
  double Share = 0.5; ///< from the first point of the edge to the second: 0 to 1
  Eigen::RowVector3d Normal = Eigen::RowVector3d::Zero(); ///< unit, or 0 if it is not known
};

/**
 * Returns the boundary of a solid on a grid, with its creases and corners. It is closed, a manifold
 * and oriented outwards, and does not intersect itself.
 *
 * The method is that of cubical marching squares (Ho, Wu, Chen, Chuang and Ouhyoung, "Cubical
 * marching squares: adaptive feature preserving surface extraction from volume data", 2005). There
 * is a point on each edge of `edges`. On a face of the grid, segments between such points separate
 * each chain of corners that are inside. If the normals at the ends of a segment differ by more
 * than the feature angle, it has a corner where the two lines meet. The segments on the faces of a
 * cell form loops. A loop with such a corner, or with normals that differ, is joined to a point
 * that minimises the distances from its tangent planes (Kobbelt, Botsch, Schwanecke and Seidel,
 * "Feature sensitive surface extraction from volume data", 2001). Other loops are split into
 * triangles.
 *
 * It cannot intersect itself: points on an edge or face have exactly the coordinates of this edge
 * or face, and each triangle lies in one cell. In a cell with one loop, the triangles are a cone
 * from an interior point, or from a point of the loop that shares no face with the points that it
 * is joined to. Planes separate several loops in a cell, which have no features.
 *
 * edges: FindBoundaryEdges. crossings: one for each edge. Points stay away from the ends of edges
 * and from the boundary of faces and cells by 1/10000 of the spacing. Throws Aborted.
 */
Mesh ContourGrid(const GridSolid& solid, const std::vector<GridEdge>& edges,
  const std::vector<EdgeCrossing>& crossings, const Progress& progress = {});

} // namespace shape
