/**
 * @class   vtkShapeUntangle
 * @brief   moves the points of a solid so that no cell is inverted
 *
 * Lowers the regularised elliptic energy of "Foldover-free maps in 50 lines of code" (Garanzha et
 * al. 2021) around inverted cells, with Newton's method.
 *
 * Inputs
 * - Input: tetrahedra, pyramids, wedges, hexahedra or voxels (which become hexahedra), mixed, in
 *   any data set, also composite or distributed: then points at the same place are joined.
 * - RestShape (optional): the same cells before they were moved: then the distortion of the map
 *   from there is what is lowered; else cells become like regular ones.
 *
 * Output: the cells, of which none is inverted (vtkUnstructuredGrid). A cell is inverted where the
 * tetrahedron that a corner makes with the ends of its edges is not positive, told exactly: of
 * hexahedra and wedges all corners are looked at, of pyramids those of the base. Tetrahedra that
 * cannot be positive while the boundary stays are split, with their neighbours; points that this
 * adds come last and have the mean of the data around. The boundary has no new points.
 * - Point arrays `OriginalPointId` (vtkIdType; -1 at new points) and `SourcePosition` (double, 3):
 *   the place in RestShape; without one Input's array of that name, or else the place in Input.
 * - Cell arrays `OriginalCellId` (vtkIdType): the cell of Input that it is, or is a part of;
 *   `Inverted` (int): 1 where a fold had to stay, since the boundary itself folds.
 *
 * Point normals are dropped. In parallel the first process has all cells.
 *
 * Field data: Untangle.InvertedBefore, .InvertedAfter, .SplitCells (of Input), .MovedPoints (of
 * Input), .Iterations (Newton steps of all patches).
 *
 * A Newton step is a single library call: an abort takes effect at its end.
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
  /// Whether the points of the boundary stay, to the bit; else those around inverted cells slide
  /// along it: not across its creases, nor from its corners. Default: on.
  vtkShapeOption(FixBoundary, bool);
  ///@}

  ///@{
  /// Newton steps that a patch of cells may take at a time. Default: 100.
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
