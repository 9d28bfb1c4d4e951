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
  /// The target without what the feature covers, the band between them, and the feature. Points:
  /// the target's, the feature's, then midpoints of edges of the feature (between two points of its
  /// loop) and of the band. Triangles: the target's, the band's, the feature's.
  Mesh Surface;
  Provenance Target;     ///< from the target; the band's triangles take their data from it
  Provenance Feature;    ///< from the feature
  int BandTriangles = 0; ///< the number of triangles in the band
  LoopOnTarget Position;
  /// n: the angles in degrees, about the loop, between the feature's normals at its points and the
  /// target's, before and after the optimisation of the frames.
  Eigen::VectorXd AnglesBefore, AnglesAfter;
  DeformFacts Facts;
  int EulerNumber = 0; ///< of Surface, as it follows from the target's and the feature's
};

/// Joins target and feature. feature: its triangles, split at the chords of its loop; deformed: its
/// deformed points, the midpoints last.
PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const FeatureFootprint& base, const LoopOnTarget& landing, const Eigen::MatrixXd& deformed);

} // namespace shape
