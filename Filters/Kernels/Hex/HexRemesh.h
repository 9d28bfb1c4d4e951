#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/Polycube/GivenPolycube.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// CellSize: cells become smaller where the surface needs it; 0: a size that gives about 20,000
/// hexahedra. MaximumHexahedra: applies only to an automatic CellSize.
struct HexRemeshOptions : HexMeshOptions
{
  enum class MethodType
  {
    Automatic = 0, ///< the better of the two
    Polycube = 1,  ///< the cells of a polycube of the solid (BuildPolycubeHexahedra)
    Grid = 2       ///< the cells of a grid in the solid (BuildGridHexahedra)
  };
  MethodType Method = MethodType::Automatic;
  /// The number of cells along the longest edge of the surface's bounding box, which replaces
  /// CellSize; 0: not used.
  int CellsOnLongestSide = 0;
};

/// Optional inputs that the hexahedra follow in addition to the surface.
struct HexRemeshGuides
{
  /// The wanted size of the hexahedra at each point of the surface, in its units; may be empty.
  Eigen::VectorXd Sizes;
  /// Closed surfaces inside the solid that separate its regions; they may be nested.
  std::vector<Surface> InnerSurfaces;
  /// A polycube of the surface whose cells become the hexahedra; without triangles: none is given.
  GivenPolycube Polycube;
};

struct HexRemeshResult
{
  HexFit Fit;
  SurfaceFeatures Features; ///< the creases that the hexahedra were asked to follow
  HexRemeshOptions::MethodType Method = HexRemeshOptions::MethodType::Grid; ///< the method used
  std::string Reason;    ///< why this method was chosen, and which map carried the cells
  double CellSize = 0.0; ///< the size that was used, in the surface's units
  int Crossings = 0;     ///< the number of pairs of the surface's triangles that cross
  /// The size ratio of each boundary quad (ComputeSizeRatios); empty without Sizes.
  Eigen::VectorXd SizeRatios;
  bool InnerCreasesKept = true; ///< false if an inner surface has creases, which are rounded
  bool TopologyAgreed = true;   ///< see GridHexesResult
};

/**
 * Fills a closed surface with hexahedra. None is inverted, and the mesh has the surface's topology,
 * creases and corners.
 *
 * Automatic first tries a polycube. It takes the result if the worst scaled Jacobian is at least
 * 0.3 and the distance to the surface is at most 1 % of the box diagonal. Otherwise it takes the
 * better of polycube and grid.
 *
 * Sizes prescribe the size of the grid's cells along the surface (BuildSizedHexahedra); the options
 * must not give a size then. Inner surfaces divide the solid into regions (MultiMaterialVoxels),
 * and the hexahedra on both sides of an inner surface share its points. Both need the Grid, and
 * Automatic then selects it. The cells of a given polycube are carried to the solid by the
 * polycube's own map (BuildPolycubeCells).
 *
 * surface: closed and consistently oriented. A surface that crosses itself bounds the region with a
 * winding number of at least 1, and needs the Grid.
 *
 * Throws InvalidInput under the conditions of RequireClosedSurface, or if an option is out of range
 * or contradicts the guides. Throws SolveFailure if a method finds no hexahedra or leaves some
 * inverted; Aborted.
 */
HexRemeshResult RemeshHexahedra(const Surface& surface, const HexRemeshOptions& options = {},
  const Progress& progress = {}, const HexRemeshGuides& guides = {});

} // namespace shape
