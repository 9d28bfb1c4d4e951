/**
 * @class   vtkShapeHexRemesh
 * @brief   fills the solid inside a closed surface with hexahedra
 *
 * No hexahedron is inverted; the boundary has the surface's topology, and its creases and corners
 * where the cells are fine enough for them.
 *
 * Input
 * - Surface: the closed surface of one solid or several, with voids (polygons are triangulated
 *   inside). One that crosses itself bounds what it winds around at least once.
 *
 * Outputs
 * - hexahedra (vtkUnstructuredGrid) with the cell arrays `ScaledJacobian` (double: Verdict's, 1 for
 *   a box) and `RegionId` (int: 0).
 * - their boundary (vtkPolyData, quads) with the cell arrays `Patch` (int: quads of one number lie
 *   between creases) and `Distance` (double: of the quad's middle to the surface); over the points
 *   of the hexahedra that it uses, whose numbers are `OriginalPointId`.
 * In parallel the first process has all of both.
 *
 * Field data of both: HexRemesh.Method ("Polycube" or "Grid"), .Reason (why that one), .Hexahedra,
 * .MinimumScaledJacobian, .MeanScaledJacobian, .ScaledJacobianHistogram (20 numbers of hexahedra:
 * scaled Jacobians in [0, 0.05), [0.05, 0.1), ..., [0.95, 1]), .Distance (the larger one-sided
 * Hausdorff distance between the boundary and the surface), .CellSize, .Patches, .Corners (of the
 * surface), .CreasesKept (1, or 0 where the cells are too coarse for some crease and none is kept),
 * .CornersKept (corners of the surface that are points of the boundary), .CreaseDistance (the
 * larger one-sided Hausdorff distance between creases of the surface and of the boundary; to the
 * boundary where none is kept), .CreaseShare (of the length of all that is as sharp as a crease,
 * that of the creases that were looked for: less than 1 where some end inside a patch, or bound
 * patches smaller than 4 cells), .Crossings (pairs of the surface's triangles that cross),
 * .EulerNumber and .Components of the boundary.
 *
 * The mathematics: shape::HexRemesh.
 */
#ifndef vtkShapeHexRemesh_h
#define vtkShapeHexRemesh_h

#include "vtkShapeAlgorithm.h"

#include "Hex/HexRemesh.h" // for the options

class VTKSHAPEFILTERS_EXPORT vtkShapeHexRemesh : public vtkShapeAlgorithm
{
public:
  static vtkShapeHexRemesh* New();
  vtkTypeMacro(vtkShapeHexRemesh, vtkShapeAlgorithm);

  ///@{
  /// 0 = Automatic: the better one of the two. 1 = Polycube: the cells of a polycube of the solid,
  /// which needs TetGen and a surface that does not cross itself. 2 = Grid: the cells of a grid in
  /// the solid. Default: Automatic.
  vtkShapeEnumOption(Method, shape::HexRemeshOptions::MethodType,
    shape::HexRemeshOptions::MethodType::Automatic, shape::HexRemeshOptions::MethodType::Grid);
  ///@}

  ///@{
  /// Of the hexahedra, in the surface's units; smaller ones are used where these cannot have the
  /// solid's topology, and where the surface asks for them. 0: about 20,000 hexahedra, or more
  /// where these are not good enough. Default: 0.
  vtkShapeOption(CellSize, double);
  ///@}

  ///@{
  /// Layers of hexahedra along the surface: at least 1. Default: 1.
  vtkShapeOption(PaddingLayers, int);
  ///@}

  ///@{
  /// Edges of the surface whose triangles' normals are more than so many degrees apart are creases,
  /// as far as they bound patches: in (0, 180]; 180: none. Default: 40.
  vtkShapeOption(FeatureAngle, double);
  ///@}

protected:
  vtkShapeHexRemesh();
  ~vtkShapeHexRemesh() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeHexRemesh(const vtkShapeHexRemesh&) = delete;
  void operator=(const vtkShapeHexRemesh&) = delete;

  shape::HexRemeshOptions Options;
};

#endif
