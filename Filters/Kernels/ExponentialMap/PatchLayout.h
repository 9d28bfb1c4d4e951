#pragma once

#include "Base/Progress.h"
#include "ExponentialMap/ExponentialFacts.h"
#include "ExponentialMap/ExponentialMap.h"

#include <Eigen/Core>

namespace shape
{

struct PatchLayoutOptions : ExponentialMapOptions
{
  double Radius = 0.0;    ///< >= 0; 0: a tenth of the diagonal of the surface's box
  bool MendFlips = false; ///< whether MendFlips then moves the points around flipped triangles
};

struct PatchLayout
{
  ExponentialPatch Patch;
  ExponentialFacts Facts;
  double Radius = 0.0;
  double SeedDistance = 0.0; ///< of the position that was given from the surface
  int Mended = 0;            ///< triangles that MendFlips has turned back
};

/// The patch around the place closest to `seed`, and how good it is. map: of the options' surface.
/// Throws as ExponentialMap::Around does, and InvalidInput where no point lies within the radius.
PatchLayout FlattenPatch(ExponentialMap& map, const Eigen::RowVector3d& seed,
  const Eigen::RowVector3d& xDirection, const PatchLayoutOptions& options = {},
  const Progress& progress = {});

} // namespace shape
