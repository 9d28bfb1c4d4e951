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

/// Where a feature is to be set down.
struct PastePlacement
{
  Eigen::RowVector3d Seed = Eigen::RowVector3d::Zero(); ///< taken to the closest place
  double Rotation = 0.0;                                ///< degrees, about the outward normal
  double Scale = 1.0;                                   ///< > 0
};

/// How a target is laid out in the plane: by its exponential map, or in one of the two ways of
/// FlattenPatchConformally.
enum class TargetLayout
{
  ExponentialMap,
  Conformal,
  MinimumDistortion
};

/// Where a feature's loop comes to lie on a target.
struct LoopOnTarget
{
  TargetLayout Layout = TargetLayout::ExponentialMap;
  TangentFrame Seed;         ///< XAxis: where the base's is turned to, before Rotation
  Eigen::MatrixXd Positions; ///< n x 3: of the loop's points, on the target
  Eigen::MatrixXd Normals;   ///< n x 3: unit normals of the target there
  CoveredRegion Cover;       ///< what they cover
  SeamBand Join;             ///< the triangles between the loop and the ring of Cover
};

/**
 * A surface that features are set down on: owns what depends on it alone, so that a feature is
 * dragged across it in time for what it covers only. Not for several threads at once.
 */
class PasteTarget
{
public:
  /// surface: an oriented 2-manifold, open or closed. Throws InvalidInput where it is none,
  /// Aborted.
  explicit PasteTarget(const shape::Surface& surface, const ExponentialMapOptions& options = {},
    const Progress& progress = {});

  const shape::Surface& Surface() const { return this->Map.Surface(); }
  ExponentialMap& Layout() { return this->Map; }
  int EulerNumber() const { return this->Surface().Topology().EulerNumber; }

  /**
   * Lays the base's loop on the surface through the exponential maps of both: the directions of the
   * base's plane are turned by the shortest way from its normal to the one at the seed, then by
   * Rotation. So a base that comes from this very surface returns to where it was. Where the loop
   * meets flipped triangles of the target's map, or that overlaps, a conformal one takes its place.
   *
   * Throws InvalidInput where the surface there cannot take the loop, with the reason and the
   * largest scale that it would take. search: whether to look for that scale, and to refine a
   * conformal layout: else the landing is quick. Aborted.
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
