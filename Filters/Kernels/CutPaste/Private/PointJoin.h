#pragma once

#include "CutPaste/PastedFeature.h"
#include "CutPaste/PointTarget.h"

namespace shape
{

/// Joins a feature to the points of a target that remain. deformed: the feature's deformed points.
PastedFeature JoinFeatureAndPoints(const PointTarget& target, const FeatureFootprint& base,
  const LoopOnPoints& landing, const Eigen::MatrixXd& deformed);

} // namespace shape
