#include "ExponentialMap/PatchLayout.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/Topology.h"
#include "Parameterize/FlipMending.h"

#include <algorithm>
#include <cmath>

namespace shape
{
namespace
{

int Mend(const Mesh& surface, ExponentialPatch& patch, const Progress& progress)
{
  const int mended = MendFlips(PatchSurface(surface, patch), patch.Places, patch.Torn, progress);
  const auto isMended = [&](int row)
  {
    return Orientation(patch.Places.row(patch.Corners(row, 0)),
             patch.Places.row(patch.Corners(row, 1)), patch.Places.row(patch.Corners(row, 2))) > 0;
  };
  patch.Flipped.erase(
    std::remove_if(patch.Flipped.begin(), patch.Flipped.end(), isMended), patch.Flipped.end());
  return mended;
}

} // namespace

PatchLayout LayOutPatch(ExponentialMap& map, const Eigen::RowVector3d& seed,
  const Eigen::RowVector3d& xDirection, const PatchLayoutOptions& options, const Progress& progress)
{
  RequireFinite(seed, "the Seed");
  RequireFinite(xDirection, "the XDirection");
  RequireOption(std::isfinite(options.Radius) && options.Radius >= 0.0, "Radius", options.Radius,
    "positive, or 0 for a tenth of the diagonal");
  constexpr double share = 0.1;
  PatchLayout layout;
  const double diagonal = BoxDiagonal(map.Surface().Points);
  layout.Radius = options.Radius > 0.0 ? options.Radius : share * diagonal;
  const ClosestPlace place = map.Locator().FindOne(seed);
  layout.SeedDistance = place.Distance;
  layout.Patch = map.Around(place, layout.Radius, xDirection, progress.Part(0.0, 0.4));
  if (layout.Patch.Points.empty())
  {
    throw InvalidInput("no point of the surface lies within Radius (" +
      std::to_string(layout.Radius) + ") of the Seed; raise Radius, or refine the surface there");
  }
  if (options.MendFlips)
  {
    layout.Mended = Mend(map.Surface(), layout.Patch, progress.Part(0.4, 0.8));
  }
  layout.Facts = FactsOf(map.Surface(), layout.Patch, layout.Radius, progress.Part(0.8, 1.0));
  return layout;
}

} // namespace shape
