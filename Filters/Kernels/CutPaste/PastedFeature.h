#pragma once

#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/PasteTarget.h"
#include "Deform/ShapeDeformation.h"
#include "Mesh/EdgeMidpoints.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// A feature pasted on a target.
struct PastedFeature
{
  /// The target without what the feature covers, the band between them, and the feature.
  Mesh Surface;
  /// Of each of the first points: the one of the target. The feature's come next, in order.
  std::vector<int> TargetPoints;
  /// Of each of the points after these: the ends of the edge that it splits, of the feature
  /// (between two points of its loop) or of the band.
  std::vector<std::array<int, 2>> Midpoints;
  std::vector<int> TargetTriangles;  ///< of each of the first triangles: the one of the target
  int BandTriangles = 0;             ///< those after them
  std::vector<int> FeatureTriangles; ///< of each of the rest: the one of the feature
  LoopOnTarget Position;
  /// n: the angles in degrees, about the loop, between the feature's normals at its points and the
  /// target's, before and after the optimisation of the frames.
  Eigen::VectorXd AnglesBefore, AnglesAfter;
  DeformFacts Facts;
  int EulerNumber = 0; ///< of Surface, as it follows from the target's and the feature's
};

/// Joins target and feature, and records the sources of the points and triangles. feature: its
/// triangles, split at the chords of its loop; deformed: its deformed points, the midpoints last.
PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const FeatureFootprint& base, const LoopOnTarget& landing, const Eigen::MatrixXd& deformed);

} // namespace shape
