#pragma once

#include "Core/Mesh.h"
#include "Hex/SurfaceFeatures.h"

#include <Eigen/Core>

namespace shape
{

/// Places on a curve of a surface for the points of a chain near it (n x 3): spread along the curve
/// as they are along the chain, in the direction that brings them closer; of a closed one from the
/// curve's point on that is nearest to the first.
Eigen::MatrixXd SpreadAlong(
  const Eigen::MatrixXd& chain, const Mesh& surface, const FeatureCurve& curve);

} // namespace shape
