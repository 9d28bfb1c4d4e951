#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/SolidCells.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/**
 * A collar of tetrahedra between a star-shaped boundary and a polyhedron inscribed in a sphere.
 *
 * Each inner edge from a boundary point v is split. The outer parts are a derived neighbourhood of
 * the boundary (Rourke and Sanderson, "Introduction to piecewise-linear topology" (1972), ch. 3).
 * Its inner side has a patch of triangles for each v, a strip for each boundary edge and a triangle
 * for each boundary triangle. The new points of v are on the sphere, in a circle around the ray of
 * v whose size suits the triangles at v. Those at tetrahedra of boundary triangles are on their
 * bisectors, and those at tetrahedra of boundary edges are between them. Each outer part then is
 * positive wherever the boundary points are on their rays outside the sphere. Inside the circle,
 * the patch is an embedding of Tutte. A new point that would have several places on the circle is
 * at their mean. If that inverts parts, tetrahedra and faces at v are split first, so that each
 * place has its own point.
 *
 * Unlike MoveOutward, this needs no distances below those of the boundary's own points, but
 * tetrahedra below the collar may be inverted.
 */
struct PatchCollar
{
  std::vector<std::array<int, 3>> Inside; ///< the triangles of the inner side, as seen from outside
  int Inverted = 0;                       ///< number of tetrahedra of the collar that are inverted
};

/// Builds a collar in a solid whose boundary is on a sphere around `centre` (ProjectToSphere),
/// where each tetrahedron meets it in one simplex (SeparateBoundary). Boundary points are at their
/// targets (MoveOutward) afterwards. Inner points stay. Throws Aborted.
PatchCollar BuildPatchCollar(SolidCells& solid, const Eigen::RowVector3d& centre,
  const Eigen::MatrixXd& targets, const Progress& progress);

} // namespace shape
