#pragma once

#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/PasteTarget.h"
#include "Deform/Deform.h"
#include "Deform/ShapeDeformation.h"
#include "Mesh/EdgeMidpoints.h"
#include "Mesh/Provenance.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

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
  std::vector<LoopOnTarget> Landings; ///< of the joined loops
  /// The handle by which the feature was deformed, at its target: the loops with all rotations of
  /// their frames. Deformer deforms anything else like the feature if it takes LoopHandle here and
  /// the same options, with the placement's Scale as a factor of Scale. SeamNormals acts
  /// afterwards.
  HandleTarget Loop;
  /// The angle between the normals of the feature and the target at each point of the loops (n
  /// values), in degrees about the loop's tangent. It is given before and after the optimisation of
  /// the frames.
  Eigen::VectorXd AnglesBefore, AnglesAfter;
  DeformFacts Facts;
  /// Expected Euler number of Surface, computed from those of the target and the feature. On a
  /// soup, that of Surface.
  int EulerNumber = 0;

  /// Whether target and feature are point clouds: Surface then has no triangles. Its points are
  /// those of the target, AddedPoints on the target's surface at the seam, and those of the
  /// feature.
  bool IsOfPoints = false;
  int AddedPoints = 0;
  /// On a point cloud: unit normals at the points of Surface (n x 3): the target's, interpolated at
  /// added points, and the feature's, carried along with it (MoveNormals).
  Eigen::MatrixXd Normals;
  /// On a point cloud: the mean distance between neighbouring points of the target.
  double Spacing = 0.0;
  bool IsOnSoup = false; ///< whether the target was treated as a soup (SoupTarget)
  /// On a soup: the largest distance of a point of the seam, on the feature, from the target, or of
  /// one on the cut target from the feature's seam. It is the distance across gaps of the target.
  /// On a point cloud: the largest distance of a point of the loop from the nearest point of the
  /// target that remains, or of such a point at the hole from the nearest point of the feature.
  double LargestGap = 0.0;
  /// On a soup: the share of the seam's length where feature and target have common edges, 0 to 1.
  double JoinedShare = 1.0;
};

/// Joins target and feature. feature: its triangles, split at the chords of its loops. landings: of
/// the loops of `bases`, in order. deformed: the deformed points, the midpoints last.
PastedFeature JoinFeatureAndTarget(const Surface& target, const CutTriangles& feature,
  const std::vector<FeatureFootprint>& bases, const std::vector<LoopOnTarget>& landings,
  const Eigen::MatrixXd& deformed);

} // namespace shape
