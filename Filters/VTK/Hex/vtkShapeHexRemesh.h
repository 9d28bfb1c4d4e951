/**
 * @class   vtkShapeHexRemesh
 * @brief   fills the solid inside a closed surface with hexahedra
 *
 * No hexahedron is inverted; the boundary has the surface's topology, and its creases and corners
 * where the cells are fine enough for them.
 *
 * Inputs (polygons are triangulated inside)
 * - Surface: the closed surface of one solid or several, with voids. One that crosses itself bounds
 *   what it winds around at least once.
 * - Polycube (optional): a surface whose faces lie across the axes at whole multiples of one
 * length, with the point array `SourcePosition` (3): where its points lie on Surface. The second
 * output of Shape Polycube is such a surface. The hexahedra are its cells then.
 * - InnerSurfaces (optional, repeatable): closed surfaces inside the solid, also inside one
 * another: borders between materials. Hexahedra of two regions share points there, which lie on the
 * inner surface; its creases are rounded. They need the cells of a grid.
 *
 * Outputs
 * - hexahedra (vtkUnstructuredGrid) with the cell arrays `ScaledJacobian` (double: Verdict's, 1 for
 *   a box), `RegionId` (int: i + 1 inside inner surface i, the innermost
 *   around, counted from 0; else 0), and further measures of Verdict's (double): `Jacobian`,
 * `Volume`, `EdgeRatio` (longest to shortest edge), `MaxAspectFrobenius` (1 for a cube),
 * `EquiangleSkew` (0 for a box, 1 where an angle of a face is 0 or 180 degrees), `Skew`, `Taper` (0
 * for a box), `Shape` (1 for a cube, 0 for what is flat). What the Mesh Quality filter calls so.
 * - their boundary, then the quads between regions (vtkPolyData, quads; these face out of the inner
 *   surface), with the cell arrays `Patch` (int: quads of one number lie between creases),
 *   `Interface` (int: 0 on the boundary, i + 1 on inner surface i) and `Distance` (double: of the
 *   quad's middle to its surface); over the points of the hexahedra that they use, whose numbers
 * are `OriginalPointId`. In parallel the first process has all of both.
 *
 * Field data of both: HexRemesh.Method ("Polycube" or "Grid"), .Reason (why that one), .Hexahedra,
 * .MinimumScaledJacobian, .MeanScaledJacobian, .ScaledJacobianHistogram (20 numbers of hexahedra:
 * scaled Jacobians in [0, 0.05), [0.05, 0.1), ..., [0.95, 1]), .Distance (the larger one-sided
 * Hausdorff distance between the boundary and the surface), .CellSize, .Patches (of the boundary),
 * .Corners (of the surface), .CreasesKept (1, or 0 where the cells are too coarse for some crease
 * and none is kept), .CornersKept (corners of the surface that are points of the boundary),
 * .CreaseDistance (the larger one-sided Hausdorff distance between creases of the surface and of
 * the boundary; to the boundary where none is kept), .CreaseShare (of the length of all that is as
 * sharp as a crease, that of the creases that were looked for: less than 1 where some end inside a
 * patch, or bound patches smaller than 4 cells; 0 where less than two thirds of it bounds patches
 * of a thousandth of the area, which is noise: of a scan with a real crease, a greater FeatureAngle
 * may find it), .ReleasedPoints (of the boundary, off the surface, where hexahedra on it would be
 * inverted: 0 but in grooves where surfaces touch), .Regions, .InnerDistance (as .Distance, between
 * regions and inner surfaces), .InnerCreasesKept (0 where an inner surface has creases), .Crossings
 * (pairs of the surface's triangles that cross), .EulerNumber and .Components of the boundary; of
 * each of Verdict's further measures its minimum, mean and maximum, as HexRemesh.Volume.
 *
 * The mathematics: shape::RemeshHexahedra.
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
  /// The borders between materials.
  void AddInnerSurfaces(vtkAlgorithmOutput* surface);
  void RemoveAllInnerSurfaces();
  ///@}

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
  /// The size of the hexahedra as how many there are on the longest side of the surface's box;
  /// 0: not used. An error where CellSize is given, too. Default: 0.
  vtkShapeOption(CellsOnLongestSide, int);
  ///@}

  ///@{
  /// The point array of Surface that says how large the hexahedra are to be near each point, in the
  /// surface's units: positive. It needs the cells of a grid. None, or empty: not used; an error
  /// where CellSize or CellsOnLongestSide is given, too. Default: None.
  vtkSetStdStringFromCharMacro(SizeArray);
  vtkGetCharFromStdStringMacro(SizeArray);
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

  shape::HexRemeshGuides ReadGuides();

  shape::HexRemeshOptions Options;
  std::string SizeArray = "None";
};

#endif
