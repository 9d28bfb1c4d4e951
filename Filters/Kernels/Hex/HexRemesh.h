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

/// CellSize: smaller cells are used where the surface asks for them, too; 0: one that gives about
/// 20,000 hexahedra. MaximumHexahedra: with an automatic CellSize.
struct HexRemeshOptions : HexMeshOptions
{
  enum class MethodType
  {
    Automatic = 0, ///< the better one of the two
    Polycube = 1,  ///< the cells of a polycube of the solid: BuildPolycubeHexahedra
    Grid = 2       ///< the cells of a grid in the solid: BuildGridHexahedra
  };
  MethodType Method = MethodType::Automatic;
  /// How many cells there are on the longest side of the surface's box, instead of a CellSize; 0:
  /// not used.
  int CellsOnLongestSide = 0;
};

/// What hexahedra follow besides the surface.
struct HexRemeshGuides
{
  /// The wanted size of hexahedra at each of the surface's points, in its units; empty: none.
  Eigen::VectorXd Sizes;
  /// Closed surfaces inside the solid, also inside one another: borders between its regions.
  std::vector<Surface> InnerSurfaces;
  /// A polycube of the surface, whose cells are taken; without triangles: none.
  GivenPolycube Polycube;
};

struct HexRemeshResult
{
  HexFit Fit;
  SurfaceFeatures Features; ///< the creases that were looked for
  HexRemeshOptions::MethodType Method = HexRemeshOptions::MethodType::Grid; ///< that made it
  std::string Reason;    ///< why this method, and by what the cells were carried
  double CellSize = 0.0; ///< the one that was used
  int Crossings = 0;     ///< pairs of the surface's triangles that cross
  /// Of the boundary's quads: their sizes by those wanted (SizeRatios); empty without Sizes.
  Eigen::VectorXd SizeRatios;
  bool InnerCreasesKept = true; ///< false where inner surfaces have creases
  bool TopologyAgreed = true;   ///< see GridHexesResult
};

/**
 * Hexahedra in the solid inside a closed surface, none inverted, with the surface's topology, its
 * creases and its corners. Automatic takes the hexahedra of a polycube where there are such, their
 * worst scaled Jacobian is at least 0.3 and the surface is not farther from them than 1 % of the
 * diagonal of its box; else the better one of polycube and grid.
 *
 * Sizes make cells of a grid as large along the surface as is wanted there (BuildSizedHexahedra);
 * the options may give no size then. Inner surfaces cut the solid into regions
 * (MultiMaterialVoxels): hexahedra meet on them and share points there. Both need the Grid, which
 * Automatic takes then. The cells of a given polycube are carried by its own map
 * (BuildPolycubeCells).
 *
 * surface: closed, oriented consistently; one that crosses itself bounds what it winds around at
 * least once, and needs the Grid. Throws InvalidInput as RequireClosedSurface, and where an option
 * is out of its range or contradicts the guides; SolveFailure where a method finds no hexahedra, or
 * leaves some inverted; Aborted.
 */
HexRemeshResult RemeshHexahedra(const Surface& surface, const HexRemeshOptions& options = {},
  const Progress& progress = {}, const HexRemeshGuides& guides = {});

} // namespace shape
