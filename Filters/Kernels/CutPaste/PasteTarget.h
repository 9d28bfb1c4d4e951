#pragma once

#include "Base/Progress.h"
#include "CutPaste/CoveredRegion.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/Seam.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The position and size at which a feature is to be pasted.
struct PastePlacement
{
  Eigen::RowVector3d Seed =
    Eigen::RowVector3d::Zero(); ///< projected to the closest point of the surface
  double Rotation = 0.0;        ///< degrees, about the outward normal
  double Scale = 1.0;           ///< > 0
};

/// Throws InvalidInput if Scale is not positive, or a value is not finite.
void RequireInRange(const PastePlacement& placement);

/// Returns the loop of a base (n x 2), scaled and rotated in its plane.
Eigen::MatrixXd PoseLoop(const FeatureFootprint& base, const PastePlacement& placement);

/// The map of a target to the plane: its exponential map, or one of the two methods of
/// FlattenPatchConformally.
enum class TargetLayout
{
  ExponentialMap,
  Conformal,
  MinimumDistortion
};

/// A loop of a feature on a target.
struct LoopOnTarget
{
  TargetLayout Layout = TargetLayout::ExponentialMap;
  TangentFrame Seed;         ///< its XAxis: the base's XAxis rotated to the seed, without Rotation
  Eigen::MatrixXd Positions; ///< n x 3: positions of the loop's points on the target
  Eigen::MatrixXd Normals;   ///< n x 3: unit normals of the target at these positions
  CoveredRegion Cover;       ///< the region that the loop covers
  SeamBand Join;             ///< the triangles between the loop and the ring of Cover
};

/**
 * A surface on which features are pasted. It stores what depends on the surface alone. Therefore
 * the time to drag a feature depends only on the covered region. A target must not be used by
 * several threads at once.
 */
class PasteTarget
{
public:
  /// surface: an oriented 2-manifold, open or closed. Throws InvalidInput if it is not; Aborted.
  explicit PasteTarget(const shape::Surface& surface, const ExponentialMapOptions& options = {},
    const Progress& progress = {});

  const shape::Surface& Surface() const { return this->Map.Surface(); }
  ExponentialMap& Layout() { return this->Map; }
  int EulerNumber() const { return this->Surface().Topology().EulerNumber; }

  /**
   * Maps the base's loop to the surface through the exponential maps of both. The base's plane is
   * rotated by the minimum rotation from its normal to the normal at the seed, and then by
   * Rotation. A base that was cut from this surface therefore returns to its position. If the loop
   * meets flipped or overlapping triangles of the target's map, a conformal map is used instead.
   *
   * search: whether to refine a conformal layout and, if the loop does not fit, to search for the
   * largest scale that fits; false is faster. Throws InvalidInput if the loop does not fit; the
   * message gives the reason and the scale that was found. Throws Aborted.
   */
  LoopOnTarget Land(const FeatureFootprint& base, const PastePlacement& placement,
    bool search = true, const Progress& progress = {});

  /// The same for several loops of a feature. The first base is laid at the seed. The rigid motion
  /// and the scale that take its frame there take the other bases to the positions of which the
  /// closest points of the surface are their seeds. The regions must not share a point.
  std::vector<LoopOnTarget> Land(const std::vector<FeatureFootprint>& bases,
    const PastePlacement& placement, bool search = true, const Progress& progress = {});

private:
  struct Trial;
  std::vector<Trial> TryAll(const std::vector<FeatureFootprint>& bases, const ClosestPoint& seed,
    const PastePlacement& placement, bool quick, const Progress& progress);
  Trial Try(const FeatureFootprint& base, const ClosestPoint& seed, const PastePlacement& placement,
    bool quick, const Progress& progress);
  void TryOn(const ExponentialPatch& patch, const Eigen::MatrixXd& loop, Trial& trial);
  Eigen::MatrixXd GetLoopPositions(const CoveredRegion& cover) const;
  CoveredRegionFault TryConformally(const ExponentialPatch& patch, bool refine,
    const Eigen::MatrixXd& loop, Trial& trial, const Progress& progress);

  ExponentialMap Map;
  CoveredRegionFinder Finder;
  double MeanEdge;
  int LastTriangle = -1; ///< the triangle of the previous seed, which is probably near the next one
};

} // namespace shape
