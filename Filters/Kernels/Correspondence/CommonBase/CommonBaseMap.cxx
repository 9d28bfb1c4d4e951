#include "Correspondence/CommonBase/CommonBaseMap.h"

#include "Correspondence/CommonBase/Private/BaseEmbedding.h"
#include "Correspondence/CommonBase/Private/ConeSurface.h"
#include "Correspondence/CommonBase/Private/MapRelaxation.h"
#include "Search/ClosestPoint.h"

#include <vector>

namespace shape
{
namespace
{

constexpr int Turns = 6; ///< of each surface

/// Returns for each point of a divided surface the triangle of the other one with its position in
/// the same patch.
std::vector<ConePlace> PlacesOf(const PatchedSurface& from, const BaseEmbedding& plane,
  const ConeSurface& flat, const BaseEmbedding& otherPlane)
{
  std::vector<SurfaceLocator> locators;
  locators.reserve(otherPlane.Patches.size());
  for (const Mesh& patch : otherPlane.Patches)
  {
    locators.emplace_back(patch);
  }
  std::vector<ConePlace> places(flat.PointCount());
  for (int point = 0; point < flat.PointCount(); ++point)
  {
    // A point has the coordinates of the patch at its first corner.
    const int side = flat.CornersAt(point).front(), patch = from.Patches(side / 3);
    const ClosestPoint found =
      locators[patch].FindOne(plane.Patches[patch].Points.row(plane.RowOf(side)));
    places[point].Triangle = otherPlane.Triangles[patch][found.Triangle];
  }
  return places;
}

int CountFlipped(const ConeSurface& surface)
{
  int flipped = 0;
  for (int t = 0; t < surface.TriangleCount(); ++t)
  {
    flipped += surface.PointAt(3 * t) >= 0 && !surface.IsCounterClockwise(t) ? 1 : 0;
  }
  return flipped;
}

} // namespace

CommonBaseMap MapThroughBase(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress)
{
  const BaseDomain domain =
    TraceBaseDomain(a, b, landmarks, progress.Part(0.0, 0.3, "tracing the base domain"));
  const BaseEmbedding planeA = EmbedPatches(
    domain, domain.A, "SurfaceA", progress.Part(0.3, 0.4, "flattening the patches of SurfaceA"));
  const BaseEmbedding planeB = EmbedPatches(
    domain, domain.B, "SurfaceB", progress.Part(0.4, 0.5, "flattening the patches of SurfaceB"));
  CommonBaseMap map;
  map.Patches = static_cast<int>(domain.Patches.size());
  map.Genus = domain.Genus;
  ConeSurface flatA(domain, domain.A, planeA), flatB(domain, domain.B, planeB);
  std::vector<ConePlace> onB = PlacesOf(domain.A, planeA, flatA, planeB);
  std::vector<ConePlace> onA = LocatePoints(flatB, flatA, onB);
  // The surfaces take turns, since straight lines on the flat surface should be straight on both.
  const Progress turns = progress.Part(0.5, 0.95, "reducing the distortion");
  for (int turn = 0; turn < Turns; ++turn)
  {
    const Progress part = turns.Part(static_cast<double>(turn) / Turns, (turn + 1.0) / Turns);
    MapRelaxation back(domain.B, flatB, domain.A, flatA, std::move(onA));
    back.Run(part.Part(0.0, 0.5));
    onB = LocatePoints(flatA, flatB, back.Places());
    MapRelaxation there(domain.A, flatA, domain.B, flatB, std::move(onB));
    there.Run(part.Part(0.5, 1.0));
    onB = there.Places();
    onA = LocatePoints(flatB, flatA, onB);
    map.Energy = there.Energy();
  }
  map.Maps.AToB = GetImages(a.Points().rows(), domain.A, flatA, onB, domain.B, flatB);
  map.Maps.BToA = GetImages(b.Points().rows(), domain.B, flatB, onA, domain.A, flatA);
  map.Flipped = CountFlipped(flatA) + CountFlipped(flatB);
  progress(1.0);
  return map;
}

} // namespace shape
