#pragma once

#include "CutPaste/PastedFeature.h"
#include "CutPaste/PointTarget.h"

namespace shape
{

/// Joins a feature to the points of a target that remain. deformed, normals: the feature's deformed
/// points, and the unit normals there.
PastedFeature JoinFeatureAndPoints(const PointTarget& target, const FeatureFootprint& base,
  const LoopOnPoints& landing, const Eigen::MatrixXd& deformed, const Eigen::MatrixXd& normals);

} // namespace shape
