#pragma once

#include "Base/Progress.h"
#include "CutPaste/FeatureFootprint.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

class PointTarget;

/// Returns the point of the given triangles that is closest to their centroid.
Eigen::RowVector3d FindCenterOfTriangles(const Surface& surface, const std::vector<int>& triangles);

/// A loop of a feature on the surface from which it was cut, after its hole there has been filled.
struct FilledLoop
{
  Eigen::RowVector3d Seed; ///< the centre of the fill
  std::vector<int> Loop;   ///< points of the feature, with the feature to the left
  std::vector<int> On;     ///< for each of these points, the coincident point of the surface
};

/// Builds the footprint of a feature at its loop on a point cloud. home: the rest with the points
/// of its fill. Throws InvalidInput if the loop and its seed are on parts that no local triangle
/// connects; Aborted.
FeatureFootprint BuildFootprintOnPoints(
  PointTarget& home, const FilledLoop& loop, const Progress& progress = {});

/// Builds the footprint of a feature at each of its loops. filled: the surface with the fills.
/// Throws InvalidInput if a loop and its seed are on different components; Aborted.
std::vector<FeatureFootprint> BuildFootprintsOnSurface(
  const Surface& filled, const std::vector<FilledLoop>& loops, const Progress& progress = {});

/**
 * Builds the footprint of a feature if the surface from which it was cut is not known. A smooth
 * continuation of the feature's surface fills the loop and replaces that surface. Throws the
 * exceptions of SurfaceFiller.
 */
FeatureFootprint BuildFootprintOnOwnFill(
  const Surface& feature, const std::vector<int>& loop, const Progress& progress = {});

} // namespace shape
