#pragma once

#include "Base/Progress.h"
#include "Hex/Fit/HexFit.h"
#include "Hex/Voxels/GridDensity.h"
#include "Hex/Voxels/MultiMaterialVoxels.h"
#include "Mesh/Surface.h"
#include "Remesh/SurfaceFeatures.h"

#include <optional>

namespace shape
{

/// Cells and the features that they should follow.
struct GridCells
{
  RegionCells Cells;
  SurfaceFeatures Features;
  double Size = 0.0;
};

/**
 * Returns the cells of a grid of this size, if they have the topology. If they do not have all
 * curves of the features (MatchFeatures), grids are tried whose cells are chosen by their centres
 * or are a little smaller: finding the curves takes a small part of the time of a fit. The first
 * grid that has all is returned, or the first of all.
 *
 * surface: of the solid. minimum: of the size. Throws whatever MultiMaterialVoxels::Fill throws.
 */
std::optional<GridCells> FillWithCurves(MultiMaterialVoxels& regions, const Surface& surface,
  const HexMeshOptions& options, double size, double minimum, const GridDensity& warp,
  const Progress& progress = {});

} // namespace shape
