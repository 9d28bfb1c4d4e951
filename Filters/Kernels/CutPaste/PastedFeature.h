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

/// A feature set down on a target.
struct PastedFeature
{
  /// The target but for what the feature covers, the band between them, and the feature.
  Mesh Surface;
  /// Of each of the first points: the one of the target. The feature's come next, in order.
  std::vector<int> TargetPoints;
  /// Of each of the points after these: the two that it is between, where an edge of the feature
  /// that joined two points of its loop, or one of the band, is cut.
  std::vector<std::array<int, 2>> Midpoints;
  std::vector<int> TargetTriangles;  ///< of each of the first triangles: the one of the target
  int BandTriangles = 0;             ///< those after them
  std::vector<int> FeatureTriangles; ///< of each of the rest: the one of the feature
  LoopOnTarget Position;
  /// n: degrees, about the loop, between the feature's normals at its points and the target's
  /// there, with the frames as they are and turned.
  Eigen::VectorXd AnglesBefore, AnglesAfter;
  DeformFacts Facts;
  int EulerNumber = 0; ///< of Surface, as follows from the target's and the feature's
};

/// Puts the surface together, and what tells where its parts come from. target: what the feature is
/// set down on. feature: its triangles, cut at the chords of its loop; deformed: its points where
/// they come to lie, the middles last.
PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const FeatureFootprint& base, const LoopOnTarget& landing, const Eigen::MatrixXd& deformed);

} // namespace shape
