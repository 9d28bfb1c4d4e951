/**
 * @class   vtkShapeUntangle
 * @brief   move the points of a solid so that no cell is inverted
 *
 * Minimises the regularised elliptic energy of "Foldover-free maps in 50 lines of code" (Garanzha
 * et al. 2021) around inverted cells, with Newton's method. Where it stalls, tetrahedra are made
 * positive by exact tests and splits, after "Expansion cones" (Nigolian et al. 2023).
 *
 * Inputs
 * - Input: tetrahedra, pyramids, wedges, hexahedra and voxels (which become hexahedra), of any data
 *   set, which may be composite or distributed. Coincident points of different pieces move as one;
 *   those of a distributed input are merged, and the blocks on one process keep theirs.
 * - RestShape (optional): the same cells before they were moved. The distortion of the map from
 *   RestShape to the output is then minimised. If RestShape is not connected, the cells become as
 *   regular as possible.
 *
 * Output (vtkUnstructuredGrid): the cells, after untangling. The edges at a corner of a cell span a
 * tetrahedron. A cell is inverted if one of these tetrahedra does not have positive volume, which
 * an exact predicate decides. Hexahedra and wedges are checked at all corners, and pyramids at the
 * four corners of the base. Some tetrahedra cannot have positive volume while the boundary is
 * fixed. They are split, together with their neighbours. New points come last and get the mean of
 * the values at the points around them. No new point lies on the boundary.
 * - Point arrays `OriginalPointId` (vtkIdType; -1 at new points) and `SourcePosition` (double, 3):
 *   the position in RestShape. If RestShape is not connected, SourcePosition is copied from Input
 *   or, if Input has none, contains the positions in Input.
 * - Cell array `OriginalCellId` (vtkIdType): the index of the cell of Input to which the cell
 *   belongs.
 * - Cell array `Inverted` (int): 1 if the cell is still inverted, for example because the boundary
 *   itself folds; otherwise 0.
 *
 * Point normals are dropped. In parallel, the first process has all cells.
 *
 * Facts, with the prefix Untangle
 * - .InvertedBefore, .InvertedAfter: numbers of inverted cells.
 * - .SplitCells: number of cells of Input that were split. .MovedPoints: number of points of Input
 *   that were moved.
 * - .Iterations: number of Newton steps in all patches. .ExpandedPoints: number of points that were
 *   placed by exact tests where these steps stalled.
 * - .Reason: why cells stay inverted, or empty.
 * - .MeasureBefore, .MeasureAfter: mean of the measure of Refine before and after the refinement,
 *   weighted by the volume at rest; 0 without it. If RestShape is connected, MeasureAfter is the
 *   mean of Shape Map Quality of the map from RestShape to the output. An exponential measure is
 *   lowered from the result with SymmetricDirichlet. .RefineIterations: number of linear systems
 *   that the refinement solved.
 *
 * The mathematics: shape::Untangle.
 */
#ifndef vtkShapeUntangle_h
#define vtkShapeUntangle_h

#include "vtkShapeAlgorithm.h"

#include "Untangle/Untangle.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeUntangle : public vtkShapeAlgorithm
{
public:
  static vtkShapeUntangle* New();
  vtkTypeMacro(vtkShapeUntangle, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeUntangle.xml. Enumerations and defaults:
  /// shape::UntangleOptions.
  vtkShapeOption(FixBoundary, bool);
  vtkShapeOption(MaximumIterations, int);
  vtkShapeOption(SplitCells, bool);
  vtkShapeEnumOption(Refine, shape::RefineType, shape::RefineType::None, shape::RefineType::ARAP);
  vtkShapeOption(RefineExponent, double);
  ///@}

protected:
  vtkShapeUntangle();
  ~vtkShapeUntangle() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeUntangle(const vtkShapeUntangle&) = delete;
  void operator=(const vtkShapeUntangle&) = delete;

  shape::UntangleOptions Options;
};

#endif
