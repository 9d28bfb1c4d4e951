#pragma once

#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/PastedFeature.h"
#include "CutPaste/SoupTarget.h"

#include <Eigen/Core>

namespace shape
{

/// Joins a feature and a soup that was cut along its loop: see FeatureToPaste::PasteOn. feature:
/// its triangles. deformed: its points. Points of the result: those that triangles of the soup use,
/// then the feature's.
PastedFeature JoinFeatureAndSoup(const Eigen::MatrixXi& feature, const FeatureFootprint& base,
  const LoopOnSoup& landing, const Eigen::MatrixXd& deformed);

} // namespace shape
