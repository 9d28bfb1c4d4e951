#include "CutPaste/PasteTarget.h"

#include "Base/Errors.h"
#include "ExponentialMap/ConformalPatch.h"
#include "Geometry/VertexNormals.h"
#include "Mesh/Extent.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>
#include <string>
#include <utility>

namespace shape
{
namespace
{

const Surface& RequireTarget(const Surface& surface)
{
  RequireManifold(surface, "the target");
  return surface;
}

/// Returns whether another layout may avoid this fault.
bool IsOfLayout(CoveredRegionFault fault)
{
  return fault == CoveredRegionFault::Flipped || fault == CoveredRegionFault::Overlaps ||
    fault == CoveredRegionFault::Collapsed;
}

std::string Reason(const CoveredRegion& cover)
{
  switch (cover.Fault)
  {
    case CoveredRegionFault::Flipped:
      return "its loop goes through " + std::to_string(cover.FlippedAtLoop) +
        " triangles that flip when the target is flattened there";
    case CoveredRegionFault::Overlaps:
      return "the target wraps around there, so the feature would cover a part of it twice";
    case CoveredRegionFault::NotADisk:
      return "the region that it would cover there contains a handle or a hole of the target";
    case CoveredRegionFault::LeavesSurface:
      return "it would extend beyond the boundary of the target there";
    case CoveredRegionFault::Collapsed:
      return "an edge of its loop shrinks to a point when the target is flattened there";
    case CoveredRegionFault::Shared:
      return "the region that it would cover there touches that of another loop";
    default:
      return "the region that it would cover there extends beyond the flattened part of the target";
  }
}

/// Returns whether an edge of the loop has collapsed: its points are in triangles whose image has
/// no area.
bool IsCollapsed(const Eigen::MatrixXd& positions, const Eigen::MatrixXd& image)
{
  constexpr double minimum = 1e-6; // relative to its length in the plane
  const Eigen::Index size = positions.rows();
  for (Eigen::Index i = 0; i < size; ++i)
  {
    const Eigen::Index j = (i + 1) % size;
    if (!((positions.row(i) - positions.row(j)).norm() >
          minimum * (image.row(i) - image.row(j)).norm()))
    {
      return true;
    }
  }
  return false;
}

/// The axes of a plane as columns.
Eigen::Matrix3d AxesOf(const Eigen::RowVector3d& axis, const Eigen::RowVector3d& normal)
{
  Eigen::Matrix3d axes;
  axes << axis.transpose(), normal.cross(axis).transpose(), normal.transpose();
  return axes;
}

/// The rotation that lays a base on a surface with a normal, and rotates it there by degrees.
Eigen::Matrix3d RotationOnto(
  const FeatureFootprint& base, const Eigen::RowVector3d& normal, double degrees)
{
  const Eigen::AngleAxisd turn(degrees * M_PI / 180.0, normal.transpose());
  return turn.toRotationMatrix() * AxesOf(TurnAxis(base, normal), normal) *
    AxesOf(base.XAxis, base.Normal).transpose();
}

} // namespace

/// A loop on the target, or its fault.
struct PasteTarget::Trial
{
  TangentFrame Seed;
  CoveredRegion Cover;
  SeamBand Join;
  TargetLayout Layout = TargetLayout::ExponentialMap;
};

PasteTarget::PasteTarget(
  const shape::Surface& surface, const ExponentialMapOptions& options, const Progress& progress)
  : Map(RequireTarget(surface), options, progress)
  , Finder(surface)
  , MeanEdge(ComputeMeanEdgeLength(surface))
{
}

/// Lays out one loop after another, until one has a fault.
std::vector<PasteTarget::Trial> PasteTarget::TryAll(const std::vector<FeatureFootprint>& bases,
  const ClosestPoint& seed, const PastePlacement& placement, bool quick, const Progress& progress)
{
  std::vector<Trial> trials;
  trials.push_back(this->Try(bases[0], seed, placement, quick, progress));
  const Eigen::Matrix3d turn =
    RotationOnto(bases[0], this->Map.Normal(seed), placement.Rotation).transpose();
  std::set<int> covered; // points of the regions
  while (trials.size() < bases.size() && trials.back().Cover.Fault == CoveredRegionFault::None)
  {
    for (const int triangle : trials.back().Cover.Triangles)
    {
      const auto corners = this->Surface().Triangles().row(triangle);
      covered.insert(corners.begin(), corners.end());
    }
    FeatureFootprint base = bases[trials.size()];
    const Eigen::RowVector3d position =
      seed.Position + placement.Scale * (base.Origin - bases[0].Origin) * turn;
    base.Normal *= turn;
    base.XAxis *= turn;
    Trial trial = this->Try(base, this->Map.Locator().FindOne(position),
      { position, 0.0, placement.Scale }, quick, progress);
    const auto isShared = [&](int triangle)
    {
      const auto corners = this->Surface().Triangles().row(triangle);
      return std::any_of(
        corners.begin(), corners.end(), [&](int point) { return covered.count(point) > 0; });
    };
    const std::vector<int>& own = trial.Cover.Triangles;
    if (trial.Cover.Fault == CoveredRegionFault::None &&
      std::any_of(own.begin(), own.end(), isShared))
    {
      trial.Cover.Fault = CoveredRegionFault::Shared;
    }
    trials.push_back(std::move(trial));
  }
  return trials;
}

void RequireInRange(const PastePlacement& placement)
{
  RequireOption(
    placement.Scale > 0.0 && std::isfinite(placement.Scale), "Scale", placement.Scale, "positive");
  RequireOption(std::isfinite(placement.Rotation), "Rotation", placement.Rotation, "finite");
  RequireFinite(placement.Seed, "Seed");
}

Eigen::MatrixXd PoseLoop(const FeatureFootprint& base, const PastePlacement& placement)
{
  const Eigen::Rotation2Dd turn(placement.Rotation * M_PI / 180.0);
  return placement.Scale * base.LoopPositions * turn.toRotationMatrix().transpose();
}

/// First the layout of the base, if that is conformal; then the exponential map; then, if the fault
/// is one of the layout, conformal maps of the same patch.
PasteTarget::Trial PasteTarget::Try(const FeatureFootprint& base, const ClosestPoint& seed,
  const PastePlacement& placement, bool quick, const Progress& progress)
{
  const Eigen::MatrixXd loop = PoseLoop(base, placement);
  const Eigen::RowVector3d axis = TurnAxis(base, this->Map.Normal(seed));
  Trial trial;
  // Distances on the surface are longer than those in the plane: the patch grows until it contains
  // the loop and the ring around it.
  // Three mean edges, since the ring passes through whole triangles around the loop.
  double radius = 1.1 * loop.rowwise().norm().maxCoeff() + 3.0 * this->MeanEdge;
  if (base.ConformalRadius > 0.0)
  {
    // Flattened like the base, so that the loop returns on the surface from which it was cut.
    const ExponentialPatch patch =
      this->Map.Around(seed, placement.Scale * base.ConformalRadius, axis, progress);
    trial.Seed = patch.Seed;
    if (this->TryConformally(patch, base.IsRefined, loop, trial, progress) ==
      CoveredRegionFault::None)
    {
      return trial;
    }
  }
  for (int round = 0; round < 5; ++round)
  {
    const ExponentialPatch patch = this->Map.Around(seed, radius, axis, progress);
    trial.Seed = patch.Seed;
    this->TryOn(patch, loop, trial);
    bool isBeyond = trial.Cover.Fault == CoveredRegionFault::BeyondPatch;
    if (IsOfLayout(trial.Cover.Fault))
    {
      CoveredRegionFault fault = this->TryConformally(patch, false, loop, trial, progress);
      if (IsOfLayout(fault) && !quick)
      {
        fault = this->TryConformally(patch, true, loop, trial, progress);
      }
      isBeyond = fault == CoveredRegionFault::BeyondPatch && !quick;
    }
    if (!isBeyond)
    {
      break;
    }
    radius *= 1.4;
  }
  return trial;
}

void PasteTarget::TryOn(const ExponentialPatch& patch, const Eigen::MatrixXd& loop, Trial& trial)
{
  // Snapping moves the loop by 2 % of an edge at most.
  trial.Cover = this->Finder.Find(patch, loop, 0.02 * this->MeanEdge);
  if (trial.Cover.Fault == CoveredRegionFault::None &&
    IsCollapsed(this->GetLoopPositions(trial.Cover), trial.Cover.Loop))
  {
    trial.Cover.Fault = CoveredRegionFault::Collapsed;
  }
  if (trial.Cover.Fault == CoveredRegionFault::None)
  {
    try
    {
      // Schmidt and Singh, section 4.2: the hole is cut and the seam is triangulated in the plane
      // of the exponential map.
      trial.Join = TriangulateSeamBand(trial.Cover.Loop, trial.Cover.RingImage);
    }
    catch (const InvalidInput&) // the ring crosses itself or the loop
    {
      trial.Cover.Fault = CoveredRegionFault::Overlaps;
    }
  }
}

Eigen::MatrixXd PasteTarget::GetLoopPositions(const CoveredRegion& cover) const
{
  return PullBack(cover.Positions, this->Surface().Triangles(), this->Surface().Points());
}

CoveredRegionFault PasteTarget::TryConformally(const ExponentialPatch& patch, bool refine,
  const Eigen::MatrixXd& loop, Trial& trial, const Progress& progress)
{
  if (patch.Triangles.empty())
  {
    return CoveredRegionFault::BeyondPatch;
  }
  Trial other;
  try
  {
    this->TryOn(FlattenPatchConformally(this->Surface(), patch, refine, progress), loop, other);
  }
  catch (const SolveFailure&) // it cannot be flattened: report the fault of the other layout
  {
    return CoveredRegionFault::Flipped;
  }
  if (other.Cover.Fault == CoveredRegionFault::None)
  {
    trial.Cover = std::move(other.Cover);
    trial.Join = std::move(other.Join);
    trial.Layout = refine ? TargetLayout::MinimumDistortion : TargetLayout::Conformal;
  }
  return other.Cover.Fault;
}

LoopOnTarget PasteTarget::Land(const FeatureFootprint& base, const PastePlacement& placement,
  bool search, const Progress& progress)
{
  return std::move(
    this->Land(std::vector<FeatureFootprint>{ base }, placement, search, progress).front());
}

/// The plane of the base is laid on the target's tangent plane at the seed. Rotation and Scale act
/// in the plane (Schmidt and Singh, section 4.2).
std::vector<LoopOnTarget> PasteTarget::Land(const std::vector<FeatureFootprint>& bases,
  const PastePlacement& placement, bool search, const Progress& progress)
{
  RequireInRange(placement);
  const ClosestPoint seed = this->Map.Locator().FindOne(placement.Seed, this->LastTriangle);
  this->LastTriangle = seed.Triangle;
  std::vector<Trial> trials = this->TryAll(bases, seed, placement, !search, progress);
  if (trials.back().Cover.Fault != CoveredRegionFault::None)
  {
    std::ostringstream words;
    words << "the feature does not fit at the seed: ";
    if (bases.size() > 1)
    {
      words << "at the loop with index " << trials.size() - 1 << " of " << bases.size() << ", ";
    }
    words << Reason(trials.back().Cover);
    if (search)
    {
      PastePlacement smaller = placement;
      double good = 0.0, bad = placement.Scale;
      // Bisection to 1 / 256 of Scale. The range that fits need not be one interval, so the
      // proposed scale is one that was tried, less 1 % for rounding.
      for (int step = 0; step < 8; ++step)
      {
        smaller.Scale = (good + bad) / 2.0;
        const bool fits = this->TryAll(bases, seed, smaller, true, progress).back().Cover.Fault ==
          CoveredRegionFault::None;
        (fits ? good : bad) = smaller.Scale;
      }
      if (good > 0.0)
      {
        words << "; lower Scale to " << 0.99 * good << " or move Seed";
      }
      else
      {
        const bool isShared = trials.back().Cover.Fault == CoveredRegionFault::Shared;
        words << ", at any Scale down to " << bad << "; move Seed"
              << (isShared ? ", or refine the target there" : "");
      }
    }
    else
    {
      words << "; lower Scale or move Seed";
    }
    throw InvalidInput(words.str());
  }
  std::vector<LoopOnTarget> landings;
  for (Trial& trial : trials)
  {
    LoopOnTarget landing;
    landing.Layout = trial.Layout;
    landing.Seed = trial.Seed;
    const Eigen::MatrixXi& triangles = this->Surface().Triangles();
    landing.Positions = this->GetLoopPositions(trial.Cover);
    landing.Normals = PullBack(trial.Cover.Positions, triangles, GetVertexNormals(this->Surface()))
                        .rowwise()
                        .normalized();
    landing.Cover = std::move(trial.Cover);
    landing.Join = std::move(trial.Join);
    landings.push_back(std::move(landing));
  }
  return landings;
}

} // namespace shape
