#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/HexGrid.h"
#include "Hex/Polycube/GivenPolycube.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <limits>
#include <string>
#include <vector>

namespace shape
{

/// Cells become smaller than CellSize where the surface needs it. If no size is given, cells are
/// sized to give about 20,000 hexahedra. MaximumHexahedra applies only in this case.
struct HexRemeshOptions : HexMeshOptions
{
  enum class MethodType
  {
    Automatic = 0, ///< the better of the two methods below
    Polycube = 1,  ///< the cells of a polycube of the solid (BuildPolycubeHexahedra)
    Grid = 2       ///< the cells of a grid in the solid (BuildGridHexahedra)
  };
  MethodType Method = MethodType::Automatic;
  /// If not 0, CellSize is the longest edge of the surface's bounding box divided by this number;
  /// >= 0.
  int CellsOnLongestSide = 0;
};

/// Optional inputs that the hexahedra follow in addition to the surface.
struct HexRemeshGuides
{
  /// The wanted size of the hexahedra at each point of the surface, in the surface's units; may be
  /// empty.
  Eigen::VectorXd Sizes;
  /// Closed surfaces inside the solid that separate its regions; they may be nested.
  std::vector<Surface> InnerSurfaces;
  /// A polycube of the surface, whose cells become the hexahedra. Without triangles, it is ignored.
  GivenPolycube Polycube;
};

/// With a given size the number of hexahedra is limited only by the range of corner indices.
inline constexpr int MaximumOfGivenSize = std::numeric_limits<int>::max() / 64;

/// The hexahedra of a region that touches others.
struct HexRegion
{
  int Label = 0;
  int Hexahedra = 0;
  double Volume = 0.0; ///< in the surfaces' units cubed
  int EulerNumber = 0; ///< of the boundary of its hexahedra
  int Components = 0;  ///< of the boundary of its hexahedra
};

struct HexRemeshResult
{
  HexFit Fit;
  HexGrid Grid;             ///< whose cells became the hexahedra
  SurfaceFeatures Features; ///< the creases that the hexahedra were asked to follow
  HexRemeshOptions::MethodType Method = HexRemeshOptions::MethodType::Grid; ///< the method used
  /// All creases of the surface that the hexahedra do not follow, the longest first: the cells are
  /// too coarse for them or for a patch beside them, or hexahedra would be too bad. Empty if
  /// regions touch.
  std::vector<CreaseLine> LostCreases;
  std::string Reason;    ///< why this method was chosen, and which map carried the cells
  double CellSize = 0.0; ///< the size that was used, in the surface's units
  int Crossings = 0;     ///< number of pairs of triangles of the surface that cross
  /// The size ratio of each boundary quad (ComputeSizeRatios); empty without Sizes.
  Eigen::VectorXd SizeRatios;
  bool InnerCreasesKept = true; ///< false if an inner surface has creases; they are rounded off
  bool TopologyAgreed = true;   ///< see GridHexesResult
  /// If regions touch (RemeshRegions): the regions by ascending label; the numbers of curves where
  /// three or more regions meet, the outside included, and of points where these curves meet; and
  /// how many of them the hexahedra have.
  std::vector<HexRegion> Regions = {};
  int Curves = 0, CurvesKept = 0, Junctions = 0, JunctionsKept = 0;
  double CurveDistance = 0.0; ///< see ComputeCurveDistance
};

/// Throws InvalidInput if CellsOnLongestSide is out of range, or given together with CellSize.
void RequireOneSize(const HexRemeshOptions& options);

/**
 * Fills a closed surface with hexahedra. No hexahedron is inverted, and the mesh has the surface's
 * topology. The mesh follows the surface's creases and corners, except those that its cells are too
 * coarse for or at which hexahedra would become too bad; if others stay too bad, it follows none
 * (FitHexahedra). Lost creases are returned, and Reason names the longest.
 *
 * Automatic first tries a polycube. The result is accepted if it keeps the creases and its minimum
 * scaled Jacobian is at least 0.3. Its distance to the surface must also be at most 1 % of the
 * bounding box's diagonal, and that to the creases 0.1 %, unless a cell size is given.
 * Otherwise the better of polycube and grid is taken. If the surface has no creases, and less than
 * a quarter of its area faces in at most six directions, a polycube has nothing to follow. A grid
 * is then tried first, and accepted if its minimum scaled Jacobian is at least 0.55, at the same
 * distance. With Draft, a grid is taken (HexMeshOptions).
 *
 * `Sizes` prescribes the size of the grid's cells along the surface (BuildSizedHexahedra). If
 * `Sizes` is given, the options must not give a size. Inner surfaces divide the solid into regions
 * (MultiMaterialVoxels), and the hexahedra on both sides of an inner surface share its points.
 * `Sizes` and inner surfaces require a grid, so Automatic then selects Grid. If a polycube is
 * given, its own map carries its cells into the solid (BuildPolycubeCells).
 *
 * If the options give Patches, the patches of the boundary have their numbers. Where creases are
 * not kept, each quad has the number of the nearest triangle.
 *
 * surface: closed and consistently oriented. If the surface crosses itself, the solid is the region
 * with a winding number of at least 1, and Automatic selects Grid.
 *
 * Throws InvalidInput under the conditions of RequireClosedSurface, or if an option is out of range
 * or contradicts the guides, or if Patches are negative or given for a surface that crosses itself.
 * Throws SolveFailure if a method finds no hexahedra or leaves some inverted; Aborted.
 */
HexRemeshResult RemeshHexahedra(const Surface& surface, const HexRemeshOptions& options = {},
  const Progress& progress = {}, const HexRemeshGuides& guides = {});

} // namespace shape
