/**
 * @class   vtkShapeUntangle
 * @brief   move the points of a solid so that no cell is inverted
 *
 * Minimises the regularised elliptic energy of "Foldover-free maps in 50 lines of code" (Garanzha
 * et al. 2021) around inverted cells, with Newton's method.
 *
 * Inputs
 * - Input: tetrahedra, pyramids, wedges, hexahedra or voxels (which become hexahedra), mixed, in
 *   any data set, also composite or distributed. Coincident points of several pieces are merged.
 * - RestShape (optional): the same cells before they were moved. The distortion of the map from
 *   there is then minimised. Without it cells approach regular ones.
 *
 * Output: the cells, none of them inverted (vtkUnstructuredGrid). A cell is inverted if the
 * tetrahedron of a corner and the ends of its edges has no positive volume, by an exact predicate.
 * All corners of hexahedra and wedges are checked, and those of the base of pyramids. Tetrahedra
 * that cannot be positive while the boundary is fixed are split, with their neighbours. New points
 * come last and have the mean of the values around them. The boundary has no new points.
 * - Point arrays `OriginalPointId` (vtkIdType; -1 at new points) and `SourcePosition` (double, 3):
 *   the position in RestShape. Without RestShape it is the array of Input with that name, or the
 *   position in Input.
 * - Cell array `OriginalCellId` (vtkIdType): the cell of Input of which it is a part.
 * - Cell array `Inverted` (int): 1 if a fold remains because the boundary itself folds.
 *
 * Point normals are dropped. In parallel the first process has all cells.
 *
 * Field data: Untangle.InvertedBefore, .InvertedAfter, .SplitCells (of Input), .MovedPoints (of
 * Input), .Iterations (Newton steps of all patches).
 *
 * A Newton step cannot be interrupted, so an abort takes effect at its end.
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
