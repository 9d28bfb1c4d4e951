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
 * Builds the footprint of a feature on the surface from which it was cut, after the hole there has
 * been filled.
 *
 * filled: the surface with the fill. seed: the centre of the fill. loop: points of the feature,
 * with the feature to the left. on: for each of these points, the coincident point of `filled`.
 * Throws InvalidInput if the loop and the seed are on different components; Aborted.
 */
FeatureFootprint BuildFootprintOnSurface(const Surface& filled, const Eigen::RowVector3d& seed,
  std::vector<int> loop, const std::vector<int>& on, const Progress& progress = {});

/**
 * Builds the footprint of a feature if the surface from which it was cut is not known. A smooth
 * continuation of the feature's surface fills the loop and replaces that surface. Throws the
 * exceptions of SurfaceFiller.
 */
FeatureFootprint BuildFootprintOnOwnFill(
  const Surface& feature, const std::vector<int>& loop, const Progress& progress = {});

} // namespace shape
