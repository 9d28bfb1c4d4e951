#include "ExponentialMap/PatchLayout.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/Topology.h"
#include "Parameterize/FlipRepair.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

int Mend(const Mesh& surface, ExponentialPatch& patch, const Progress& progress)
{
  const int mended =
    RepairFlips(BuildPatchSurface(surface, patch), patch.Positions, patch.Torn, progress);
  const auto isMended = [&](int row)
  {
    return EvaluateOrientation(patch.Positions.row(patch.Corners(row, 0)),
             patch.Positions.row(patch.Corners(row, 1)),
             patch.Positions.row(patch.Corners(row, 2))) > 0;
  };
  patch.Flipped.erase(
    std::remove_if(patch.Flipped.begin(), patch.Flipped.end(), isMended), patch.Flipped.end());
  return mended;
}

} // namespace

PatchLayout FlattenPatch(ExponentialMap& map, const Eigen::RowVector3d& seed,
  const Eigen::RowVector3d& xDirection, const PatchLayoutOptions& options, const Progress& progress)
{
  RequireFinite(seed, "the Seed");
  RequireFinite(xDirection, "the XDirection");
  RequireOption(std::isfinite(options.Radius) && options.Radius >= 0.0, "Radius", options.Radius,
    "positive, or 0 for a tenth of the diagonal");
  constexpr double share = 0.1;
  PatchLayout layout;
  const double diagonal = ComputeBoxDiagonal(map.Surface().Points);
  layout.Radius = options.Radius > 0.0 ? options.Radius : share * diagonal;
  const ClosestPoint position = map.Locator().FindOne(seed);
  layout.SeedDistance = position.Distance;
  layout.Patch = map.Around(position, layout.Radius, xDirection, progress.Part(0.0, 0.4));
  if (layout.Patch.Points.empty())
  {
    throw InvalidInput("no point of the surface lies within Radius (" +
      std::to_string(layout.Radius) + ") of the Seed; raise Radius, or refine the surface there");
  }
  if (options.MendFlips)
  {
    layout.Mended = Mend(map.Surface(), layout.Patch, progress.Part(0.4, 0.8));
  }
  layout.Facts =
    ComputeExponentialFacts(map.Surface(), layout.Patch, layout.Radius, progress.Part(0.8, 1.0));
  return layout;
}

} // namespace shape
