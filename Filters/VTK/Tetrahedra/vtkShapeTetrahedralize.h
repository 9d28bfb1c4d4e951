/**
 * @class   vtkShapeTetrahedralize
 * @brief   fill the solid inside a closed surface with tetrahedra
 *
 * TetGen computes a constrained Delaunay tetrahedralisation and refines it until the tetrahedra
 * satisfy the bounds on shape and volume.
 *
 * Inputs (polygons are triangulated internally)
 * - Input: the closed surface that bounds the solid. A component inside an odd number of other
 *   components bounds a void, which stays empty. With the cell array `Regions` (int, 2), which
 * Shape Label Surfaces makes, each triangle is between two regions, and the regions are filled.
 * - InnerSurfaces (optional, repeatable): closed surfaces inside the solid that are interfaces
 *   between materials. They may be nested.
 *
 * Output: tetrahedra (vtkUnstructuredGrid). In parallel, the first process has all of them. The
 * points of Input come first, in order. Points that no polygon uses, and duplicates of earlier
 * points, are omitted. The points of the inner surfaces follow, and then new points.
 * - Cell array `RegionId` (int): i + 1 if inner surface i (counted from 0) is the innermost surface
 *   around the cell; 0 outside all inner surfaces. With `Regions`, the label of the region.
 * - Point array `OriginalPointId` (vtkIdType): the index of the point in Input, or -1 for other
 *   points.
 * - Point data of Input. Points that are not from Input get the data at the closest position on the
 *   triangles of Input (vtkShapeCarry).
 *
 * Facts: Tetrahedralize.Points, .Tetrahedra, .SteinerPoints (number of points that belong to
 * no surface), .Regions, .MinimumScaledJacobian (1 for the regular tetrahedron), .Volume.
 *
 * Open or self-intersecting surfaces are errors, and the message gives the position of the defect.
 * TetGen runs in a separate process, so a crash of TetGen does not affect ParaView. An abort ends
 * this process immediately.
 *
 * The mathematics: shape::Tetrahedralize.
 */
#ifndef vtkShapeTetrahedralize_h
#define vtkShapeTetrahedralize_h

#include "vtkShapeAlgorithm.h"

#include "Tetrahedra/Tetrahedralize.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeTetrahedralize : public vtkShapeAlgorithm
{
public:
  static vtkShapeTetrahedralize* New();
  vtkTypeMacro(vtkShapeTetrahedralize, vtkShapeAlgorithm);

  ///@{
  /// The connections of the input InnerSurfaces.
  void AddInnerSurfaces(vtkAlgorithmOutput* surface);
  void RemoveAllInnerSurfaces();
  ///@}

  ///@{
  /// The properties. Effects and ranges: vtkShapeTetrahedralize.xml. Enumerations and defaults:
  /// shape::TetrahedralizeOptions.
  vtkShapeOption(MaximumRadiusEdgeRatio, double);
  vtkShapeOption(MaximumVolume, double);
  vtkShapeOption(PreserveBoundary, bool);
  ///@}

protected:
  vtkShapeTetrahedralize();
  ~vtkShapeTetrahedralize() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeTetrahedralize(const vtkShapeTetrahedralize&) = delete;
  void operator=(const vtkShapeTetrahedralize&) = delete;

  shape::TetrahedralizeOptions Options;
};

#endif
