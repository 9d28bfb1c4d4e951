#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// A polycube given by the user: the second output of Shape Polycube, or one made by hand.
struct GivenPolycube
{
  /// A closed surface whose faces are perpendicular to the axes. Along each axis, the distances
  /// between faces are integer multiples of one length, the same for all axes.
  Mesh Surface{};
  Eigen::MatrixXd Sources{}; ///< n x 3: for each point, the position on the surface it maps to
};

struct GivenPolycubeCells
{
  HexMesh Solid;             ///< the cells, close to the surface
  Eigen::MatrixXd Positions; ///< n x 3: the position of each point in the polycube
  /// The edge length of a cell once the polycube is scaled to the solid's volume, in the surface's
  /// units.
  double CellSize = 0.0;
  double Spacing = 0.0; ///< the edge length of a cell in the polycube
};

/**
 * Maps the cells of a regular grid in a polycube into the solid inside a surface. The map is
 * harmonic and extends the polycube's boundary map (ComputeHarmonicVolumeMap). The polycube's unit
 * is the greatest length such that all distances between parallel faces are integer multiples. The
 * unit is divided into the number of cells that brings the cell size closest to cellSize.
 *
 * surface: closed. cellSize: in the surface's units; 0: a size that gives about 12,000 cells, or
 * more if the unit requires it. maximum: upper bound on the number of cells.
 *
 * Throws InvalidInput if the polycube is not closed, overlaps or touches itself, needs more than
 * `maximum` cells, or has another topology than the surface. Throws it also if the faces are not as
 * described at GivenPolycube, or if a source is not finite or is far from the surface. Throws
 * whatever ComputeHarmonicVolumeMap throws.
 */
GivenPolycubeCells BuildPolycubeCells(const GivenPolycube& polycube, const Surface& surface,
  double cellSize, int maximum, const Progress& progress = {});

} // namespace shape
