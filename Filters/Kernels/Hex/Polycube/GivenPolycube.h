#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// A polycube that the user gives: the output of Shape Polycube, or made by hand.
struct GivenPolycube
{
  /// A closed surface. Its faces are perpendicular to the axes, and their coordinates are integer
  /// multiples of one length along each axis.
  Mesh Surface{};
  Eigen::MatrixXd Sources{}; ///< n x 3: the position on the surface that each point maps to
};

struct GivenPolycubeCells
{
  HexMesh Solid;         ///< the cells, close to the surface
  double CellSize = 0.0; ///< in the surface's units: the cell size of a polycube of equal volume
};

/**
 * Carries the cells of a regular grid in a polycube into the solid inside a surface. They are
 * carried by the harmonic map that extends the polycube's boundary map (ComputeHarmonicVolumeMap).
 * The polycube's unit is the greatest length that the coordinates of all faces are multiples of. It
 * is divided into the number of cells that comes closest to cellSize.
 *
 * surface: closed. cellSize: in the surface's units; 0: about 12,000 cells, or more if the unit
 * requires it. Throws InvalidInput if the polycube is not closed, overlaps itself, needs more than
 * `maximum` cells, or has another topology than the surface. Its faces must be perpendicular to an
 * axis at multiples of one length, and its sources finite and close to the surface. Throws what
 * ComputeHarmonicVolumeMap throws.
 */
GivenPolycubeCells BuildPolycubeCells(const GivenPolycube& polycube, const Surface& surface,
  double cellSize, int maximum, const Progress& progress = {});

} // namespace shape
