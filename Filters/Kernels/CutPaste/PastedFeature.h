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
  /// The target without the covered region, then the band between target and feature, and the
  /// feature.
  Mesh Surface;
  /// The original point of the target for each of the first points. The feature's points follow, in
  /// order.
  std::vector<int> TargetPoints;
  /// For each of the points after these, the ends of the edge that it splits. The edge is one of
  /// the feature, between two points of its loop, or one of the band.
  std::vector<std::array<int, 2>> Midpoints;
  /// The original triangle of the target for each of the first triangles.
  std::vector<int> TargetTriangles;
  int BandTriangles = 0; ///< number of triangles of the band, which follow
  /// The original triangle of the feature for each remaining triangle.
  std::vector<int> FeatureTriangles;
  LoopOnTarget Position;
  /// n: angles in degrees about the loop between the feature's normals at its points and the
  /// target's, before and after the optimisation of the frames.
  Eigen::VectorXd AnglesBefore, AnglesAfter;
  DeformFacts Facts;
  /// Expected Euler number of Surface, given those of the target and the feature.
  int EulerNumber = 0;
};

/// Joins target and feature, and records the sources of the points and triangles. feature: its
/// triangles, split at the chords of its loop. deformed: its deformed points, the midpoints last.
PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const FeatureFootprint& base, const LoopOnTarget& landing, const Eigen::MatrixXd& deformed);

} // namespace shape
