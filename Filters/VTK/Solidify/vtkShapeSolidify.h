/**
 * @class   vtkShapeSolidify
 * @brief   turn any triangles or polygons into the closed surface of a solid
 *
 * Input: polygons in a vtkPolyData or vtkUnstructuredGrid, also composite or distributed. They may
 * be unconnected, open, duplicated, degenerate, or not oriented. Other cells than polygons and
 * strips are not used; solid cells are an error.
 *
 * Outputs
 * - Solid: the surface (vtkPolyData). If nothing has to be changed, it has the points and polygons
 *   of Input, bit for bit and in the same order. Otherwise, it consists of triangles: those of
 *   Input and their parts first, in order, then new ones. Point and cell data are carried
 * (vtkShapeCarry). Cell array `Origin` (int): 0 for a cell of Input, 1 for a changed one, 2 for a
 * new one.
 * - Defects: a vertex at each defect of Input, with the point array `Defect` (int), the value of
 *   shape::DefectKind.
 *
 * Facts, with the prefix Solidify
 * - .Method: the method that was used; Report if nothing was changed.
 * - Numbers of defects of Input: .NotFinitePoints, .LoosePoints, .DuplicatePoints,
 *   .DegenerateTriangles, .DuplicateTriangles, .NonManifoldEdges, .NonManifoldPoints,
 *   .MisorientedEdges, .InvertedPieces, .OpenLoops, .SelfIntersections, .SmallPieces. .Defects:
 *   their sum.
 * - .PiecesBefore, .Pieces, .EulerNumberBefore, .EulerNumber: topology of Input and of Solid.
 * - .Kept, .Mended, .Made: numbers of cells with Origin 0, 1 and 2.
 * - .GapsClosed, .SplitPoints, .ReversedTriangles, .RemovedTriangles, .RemovedPieces: what was
 *   changed.
 * - .GridSpacing: of the grid on which the surface was made, or 0.
 * - .DistanceFromInput, .DistanceToInput: the largest distance of a position on Input from Solid,
 *   and of a position on Solid from Input.
 *
 * In parallel, the first process has the outputs.
 *
 * The mathematics: shape::Solidify.
 */
#ifndef vtkShapeSolidify_h
#define vtkShapeSolidify_h

#include "vtkShapeAlgorithm.h"

#include "Solidify/Solidify.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeSolidify : public vtkShapeAlgorithm
{
public:
  static vtkShapeSolidify* New();
  vtkTypeMacro(vtkShapeSolidify, vtkShapeAlgorithm);

  ///@{
  /// The properties. Effects and ranges: vtkShapeSolidify.xml. Enumerations and defaults:
  /// shape::SolidifyOptions, shape::SurfaceDefectOptions.
  vtkShapeEnumOption(
    Method, shape::SolidifyMethod, shape::SolidifyMethod::Automatic, shape::SolidifyMethod::Wrap);
  vtkShapeOptionOf(Options.Defects, Tolerance, double);
  vtkShapeOption(DetailSize, double);
  vtkShapeOption(GapSize, double);
  vtkShapeOption(SheetThickness, double);
  vtkShapeOptionOf(Options.Defects, SmallestPiece, double);
  ///@}

protected:
  vtkShapeSolidify();
  ~vtkShapeSolidify() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeSolidify(const vtkShapeSolidify&) = delete;
  void operator=(const vtkShapeSolidify&) = delete;

  void AddFacts(const shape::SolidifyResult& result);

  shape::SolidifyOptions Options;
};

#endif
