#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The middle of a part of a surface: the place of its triangles closest to its centroid.
Eigen::RowVector3d FindCenterOfTriangles(const Surface& surface, const std::vector<int>& triangles);

/**
 * The base of a feature that was cut from a surface whose hole was filled.
 *
 * filled: the surface with the fill; seed: a place on the fill, its middle. loop: points of the
 * feature as its triangles run through them; on: those of `filled` at the same places. Throws
 * InvalidInput where the loop is on another component than the seed, Aborted.
 */
FeatureFootprint BuildFootprintOnSurface(const Surface& filled, const Eigen::RowVector3d& seed,
  std::vector<int> loop, const std::vector<int>& on, const Progress& progress = {});

/**
 * The base of a feature of which nothing more is known: a surface that goes on from its own at the
 * loop fills the hole there, and it stands on that. Throws as SurfaceFiller.
 */
FeatureFootprint BuildFootprintOnOwnFill(
  const Surface& feature, const std::vector<int>& loop, const Progress& progress = {});

} // namespace shape
