#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/SolidCells.h"
#include "Untangle/Private/StarKernel.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Returns the boundary triangles as faces that a position inside sees.
std::vector<StarFace> FindStarFaces(const SolidCells& solid);

/// Returns a position that sees boundary triangles from inside (FindKernelCentre). If these are
/// all, the boundary is star-shaped around it. Not valid if there is none.
StarPlacement FindStarCentre(const SolidCells& solid, const std::vector<StarFace>& faces);

/// Splits inner edges, and then inner faces, with all points on the boundary. Afterwards each
/// tetrahedron with an inner point has one edge, face or point of the boundary, or none. All cells
/// have to be tetrahedra. Throws Aborted.
void SeparateBoundary(SolidCells& solid, const Progress& progress = {});

/// Moves the boundary points along their rays from `centre` to a sphere around it. Its radius is
/// half the least distance of a boundary point.
void ProjectToSphere(SolidCells& solid, const Eigen::RowVector3d& centre);

/// Moves the boundary points to their targets (n x 3); further rows are of inner points.
void MoveBoundary(SolidCells& solid, const Eigen::MatrixXd& targets);

/**
 * Moves the boundary points of a solid without inverted tetrahedra along their rays from `centre`
 * outwards, however far, with a collar of new tetrahedra around the unmoved rest.
 *
 * The boundary points are on a sphere around `centre` (ProjectToSphere), and each tetrahedron meets
 * the boundary in one simplex (SeparateBoundary). Each inner edge from a boundary point v is split
 * near v, where it meets a plane at a small depth below v, perpendicular to its ray. The outer
 * parts are the collar: a derived neighbourhood of the boundary (Rourke and Sanderson,
 * "Introduction to piecewise-linear topology" (1972), ch. 3). The inner parts stay positive,
 * because they are parts of positive tetrahedra.
 *
 * In the limit of small depths, outer parts with one boundary point are positive, since the new
 * points are seen in the same order from v, wherever it is on its ray. Those at a triangle of the
 * boundary become prisms between two positions of the triangle. Those at a boundary edge are
 * positive if the edge sees its new points in order, as from infinity. If not, the inner faces at
 * the edge are split first, on a parabola around the edge, which restores the order. Depths are
 * halved until exact tests accept the tetrahedra.
 *
 * targets (n x 3): the boundary points' positions afterwards, farther from `centre` on the same
 * rays, and any positions of the inner points. Returns the number of tetrahedra that are inverted
 * afterwards, which is 0 unless distances are too small for double precision. Throws Aborted.
 */
int MoveOutward(SolidCells& solid, const Eigen::RowVector3d& centre, const Eigen::MatrixXd& targets,
  const Progress& progress);

} // namespace shape
