/**
 * @class   vtkShapeHexRemesh
 * @brief   fill the solid inside a closed surface with hexahedra
 *
 * No hexahedron is inverted. The boundary has the topology of the surface, and its creases and
 * corners if the cells are fine enough.
 *
 * Inputs (polygons are triangulated internally)
 * - Surface: the closed surface of one or several solids, with voids. A self-intersecting surface
 *   bounds the region that it winds around at least once.
 * - Polycube (optional): a surface whose faces are orthogonal to the axes at integer multiples of
 *   one length. Its point array `SourcePosition` (3) gives positions on Surface. The second output
 *   of vtkShapePolycube is such a surface. Its cells become the hexahedra.
 * - InnerSurfaces (optional, repeatable): closed surfaces inside the solid, also nested:
 *   interfaces between materials. Hexahedra of two regions share points on the inner surface,
 *   whose creases are rounded. They need the cells of a grid.
 *
 * Output 0: hexahedra (vtkUnstructuredGrid) with the cell arrays
 * - `ScaledJacobian` (double): Verdict's, 1 for a box.
 * - `RegionId` (int): i + 1 inside inner surface i, counted from 0, otherwise 0. Inside several
 *   surfaces, the innermost one determines it.
 * - `Jacobian`, `Volume`, `EdgeRatio` (longest to shortest edge), `MaxAspectFrobenius` (1 for a
 *   cube).
 * - `EquiangleSkew` (0 for a box, 1 if an angle of a face is 0 or 180 degrees).
 * - `Skew`, `Taper` (0 for a box), `Shape` (1 for a cube, 0 if degenerate).
 * The doubles after `RegionId` are the measures of these names in the Mesh Quality filter.
 *
 * Output 1: the boundary quads, then the quads between regions, which face out of the inner
 * surface (vtkPolyData). The points are those of the hexahedra that they use, numbered by
 * `OriginalPointId`. The cell arrays are
 * - `Patch` (int): number of the patch between creases to which the quad belongs.
 * - `Interface` (int): 0 on the boundary, i + 1 on inner surface i.
 * - `Distance` (double): distance of the centre of the quad from its surface.
 * In parallel the first process has both.
 *
 * Field data of both, with the prefix HexRemesh
 * - .Method ("Polycube" or "Grid"), .Reason (for this choice), .Hexahedra, .CellSize, .Regions.
 * - .MinimumScaledJacobian, .MeanScaledJacobian, .ScaledJacobianHistogram (20 counts of hexahedra,
 *   for [0, 0.05), ..., [0.95, 1]).
 * - .Distance: the larger one-sided Hausdorff distance between the boundary and the surface.
 *   .InnerDistance: the same between regions and inner surfaces.
 * - .Patches (of the boundary), .Corners (of the surface), .CornersKept (corners that are points
 *   of the boundary).
 * - .CreasesKept: 1, or 0 if the cells are too coarse for a crease and none is kept.
 *   .InnerCreasesKept: 0 if an inner surface has creases.
 * - .CreaseDistance: the larger one-sided Hausdorff distance between the creases of the surface
 *   and those of the boundary, or to the boundary if none is kept.
 * - .CreaseShare: length of the creases that the method tries to keep, as a share of that of all
 *   edges as sharp as a crease. It is less than 1 if some end inside a patch, or bound patches
 *   smaller than 4 cells. It is 0 if less than two thirds of the length bounds patches larger than
 *   a thousandth of the area: the rest is noise. A greater FeatureAngle may find a real crease of
 *   a scan.
 * - .ReleasedPoints: boundary points that were moved off the surface because hexahedra would
 *   otherwise be inverted or of bad quality.
 * - .Crossings: pairs of triangles of the surface that intersect.
 * - .EulerNumber, .Components: of the boundary.
 * - Minimum, mean and maximum of each further measure, such as .Volume.
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
  /// The interfaces between materials.
  void AddInnerSurfaces(vtkAlgorithmOutput* surface);
  void RemoveAllInnerSurfaces();
  ///@}

  ///@{
  /// The properties. Effects and ranges: vtkShapeHexRemesh.xml. Enumerations and defaults:
  /// shape::HexRemeshOptions.
  vtkShapeEnumOption(Method, shape::HexRemeshOptions::MethodType,
    shape::HexRemeshOptions::MethodType::Automatic, shape::HexRemeshOptions::MethodType::Grid);
  vtkShapeOption(CellSize, double);
  vtkShapeOption(CellsOnLongestSide, int);
  vtkSetStdStringFromCharMacro(SizeArray);
  vtkGetCharFromStdStringMacro(SizeArray);
  vtkShapeOption(PaddingLayers, int);
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
