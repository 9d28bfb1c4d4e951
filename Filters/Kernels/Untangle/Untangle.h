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
  bool FixBoundary = true;     ///< else its points slide along the boundary's surface
  int MaximumIterations = 100; ///< Newton steps that a patch of cells may take at a time; >= 1
};

struct UntangleResult
{
  Cells Solid; ///< those cells that were split come where they were, their other parts at the end
  /// From the input, whose points come first. A new point has the mean of the points that it was
  /// put between.
  shape::Provenance Provenance;
  Eigen::VectorXi Inverted; ///< for each cell: 1 where it could not be made positive
  int InvertedBefore = 0;   ///< cells of the input that were inverted
  int InvertedAfter = 0;    ///< cells of the result that are
  int SplitCells = 0;       ///< cells of the input that were split
  int MovedPoints = 0;      ///< points of the input that are elsewhere now
  int Iterations = 0;       ///< Newton steps of all patches
};

/**
 * Moves the points of a solid so that no cell is inverted, by lowering the regularised elliptic
 * energy of Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov, "Foldover-free maps in 50
 * lines of code" (2021), with Newton's method.
 *
 * cells: tetrahedra, pyramids, wedges, hexahedra, in VTK's order of points. A cell is inverted
 * where a corner tetrahedron is not positive (a tetrahedron is its own; the corners of a pyramid's
 * base, which suffice; all corners of wedges and hexahedra, which are necessary for a positive
 * Jacobian, and nearly always suffice); exact predicates decide this. rest (n x 3, or empty): the
 * same points before the map to be untangled, whose distortion is what the energy measures; else
 * cells become like regular ones. Sizes are those of the boundary, smooth inside.
 *
 * Only points around inverted cells move, with more of their surroundings where that does not
 * suffice. With a fixed boundary, which stays to the bit, some tetrahedra cannot be positive, such
 * as those with four points on it; those are split, and so are, in the end, the edges of other ones
 * that stay inverted. New points are put on no edge or face of the boundary.
 *
 * Where that leaves inverted cells, it goes on with three times as many Newton steps, and then all
 * is done once more with the points inside put into the middle of their neighbours first; the best
 * result counts. What stays inverted, since the boundary itself is, is counted and marked. Throws
 * InvalidInput for other cells, coordinates that are not finite, options out of range, or a rest
 * shape of another number of points; Aborted.
 */
UntangleResult Untangle(const Cells& cells, const Eigen::MatrixXd& rest = {},
  const UntangleOptions& options = {}, const Progress& progress = {});

/**
 * A solid that a map of its boundary's surface has carried, without inverted cells: points of the
 * solid's boundary that lie on the surface (to 1e-6 of its longest side) are put exactly on its
 * image, the others stay where the map took them, and what is inside is untangled, the boundary
 * fixed (Untangle). The result is a mesh, not a map that could be evaluated elsewhere.
 *
 * domain: solid cells before the map; moved (n x 3): where it took their points. boundary: a
 * surface in the domain's space; targets: the images of its points. Throws what Untangle throws.
 */
UntangleResult ComputeFoldFreeMap(const Cells& domain, const Eigen::MatrixXd& moved,
  const Mesh& boundary, const Eigen::MatrixXd& targets, const Progress& progress = {});

} // namespace shape
