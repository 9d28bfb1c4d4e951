/**
 * @class   vtkShapeTetrahedralize
 * @brief   fills the solid inside a closed surface with tetrahedra
 *
 * A constrained Delaunay tetrahedralisation, refined by TetGen until its tetrahedra keep the bounds
 * on shape and size.
 *
 * Inputs (polygons are triangulated inside)
 * - Input: the closed surface of the solid. A component inside an odd number of others bounds a
 *   void, which stays empty.
 * - InnerSurfaces (optional, repeatable): closed surfaces inside the solid, also inside one
 * another: borders between materials.
 *
 * Output: tetrahedra (vtkUnstructuredGrid) with the cell array `RegionId` (int): i + 1 inside inner
 * surface i, counted from 0 (the innermost around the tetrahedron), 0 where no inner surface is
 * around. Input's points come first and in order (but for those that no polygon uses and those at
 * the place of an earlier one), then the inner surfaces', then new ones. Point array
 * `OriginalPointId` (vtkIdType): the point of Input, or -1. Input's point data are passed on;
 * points that are not Input's get what lies at the closest place of Input's triangles. In parallel
 * the first process has all tetrahedra.
 *
 * Field data: Tetrahedralize.Points, .Tetrahedra, .SteinerPoints (points of no surface), .Regions,
 * .MinimumScaledJacobian (1 for the regular tetrahedron), .Volume.
 *
 * A surface that is open or crosses itself is refused, and the message says where. TetGen works in
 * a process of its own, so that no crash of it reaches ParaView; an abort ends it at once.
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
  /// The borders between materials.
  void AddInnerSurfaces(vtkAlgorithmOutput* surface);
  void RemoveAllInnerSurfaces();
  ///@}

  ///@{
  /// Bound on each tetrahedron's circumradius divided by its shortest edge: greater than 1, or 0
  /// for none. Beside sharp angles and a preserved boundary it can be missed. Default: 2.
  vtkShapeOption(MaximumRadiusEdgeRatio, double);
  ///@}

  ///@{
  /// Bound on each tetrahedron's volume, in the model's units cubed; 0 for none. Along a preserved
  /// boundary it can be missed, elsewhere by a few hundredths. Default: 0.
  vtkShapeOption(MaximumVolume, double);
  ///@}

  ///@{
  /// Whether every triangle of the surfaces is kept as it is; else points may be added on them.
  /// Default: on.
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
