#pragma once

#include "Base/Progress.h"
#include "Distortion/InjectiveRefinement.h"
#include "Mesh/Cells.h"
#include "Mesh/Provenance.h"

#include <Eigen/Core>

#include <limits>

namespace shape
{

struct UntangleOptions
{
  bool FixBoundary = true; ///< if false, boundary points slide along the boundary's surface
  /// Maximum number of Newton steps for each connected patch of points in each round; >= 1.
  int MaximumIterations = 100;
  /// Maximum work of all Newton steps; > 0. A step of a patch of n points counts as n^1.5, which
  /// its time is about in proportion to. Patches whose steps would exceed it do not move.
  double MaximumWork = std::numeric_limits<double>::infinity();
  /// Whether tetrahedra may be split where their points have no positions that make them positive.
  /// If false, the result has the cells of the input.
  bool SplitCells = true;
  /// Whether RefineInjectively then lowers the mean distortion of the cells, and by which measure.
  RefineType Refine = RefineType::None;
  /// Exponent of ExponentialSymmetricDirichlet and AMIPS; > 0. The larger it is, the more the worst
  /// cells count.
  double RefineExponent = InjectiveRefinementOptions().Exponent;
};

struct UntangleResult
{
  Cells Solid; ///< one part of a split cell keeps its index; the others are appended
  /// The origin of points and cells in the input, whose points come first. A new point is the
  /// centroid of the points that it was inserted between.
  shape::Provenance Provenance;
  Eigen::VectorXi Inverted; ///< for each cell: 1 if it stays inverted, else 0
  int InvertedBefore = 0;   ///< number of inverted cells in the input
  int InvertedAfter = 0;    ///< number of inverted cells in the result
  int SplitCells = 0;       ///< number of input cells that were split
  int MovedPoints = 0;      ///< number of input points that were moved
  int Iterations = 0;       ///< total number of Newton steps
  double Work = 0.0;        ///< see MaximumWork; equal to it once a step would have exceeded it
  int ExpandedPoints = 0;   ///< number of points that were placed by exact tests
  /// Number of pairs of boundary triangles that cross or touch each other, up to 100. They are
  /// looked for only if cells stay inverted and the boundary is fixed.
  int BoundaryCrossings = 0;
  Eigen::RowVector3d FirstCrossing; ///< where the first pair crosses, if there is one
  /// Number of boundary edges at which the boundary folds back on itself: the two triangles overlap
  /// and lie in one plane, within rounding. There are hardly any positions between them in double
  /// precision. They are counted only if cells stay inverted and the boundary is fixed.
  int FoldedEdges = 0;
  Eigen::RowVector3d FirstFolded; ///< the midpoint of the first of them, if there is one
  /// Number of boundary triangles that the position closest to the inner side of all of them does
  /// not see. It is 0 if the boundary is star-shaped. They are counted only if cells stay inverted
  /// and the boundary is fixed.
  int HiddenTriangles = 0;
  Eigen::RowVector3d FirstHidden; ///< the centroid of the first of them, if there is one
  /// If the boundary is star-shaped, but cells stay inverted: the distance of that position from
  /// the nearest plane of a boundary triangle, relative to the size of the boundary. Below about
  /// 1e-12, distances inside are at the limits of double precision.
  double StarClearance = 0.0;
  /// Mean of the measure of Refine, weighted by volume at rest, before and after the refinement; 0
  /// without it. An exponential measure is lowered from the result with SymmetricDirichlet.
  double MeasureBefore = 0.0, MeasureAfter = 0.0;
  int RefineIterations = 0; ///< number of linear systems that the refinement solved
};

/**
 * Moves the points of a solid until no cell is inverted. Newton's method lowers the regularised
 * elliptic energy of Garanzha, Kaporin, Kudryavtseva, Protais, Ray and Sokolov, "Foldover-free maps
 * in 50 lines of code" (2021).
 *
 * cells: tetrahedra, pyramids, wedges and hexahedra, in VTK's order of points. A cell is inverted
 * if one of its corner tetrahedra is not positive; exact predicates decide this. A tetrahedron is
 * its own corner tetrahedron. For a pyramid, the corners of the base are tested, which is
 * sufficient for a positive Jacobian. For wedges and hexahedra, all corners are tested, which is
 * necessary for a positive Jacobian and nearly always sufficient.
 *
 * rest (n x 3, or empty): the positions of the points at rest, that is, before the map that is to
 * be untangled. The energy measures the distortion of cells relative to their rest shape, or
 * relative to regular cells if `rest` is empty. The target sizes of cells are measured at the
 * boundary, and interpolated smoothly inside.
 *
 * At first, only the points of inverted cells move. If that is not sufficient, points in a growing
 * neighbourhood move, too. A fixed boundary stays exactly unchanged. An inverted tetrahedron whose
 * four points are all fixed cannot become positive, so it is split. Other tetrahedra that stay
 * inverted are split later. No new point lies on an edge or face of the boundary.
 *
 * A patch ends early if its steps make no progress. If the solid then still has inverted cells and
 * consists of tetrahedra in a fixed boundary that is star-shaped, it starts anew. Cells are split
 * until each meets the boundary in one simplex (SeparateBoundary), and inner points start at the
 * means of their neighbours. Unless the boundary is near a sphere, the solid is untangled in a
 * sphere, which is much easier. The boundary then moves outward from there through a collar of new
 * tetrahedra (MoveOutward). In exact arithmetic that cannot fail, but many cells are split, and the
 * collar is thin. If it is too thin for double precision, the boundary goes back, and the solid is
 * untangled there. If that takes too much work, another collar is built in the sphere. It suits
 * each boundary triangle (BuildPatchCollar), and what it inverts below is made positive by exact
 * moves of single points (MoveIntoKernels) and by Newton's method, in turns.
 *
 * Other tetrahedra that are still inverted are made positive by exact tests: their points are put
 * at one position that sees all faces around them, for which the points around them make space, and
 * leave it one by one (after Nigolian, Campen and Bommes, "Expansion cones: a progressive
 * volumetric mapping framework" (2023)). Both methods take turns, four times at most. If inverted
 * cells still remain, everything is repeated with each inner point starting at the mean of its
 * neighbours, and the better result is returned. All limits are numbers of steps, so the work is
 * bounded. Cells that stay inverted, for example because the boundary crosses itself, are counted
 * and marked.
 *
 * If options.Refine is set, RefineInjectively then moves all points that the boundary permits, and
 * inverts no cell. The measure compares each cell with its rest shape or, if `rest` is empty, with
 * the regular cell of the target size. Cells that stay inverted do not count, and their points do
 * not move.
 *
 * Throws InvalidInput if a cell is of another kind, repeats a point or uses a point that does not
 * exist. Throws it also if there is no cell, a coordinate is not finite, an option is out of range,
 * or `rest` has another number of points. Throws it if the boundary encloses no volume or a
 * negative one, since then no cells can be positive, or if RequireExtent does. Throws SolveFailure
 * if an exponential measure exceeds the range of double, and Aborted.
 */
UntangleResult Untangle(const Cells& cells, const Eigen::MatrixXd& rest = {},
  const UntangleOptions& options = {}, const Progress& progress = {});

} // namespace shape
