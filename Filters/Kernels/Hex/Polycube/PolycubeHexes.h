#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/Polycube/Polycube.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

namespace shape
{

/// CellSize 0: what gives about 16,000 hexahedra.
struct PolycubeHexesOptions : HexMeshOptions
{
  double Compactness = PolycubeOptions().Compactness;
};

struct PolycubeHexesResult
{
  HexFit Fit;
  SurfaceFeatures Features; ///< creases that were looked for, patches at least 4 cells large
  /// The polycube's surface in cells, its unit squares cut in two, and where its points went: on
  /// the boundary of the hexahedra.
  Mesh Polycube;
  Eigen::MatrixXd Targets;
  enum class MapType
  {
    Harmonic = 0,   ///< the harmonic map of the polycube's boundary map
    Tetrahedra = 1, ///< the inverse of the tetrahedra's deformation
    Voxels = 2      ///< of a grid, see FindVoxelPolycube: better, or no other was found
  };
  MapType Map = MapType::Tetrahedra; ///< what carried the grid
  int Charts = 0;                    ///< flat parts of the polycube
  int Corners = 0;                   ///< points where three or more of them meet
  bool Overlaps = false;             ///< the polycube overlaps itself
  double CellSize = 0.0;             ///< the one that was used
};

/**
 * Hexahedra inside a closed surface: the unit cells of a polycube of the solid (FindPolycubeMap),
 * brought back by the harmonic map of the polycube's boundary onto the surface
 * (ComputeHarmonicVolumeMap) where that inverts no more hexahedra than the inverse of the
 * tetrahedra's own map, which needs no polycube that is free of overlaps; with layers around them
 * whose boundary lies on the surface and has its creases (FitHexahedra).
 *
 * The boundary has the Euler number and the components of the surface. Throws InvalidInput as
 * Tetrahedralize, and where options are out of range; SolveFailure where neither a polycube nor a
 * grid of the surface's topology is found; Aborted.
 */
PolycubeHexesResult BuildPolycubeHexahedra(
  const Surface& surface, const PolycubeHexesOptions& options = {}, const Progress& progress = {});

} // namespace shape
