#pragma once

#include "Base/Progress.h"
#include "CutPaste/CoveredRegion.h"
#include "CutPaste/FeatureFootprint.h"
#include "CutPaste/Seam.h"
#include "ExponentialMap/ExponentialMap.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Where a feature is to be pasted.
struct PastePlacement
{
  Eigen::RowVector3d Seed = Eigen::RowVector3d::Zero(); ///< the closest point of the surface counts
  double Rotation = 0.0;                                ///< degrees, about the outward normal
  double Scale = 1.0;                                   ///< > 0
};

/// How a target is mapped to the plane: by its exponential map, or by one of the two methods of
/// FlattenPatchConformally.
enum class TargetLayout
{
  ExponentialMap,
  Conformal,
  MinimumDistortion
};

/// A feature's loop on a target.
struct LoopOnTarget
{
  TargetLayout Layout = TargetLayout::ExponentialMap;
  TangentFrame Seed;         ///< XAxis: the rotated one of the base, before Rotation
  Eigen::MatrixXd Positions; ///< n x 3: of the loop's points, on the target
  Eigen::MatrixXd Normals;   ///< n x 3: unit normals of the target there
  CoveredRegion Cover;       ///< what the loop covers
  SeamBand Join;             ///< the triangles between the loop and the ring of Cover
};

/**
 * A surface that features are pasted on: owns what depends on it alone, so that dragging a feature
 * across it takes time proportional to what it covers. Not for several threads at once.
 */
class PasteTarget
{
public:
  /// surface: an oriented 2-manifold, open or closed. Throws InvalidInput if it is not, Aborted.
  explicit PasteTarget(const shape::Surface& surface, const ExponentialMapOptions& options = {},
    const Progress& progress = {});

  const shape::Surface& Surface() const { return this->Map.Surface(); }
  ExponentialMap& Layout() { return this->Map; }
  int EulerNumber() const { return this->Surface().Topology().EulerNumber; }

  /**
   * Maps the base's loop to the surface through the exponential maps of both: the base's plane is
   * rotated by the least rotation from its normal to the one at the seed, then by Rotation. So a
   * base from this very surface returns to its position. If the loop meets flipped or overlapping
   * triangles of the target's map, a conformal map replaces it.
   *
   * Throws InvalidInput if the loop does not fit there, with the reason and the largest scale that
   * does. search: whether to find that scale, and to refine a conformal layout; else it is quick.
   * Aborted.
   */
  LoopOnTarget Land(const FeatureFootprint& base, const PastePlacement& placement,
    bool search = true, const Progress& progress = {});

private:
  struct Trial;
  Trial Try(const FeatureFootprint& base, const ClosestPoint& seed, const PastePlacement& placement,
    bool quick, const Progress& progress);
  void TryOn(const ExponentialPatch& patch, const Eigen::MatrixXd& loop, Trial& trial);
  Eigen::MatrixXd GetLoopPositions(const CoveredRegion& cover) const;
  CoveredRegionFault TryConformally(const ExponentialPatch& patch, bool refine,
    const Eigen::MatrixXd& loop, Trial& trial, const Progress& progress);

  ExponentialMap Map;
  CoveredRegionFinder Finder;
  double MeanEdge;
  int LastTriangle = -1; ///< of the seed before: the next one is likely near
};

} // namespace shape
