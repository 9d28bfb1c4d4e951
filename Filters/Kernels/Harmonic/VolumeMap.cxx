#include "Harmonic/VolumeMap.h"

#include "Base/Errors.h"
#include "Distance/TargetDistance.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Harmonic/Private/FreeBoundary.h"

#include <utility>

namespace shape
{
namespace
{

/// Wraps one harmonic map as a piecewise map of one region.
PiecewiseVolumeMapResult AsOneRegion(HarmonicVolumeMapResult map, const Surface& boundary)
{
  PiecewiseVolumeMapResult result;
  result.Charges = { { map.Map }, boundary, {}, 0.0, {} };
  result.Charges.Farthest = ComputeFarthest(map.OffsetDistance, boundary.Points());
  // The last level holds the errors of the complete sum, whether or not its own map was kept.
  const HarmonicVolumeMapResult::Level& last = map.Levels.back();
  result.Borders.push_back({ last.RMSEVertices, last.RMSEInside, last.Maximum });
  result.RMSEFeatures = map.RMSEFeatures;
  result.OffsetDistance = map.OffsetDistance;
  result.Layers.push_back(std::move(map));
  return result;
}

} // namespace

VolumeMapResult ComputeVolumeMap(const VolumeMapConditions& conditions,
  const VolumeMapOptions& options, const Progress& progress, AcceleratedSetup* setup)
{
  if (options.FreeBoundary && !conditions.Target)
  {
    throw InvalidInput("FreeBoundary needs the input 'Target', the surface that the boundary's "
                       "images slide on; connect it, or turn FreeBoundary off");
  }
  const Surface& boundary = conditions.Boundary;
  VolumeMapResult result;
  result.Targets = conditions.Targets;
  // Step 1 of the header.
  if (conditions.Target)
  {
    result.TargetDistance = ComputeTargetDistance(
      boundary, conditions.Targets, *conditions.Target, progress.Part(0.0, 0.02));
  }
  // Step 2: one map of the whole solid.
  HarmonicVolumeMapResult one;
  if (options.FreeBoundary || !options.Exact)
  {
    one = ComputeHarmonicVolumeMap(boundary, result.Targets, conditions.Features, options.Harmonic,
      progress.Part(0.02, options.FreeBoundary ? 0.3 : 1.0), setup);
  }
  if (options.FreeBoundary)
  {
    // Step 3: the boundary slides.
    FreeBoundaryResult slid = SlideBoundary(boundary, result.Targets, *conditions.Target,
      conditions.Features, options.Harmonic, one, progress.Part(0.3, options.Exact ? 0.6 : 1.0));
    result.DistortionBefore = slid.DistortionBefore;
    result.DistortionAfter = slid.DistortionAfter;
    result.Slid = slid.Kept;
    result.Targets = std::move(slid.Targets);
    one = std::move(slid.Map);
  }
  // Step 4: one map for each layer.
  result.Map = options.Exact
    ? ComputePiecewiseVolumeMap(boundary, result.Targets, conditions.Surfaces, conditions.Features,
        options.Harmonic, {}, progress.Part(options.FreeBoundary ? 0.6 : 0.02, 1.0))
    : AsOneRegion(std::move(one), boundary);
  return result;
}

} // namespace shape
