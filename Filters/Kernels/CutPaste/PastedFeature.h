#pragma once

#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/PasteTarget.h"
#include "Deform/ShapeDeformation.h"
#include "Mesh/EdgeMidpoints.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// A feature pasted on a target.
struct PastedFeature
{
  /// The target without the covered region, then the band between target and feature, and the
  /// feature. Points: first the target's, then the feature's, then midpoints of edges of the
  /// feature (between two points of its loop), then midpoints of edges of the band. Triangles:
  /// first the target's, then the band's, then the feature's.
  Mesh Surface;
  Provenance Target;     ///< from the target, which also gives the triangles of the band their data
  Provenance Feature;    ///< from the feature
  int BandTriangles = 0; ///< number of triangles of the band
  LoopOnTarget Position;
  /// The angle between the normals of the feature and the target at each point of the loop (n
  /// values), in degrees about the loop's tangent. It is given before and after the optimisation of
  /// the frames.
  Eigen::VectorXd AnglesBefore, AnglesAfter;
  DeformFacts Facts;
  /// Expected Euler number of Surface, computed from those of the target and the feature.
  int EulerNumber = 0;
};

/// Joins target and feature. feature: its triangles, split at the chords of its loop. deformed: its
/// deformed points, the midpoints last.
PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const FeatureFootprint& base, const LoopOnTarget& landing, const Eigen::MatrixXd& deformed);

} // namespace shape
