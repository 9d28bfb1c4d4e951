#pragma once

#include "Base/Progress.h"
#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// A polycube of a surface that is given: as Shape Polycube makes it, or made by hand.
struct GivenPolycube
{
  /// Closed; its faces lie across the axes, at whole multiples of one length along each of them.
  Mesh Surface{};
  Eigen::MatrixXd Sources{}; ///< n x 3: where its points lie on the surface
};

struct GivenPolycubeCells
{
  HexMesh Solid;         ///< near the surface
  double CellSize = 0.0; ///< in the surface's units: of a polycube of the same volume
};

/**
 * The cells of a regular grid in a polycube, carried to the solid inside a surface by the harmonic
 * map of the polycube's boundary map (ComputeHarmonicVolumeMap). The cells are as many to the
 * polycube's unit, the greatest length that all of its faces are at multiples of, as come closest
 * to cellSize.
 *
 * surface: closed. cellSize: in the surface's units; 0: about 12,000 cells, or more where the unit
 * asks for them. Throws InvalidInput where the polycube is not closed, has faces that lie across no
 * axis or at no multiples of one length, overlaps itself, has more cells than `most`, sources that
 * are not finite or far from the surface, or another topology; as ComputeHarmonicVolumeMap throws.
 */
GivenPolycubeCells BuildPolycubeCells(const GivenPolycube& polycube, const Surface& surface,
  double cellSize, int maximum, const Progress& progress = {});

} // namespace shape
