#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Returns the point of the given triangles that is closest to their centroid.
Eigen::RowVector3d FindCenterOfTriangles(const Surface& surface, const std::vector<int>& triangles);

/**
 * Builds the footprint of a feature on the surface from which it was cut, whose hole has been
 * filled.
 *
 * filled: the surface with the fill; seed: the centre of the fill. loop: points of the feature, in
 * the order in which its triangles run; on: the coincident points of `filled`. Throws InvalidInput
 * if the loop and the seed are on different components, Aborted.
 */
FeatureFootprint BuildFootprintOnSurface(const Surface& filled, const Eigen::RowVector3d& seed,
  std::vector<int> loop, const std::vector<int>& on, const Progress& progress = {});

/**
 * Builds the footprint of a feature without the surface from which it was cut: on a smooth
 * continuation of the feature's surface that fills its loop. Throws the exceptions of
 * SurfaceFiller.
 */
FeatureFootprint BuildFootprintOnOwnFill(
  const Surface& feature, const std::vector<int>& loop, const Progress& progress = {});

} // namespace shape
