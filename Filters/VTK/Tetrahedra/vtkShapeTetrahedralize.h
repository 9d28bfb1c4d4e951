/**
 * @class   vtkShapeTetrahedralize
 * @brief   fill the solid inside a closed surface with tetrahedra
 *
 * TetGen computes a constrained Delaunay tetrahedralisation and refines it to the bounds on shape
 * and size.
 *
 * Inputs (polygons are triangulated internally)
 * - Input: the closed surface of the solid. A component inside an odd number of others bounds a
 *   void, which stays empty.
 * - InnerSurfaces (optional, repeatable): closed surfaces inside the solid, also nested:
 *   interfaces between materials.
 *
 * Output: tetrahedra (vtkUnstructuredGrid). In parallel the first process has all of them. The
 * points of Input come first and in order, except those that no polygon uses and duplicates of
 * earlier ones. Those of the inner surfaces follow, then new ones.
 * - Cell array `RegionId` (int): i + 1 inside inner surface i, counted from 0, otherwise 0. Inside
 *   several surfaces, the innermost one determines it.
 * - Point array `OriginalPointId` (vtkIdType): the point of Input, or -1.
 * - Point data of Input. Other points get those at the closest position on the triangles of Input
 *   (vtkShapeCarry).
 *
 * Field data: Tetrahedralize.Points, .Tetrahedra, .SteinerPoints (points of no surface), .Regions,
 * .MinimumScaledJacobian (1 for the regular tetrahedron), .Volume.
 *
 * Open or self-intersecting surfaces are errors, and the message gives the position. TetGen runs
 * in its own process, so that its crash cannot reach ParaView. An abort ends it at once.
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
  /// The interfaces between materials.
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
