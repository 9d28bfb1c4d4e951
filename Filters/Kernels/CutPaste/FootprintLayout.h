#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The point of some triangles of a surface that is closest to their centroid.
Eigen::RowVector3d FindCenterOfTriangles(const Surface& surface, const std::vector<int>& triangles);

/**
 * The footprint of a feature that was cut from a surface whose hole was filled.
 *
 * filled: the surface with the fill; seed: the centre of the fill. loop: points of the feature, in
 * the order in which its triangles run; on: the coincident ones of `filled`. Throws InvalidInput if
 * the loop is on another component than the seed, Aborted.
 */
FeatureFootprint BuildFootprintOnSurface(const Surface& filled, const Eigen::RowVector3d& seed,
  std::vector<int> loop, const std::vector<int>& on, const Progress& progress = {});

/**
 * The footprint of a feature of which nothing more is known: on a smooth continuation of its own
 * surface that fills its loop. Throws as SurfaceFiller does.
 */
FeatureFootprint BuildFootprintOnOwnFill(
  const Surface& feature, const std::vector<int>& loop, const Progress& progress = {});

} // namespace shape
