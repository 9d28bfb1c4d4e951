/**
 * @class   vtkShapeHexRemesh
 * @brief   fill the solid inside a closed surface with hexahedra
 *
 * No hexahedron is inverted. The boundary has the same topology as the surface. If the cells are
 * small enough, it also has the creases and corners of the surface.
 *
 * Inputs (polygons are triangulated internally)
 * - Surface: the closed surface that bounds one or several solids, which may have voids. A
 *   self-intersecting surface bounds the region with a winding number of at least 1. A cell array
 *   (PatchArray; whole numbers from 0), such as `Patch` of vtkShapeCADReader, divides it into
 *   patches, whose boundaries are the creases. With the cell
 *   array `Regions` (int, 2), its triangles are the interfaces between regions that touch, as
 *   vtkShapeLabelSurfaces makes them. `Regions` has the labels on both sides of each triangle: 0 is
 *   the outside, and the normal leaves the first. All cells are then triangles.
 * - Polycube (optional): a surface whose faces are orthogonal to the axes and lie at integer
 *   multiples of one length, such as the second output of vtkShapePolycube. A solid stands for its
 *   boundary. Its point array `SourcePosition` (double, 3) gives the corresponding positions on
 *   Surface. If it has none, `TargetPosition` does, as vtkShapeCorrespondence writes it for a
 *   polycube as SurfaceA. The cells of this polycube become the hexahedra.
 * - InnerSurfaces (optional, repeatable): closed surfaces inside the solid that are interfaces
 *   between materials. They may be nested. Hexahedra on both sides of an inner surface share points
 *   on it, and its creases are rounded. Inner surfaces need the Grid method.
 * - Labels (optional, instead of Surface): an image with integers, whose regions touch (see
 *   vtkShapeLabelSurfaces). It may be composite or distributed.
 *
 * Output 0: hexahedra (vtkUnstructuredGrid) with the cell arrays
 * - `ScaledJacobian` (double): Verdict's scaled Jacobian, 1 for a box.
 * - `RegionId` (int): i + 1 if inner surface i (counted from 0) is the innermost surface around the
 *   cell; 0 outside all inner surfaces. If regions touch, it is the label of the region.
 * - `Jacobian`, `Volume`, `EdgeRatio` (longest to shortest edge), `MaxAspectFrobenius` (1 for a
 *   cube).
 * - `EquiangleSkew` (0 for a box, 1 if an angle of a face is 0 or 180 degrees).
 * - `Skew`, `Taper` (0 for a box), `Shape` (1 for a cube, 0 if degenerate).
 * - `FacePatch` (int, 6): patch of each face in VTK's order; -1 for faces inside the solid.
 * The arrays after `RegionId` are of type double, except `FacePatch`. The Mesh Quality filter
 * defines measures with the same names. The point array `SourcePosition` (double, 3) is the
 * position of each point in output 2. Points of layers that were added lie between its points.
 *
 * Output 1 (vtkPolyData): the quads of the boundary, then the quads between regions, which face out
 * of the inner surface. `OriginalPointId` of a point is its index in output 0. The cell arrays are
 * - `Patch` (int): index of the patch to which the quad belongs. Creases separate patches. With a
 *   PatchArray, it is the value of the patch in that array or, if creases are not kept, of the
 *   nearest cell of Surface. Quads between regions have the next numbers.
 * - `Interface` (int): 0 on the boundary, i + 1 on inner surface i. If regions touch, i + 1 on the
 *   interface between the i-th pair of regions.
 * - `Regions` (int, 2), only if regions touch: the labels on both sides of the quad, of which 0 is
 *   the outside. The normal leaves the first.
 * - `Distance` (double): distance of the centre of the quad from Surface or, between regions, from
 *   the inner surface.
 *
 * Output 2: the regular grid whose cells became the hexahedra (vtkUnstructuredGrid), at their
 * positions in the polycube or grid. Its cells are cubes; those of a given Polycube are in it,
 * others have the edge length CellSize. The point array `TargetPosition` (double, 3) is the map
 * onto the solid: the position of point `OriginalPointId` of output 0. The cell array `Block` (int)
 * numbers structured blocks, and `BlockIndex` (int, 3) gives i, j, k of a cell in its block, from
 * 0. Each side of a block is a side of one other block or lies on the boundary.
 *
 * In parallel, the first process has all outputs.
 *
 * Facts, with the prefix HexRemesh
 * - .Method ("Polycube" or "Grid"), .Reason (for this choice), .Hexahedra, .CellSize, .Regions,
 *   .Blocks.
 * - .MinimumScaledJacobian, .MeanScaledJacobian, .ScaledJacobianHistogram (20 counts of hexahedra,
 *   for [0, 0.05), ..., [0.95, 1]).
 * - .Distance: the larger one-sided Hausdorff distance between the boundary and the surface.
 *   .InnerDistance: the same distance between the inner surfaces and the quads between regions.
 * - .Patches: number of patches of the boundary. .PatchesLost, only with a PatchArray: number of
 *   values of the PatchArray that no quad has, because these patches are too small. .Corners:
 * number of corners of the surface. .CornersKept: number of these corners that are points of the
 * boundary.
 * - .CreasesKept: 1 if the boundary has all creases of the surface, otherwise 0. The cells are then
 *   too large for some creases, and it has the others; or it has none, because hexahedra would be
 *   too bad. .InnerCreasesKept: 0 if an inner surface has creases, otherwise 1.
 * - .LostCreases: number of creases of the surface, from corner to corner, that the boundary does
 *   not have, also of patches smaller than 4 cells; 0 if regions touch. If there are any:
 *   .LostCreasePositions, x, y and z of the midpoint of each, the longest first, and
 *   .LostCreaseLengths.
 * - .CreaseDistance: the larger one-sided Hausdorff distance between the creases of the surface and
 *   the creases of the boundary, also of creases that are lost. If no crease is kept, it is the
 * distance of the creases of the surface from the boundary.
 * - .CreaseShare: length of the creases that the method tries to keep, divided by the length of all
 *   edges that are as sharp as a crease. The share is less than 1 if some of these edges end inside
 *   a patch or bound patches smaller than 4 cells. The share is 0 if less than two thirds of the
 *   length of these edges bounds patches larger than a thousandth of the area. The sharp edges are
 *   then treated as noise. With a larger FeatureAngle, real creases of a noisy scan may be found.
 * - If regions touch: .RegionLabels, .RegionHexahedra, .RegionVolumes, .RegionEulerNumbers and
 *   .RegionComponents, one value for each region. .Curves: number of curves where three or more
 *   regions meet, of which the outside is one; .CurvesKept: number of these curves that are chains
 *   of edges. .CurveDistance: the larger one-sided Hausdorff distance between these chains and
 *   curves, each compared with those of the same regions. .Junctions: number of points where these
 *   curves meet; .JunctionsKept: number of these points that are points of the hexahedra. A curve
 *   shorter than a cell between two points of the same regions is not counted, and its ends count
 *   as one. .Distance is that of all quads, .InnerDistance that of quads between regions. Patches
 *   are numbered by their pairs of regions.
 * - .ReleasedPoints: number of boundary points that left the surface because hexahedra would
 *   otherwise be inverted or have low quality.
 * - .Crossings: number of pairs of triangles of the surface that intersect.
 * - .EulerNumber, .Components: Euler number and number of components of the boundary.
 * - Minimum, mean and maximum of each further measure, such as .Volume.
 *
 * The mathematics: shape::RemeshHexahedra, shape::RemeshRegions.
 */
#ifndef vtkShapeHexRemesh_h
#define vtkShapeHexRemesh_h

#include "vtkShapeAlgorithm.h"

#include "Hex/HexRemesh.h" // for the options

#include <string> // for names
#include <vector> // for points

namespace shape
{
struct LabelledSurfaces;
}

class VTKSHAPEFILTERS_EXPORT vtkShapeHexRemesh : public vtkShapeAlgorithm
{
public:
  static vtkShapeHexRemesh* New();
  vtkTypeMacro(vtkShapeHexRemesh, vtkShapeAlgorithm);

  ///@{
  /// The connections of the input InnerSurfaces.
  void AddInnerSurfaces(vtkAlgorithmOutput* surface);
  void RemoveAllInnerSurfaces();
  ///@}

  /// Returns the volume, the area and the longest edge of the bounding box of what is connected to
  /// Surface now, without updating it. All are 0 if there is no single surface. The panel estimates
  /// the number of hexahedra from them.
  double* GetSurfaceSize() VTK_SIZEHINT(3);

  ///@{
  /// The properties. Effects and ranges: vtkShapeHexRemesh.xml. Enumerations and defaults:
  /// shape::HexRemeshOptions.
  vtkShapeEnumOption(Method, shape::HexRemeshOptions::MethodType,
    shape::HexRemeshOptions::MethodType::Automatic, shape::HexRemeshOptions::MethodType::Grid);
  vtkShapeOption(CellSize, double);
  vtkShapeOption(CellsOnLongestSide, int);
  vtkSetStdStringFromCharMacro(SizeArray);
  vtkGetCharFromStdStringMacro(SizeArray);
  vtkSetStdStringFromCharMacro(PatchArray);
  vtkGetCharFromStdStringMacro(PatchArray);
  vtkShapeOption(PaddingLayers, int);
  vtkSetStdStringFromCharMacro(LabelArray);
  vtkGetCharFromStdStringMacro(LabelArray);
  vtkShapeOption(FeatureAngle, double);
  vtkShapeOption(Draft, bool);
  ///@}

protected:
  vtkShapeHexRemesh();
  ~vtkShapeHexRemesh() override = default;
  void Execute(const shape::Progress& progress) override;

private:
  vtkShapeHexRemesh(const vtkShapeHexRemesh&) = delete;
  void operator=(const vtkShapeHexRemesh&) = delete;

  shape::HexRemeshGuides ReadGuides(const std::vector<int>& used);
  Eigen::VectorXi ReadPatches(vtkPolyData* surface, const std::vector<int>& cellOf) const;
  void RequireRegionsAlone(const std::string& regions);
  void CheckCellSize(vtkPolyData* surface);
  void FillLabels(const shape::Progress& progress);
  void FillRegions(
    const shape::LabelledSurfaces& regions, vtkDataObject* input, const shape::Progress& progress);
  void WriteResult(const shape::HexRemeshResult& result, const shape::Surface& surface,
    const std::vector<shape::Surface>& innerSurfaces, vtkDataObject* input);

  shape::HexRemeshOptions Options;
  std::string SizeArray = "None";
  std::string PatchArray = "None";
  std::string LabelArray;
  double SurfaceSize[3] = { 0.0, 0.0, 0.0 };
};

#endif
