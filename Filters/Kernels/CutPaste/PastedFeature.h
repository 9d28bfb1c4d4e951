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
  /// The target without the covered region, then the band between target and feature, then the
  /// feature.
  Mesh Surface;
  /// For each of the first points, the original point of the target. The feature's points follow in
  /// their order.
  std::vector<int> TargetPoints;
  /// For each of the last points, the ends of the edge that it splits. This is an edge of the
  /// feature between two points of its loop, or an edge of the band.
  std::vector<std::array<int, 2>> Midpoints;
  /// For each of the first triangles, the original triangle of the target.
  std::vector<int> TargetTriangles;
  int BandTriangles = 0; ///< number of triangles of the band, which come next
  /// For each of the remaining triangles, the original triangle of the feature.
  std::vector<int> FeatureTriangles;
  LoopOnTarget Position;
  /// n values each, before and after the optimisation of the frames. At each point of the loop,
  /// this is the angle between the normals of the feature and the target, in degrees about the
  /// loop's tangent.
  Eigen::VectorXd AnglesBefore, AnglesAfter;
  DeformFacts Facts;
  /// Expected Euler number of Surface, computed from those of the target and the feature.
  int EulerNumber = 0;
};

/// Joins target and feature, and records the sources of the points and triangles. feature: the
/// feature's triangles, split at the chords of its loop. deformed: its deformed points, followed by
/// the midpoints.
PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const FeatureFootprint& base, const LoopOnTarget& landing, const Eigen::MatrixXd& deformed);

} // namespace shape
