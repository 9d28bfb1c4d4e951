#pragma once

#include "Labels/Private/SurfaceNet.h"

#include <Eigen/Core>

#include <map>

namespace shape
{

/// Returns the volume of each region of a net, in voxels, by its label. Label 0 is left out.
std::map<int, double> ComputeRegionVolumes(const SurfaceNet& net);

/// Moves the points of a net, within their cells, such that its regions have these volumes. The
/// motion is the smallest in the sense of least squares over the area: to first order, it is a
/// combination of the gradients of the volumes.
void RestoreVolumes(SurfaceNet& net, const std::map<int, double>& volumes);

} // namespace shape
