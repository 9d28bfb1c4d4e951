#pragma once

#include "Base/Progress.h"
#include "Mesh/Cells.h"
#include "Mesh/Mesh.h"
#include "Mesh/Provenance.h"

#include <Eigen/Core>

namespace shape
{

struct UntangleOptions
{
  bool FixBoundary = true;     ///< if false, boundary points slide along the boundary's surface
  int MaximumIterations = 100; ///< maximum number of Newton steps for a patch at a time; >= 1
};

struct UntangleResult
{
  Cells Solid; ///< one part of a split cell has its index, the other parts are appended
  /// From the input, whose points come first. A new point is the centroid of the points that it was
  /// inserted between.
  shape::Provenance Provenance;
  Eigen::VectorXi Inverted; ///< for each cell: 1 if it stays inverted, else 0
  int InvertedBefore = 0;   ///< number of inverted cells in the input
  int InvertedAfter = 0;    ///< number of inverted cells in the result
  int SplitCells = 0;       ///< number of the input's cells that were split
  int MovedPoints = 0;      ///< number of the input's points that were moved
  int Iterations = 0;       ///< number of Newton steps in all patches
};

/**
 * Moves the points of a solid until no cell is inverted. Newton's method lowers the regularised
 * elliptic energy of Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov, "Foldover-free maps
 * in 50 lines of code" (2021).
 *
 * cells: tetrahedra, pyramids, wedges, hexahedra, in VTK's order of points. A cell is inverted if
 * one of its corner tetrahedra is not positive, which exact predicates decide. A tetrahedron is its
 * own corner tetrahedron. For a pyramid the corners of the base are sufficient. For wedges and
 * hexahedra all corners are tested, which is necessary for a positive Jacobian and nearly always
 * sufficient.
 *
 * rest (n x 3, or empty): the points before the map that is to be untangled; the energy measures
 * the distortion from there. If empty, cells become similar to regular ones. The sizes of cells are
 * given by the boundary, and interpolated smoothly inside.
 *
 * Only points around inverted cells move, and more of their surroundings if that is not sufficient.
 * A fixed boundary stays exactly unchanged. Some tetrahedra then cannot be positive, such as those
 * with four points on it, and are split. Finally, the edges of other tetrahedra that stay inverted
 * are split, too. No new point lies on an edge or face of the boundary.
 *
 * If inverted cells remain, three times as many Newton steps are tried. Then everything is repeated
 * from a state in which inner points are the means of their neighbours. The best result is
 * returned. Cells that stay inverted because the boundary itself is inverted are counted and
 * marked.
 *
 * Throws InvalidInput if a cell is of another kind, a coordinate is not finite, an option is out of
 * range, or the rest shape has another number of points; Aborted.
 */
UntangleResult Untangle(const Cells& cells, const Eigen::MatrixXd& rest = {},
  const UntangleOptions& options = {}, const Progress& progress = {});

/**
 * Carries a solid by a map of its boundary's surface, without inverted cells. Boundary points of
 * the solid that lie on the surface (within 1e-6 of the longest edge of its bounding box) are put
 * exactly on its image. The other boundary points stay where the map took them. The interior is
 * then untangled with a fixed boundary (Untangle). The result is a mesh, not a map that could be
 * evaluated elsewhere.
 *
 * domain: solid cells before the map. moved (n x 3): the images of their points. boundary: a
 * surface in the space of the domain. targets: the images of its points. Throws what Untangle
 * throws.
 */
UntangleResult ComputeFoldFreeMap(const Cells& domain, const Eigen::MatrixXd& moved,
  const Mesh& boundary, const Eigen::MatrixXd& targets, const Progress& progress = {});

} // namespace shape
