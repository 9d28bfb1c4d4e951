#pragma once

#include "Deform/BoundaryHandle.h"
#include "Deform/Private/HandleSources.h"
#include "Deform/Private/NodeDeformation.h"

#include <Eigen/Core>

namespace shape
{

/// The motions of the sources of a posed handle, in their order. scales: of offsets from the
/// handle, for nodes that are only almost on it; one for each node.
NodeTransforms MoveSources(const HandleSources& sources, const BoundaryHandle& handle,
  const HandlePose& pose, const Eigen::VectorXd& scales);

} // namespace shape
