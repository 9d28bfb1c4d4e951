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

/// If CellSize is 0, cells are sized to give about 16,000 hexahedra.
struct PolycubeHexesOptions : HexMeshOptions
{
  double Compactness = PolycubeOptions().Compactness;
  bool NeedsCreases = false; ///< see HexFitOptions
};

struct PolycubeHexesResult
{
  HexFit Fit;
  SurfaceFeatures Features; ///< creases around patches at least as large as 4 cell faces
  /// The polycube's surface, in units of cells, with each unit square split into two triangles.
  /// Targets (n x 3): for each point of this surface, the position of the same point on the
  /// boundary of the hexahedra.
  Mesh Polycube;
  Eigen::MatrixXd Targets;
  /// For each point of Fit.Core, its position in the polycube, in units of cells.
  Eigen::MatrixXd Positions;
  enum class MapType
  {
    Harmonic = 0,   ///< the harmonic map that extends the polycube's boundary map
    Tetrahedra = 1, ///< the inverse of the deformation of the tetrahedra
    Voxels = 2      ///< the map of FindVoxelPolycube: better, or the only one found
  };
  MapType Map = MapType::Tetrahedra; ///< the map that carried the cells
  int Charts = 0;                    ///< number of charts: flat parts of the polycube
  int Corners = 0;                   ///< number of points where three or more charts meet
  bool Overlaps = false;             ///< whether the polycube overlaps itself
  double CellSize = 0.0;             ///< the size that was used, in the surface's units
};

/**
 * Fills a closed surface with hexahedra. The core consists of the unit cells of a polycube of the
 * solid (FindPolycubeMap). Layers of hexahedra around the core connect it to the surface and follow
 * the creases (FitHexahedra).
 *
 * One of two maps carries the cells into the solid. The first is the harmonic map that extends the
 * map of the polycube's boundary onto the surface (ComputeHarmonicVolumeMap). The second is the
 * inverse of the deformation of the tetrahedra, which also works if the polycube overlaps itself.
 * The second map is used if the first inverts more hexahedra. If no polycube is found, or the
 * hexahedra are bad, the cells of a grid in the deformed solid are tried (FindVoxelPolycube).
 *
 * The boundary has the Euler number and the number of components of the surface. Throws
 * InvalidInput under the conditions of Tetrahedralize, or if an option is out of range. Throws
 * SolveFailure if neither a polycube nor a grid with the surface's topology is found; Aborted.
 */
PolycubeHexesResult BuildPolycubeHexahedra(
  const Surface& surface, const PolycubeHexesOptions& options = {}, const Progress& progress = {});

} // namespace shape
