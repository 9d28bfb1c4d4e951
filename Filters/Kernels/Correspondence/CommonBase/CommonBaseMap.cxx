#include "Correspondence/CommonBase/CommonBaseMap.h"

#include "Correspondence/CommonBase/Private/BaseEmbedding.h"
#include "Correspondence/CommonBase/Private/ConeSurface.h"
#include "Correspondence/CommonBase/Private/MapPlaces.h"
#include "Correspondence/CommonBase/Private/MapRelaxation.h"
#include "Correspondence/CommonBase/Private/PositionOrder.h"
#include "Search/ClosestPoint.h"

#include <optional>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

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

/// The paths as they were traced on A, and their images.
std::vector<BasePath> PathsOf(
  const BaseDomain& domain, const SurfacePieces& onA, const PositionMap& toB)
{
  std::vector<BasePath> paths(domain.Paths.size());
  for (std::size_t patch = 0; patch < domain.Patches.size(); ++patch)
  {
    for (const int side : domain.Patches[patch])
    {
      BasePath& path = paths[side / 2];
      (side % 2 == 0 ? path.Left : path.Right) = static_cast<int>(patch);
    }
  }
  for (std::size_t i = 0; i < paths.size(); ++i)
  {
    const std::vector<int>& points = domain.A.Paths[i];
    std::vector<int> found;
    std::vector<Eigen::RowVector3d> images;
    for (const int point : points)
    {
      const bool isEnd = point == points.front() || point == points.back();
      const std::vector<int>& ends = domain.B.Paths[i];
      const std::optional<Eigen::RowVector3d> image = isEnd
        ? domain.B.Surface.Points.row(point == points.front() ? ends.front() : ends.back()).eval()
        : toB.ImageOf(onA.PlaceOf(point));
      if (image)
      {
        found.push_back(point);
        images.push_back(*image);
      }
    }
    paths[i].IsCurve = static_cast<int>(i) < domain.A.CurvePaths;
    paths[i].OnA = domain.A.Surface.Points(found, Eigen::all);
    paths[i].OnB.resize(static_cast<Eigen::Index>(images.size()), 3);
    for (std::size_t k = 0; k < images.size(); ++k)
    {
      paths[i].OnB.row(static_cast<Eigen::Index>(k)) = images[k];
    }
  }
  return paths;
}

/// MapThroughBase for surfaces in an order that their numbers do not change.
CommonBaseMap MapOrdered(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const CommonBaseOptions& options, const Progress& progress)
{
  const BaseDomain domain = TraceBaseDomain(
    a, b, landmarks, options.Curves, progress.Part(0.0, 0.3, "tracing the base domain"));
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
  MapRelaxation relaxation(
    { domain.A, flatA, std::move(onB) }, { domain.B, flatB, std::move(onA) });
  const MapRelaxation::Goal dirichlet, goal{ options.Measure, options.Exponent };
  const bool isDirichlet = options.Measure == Distortion::SymmetricDirichlet;
  const auto measure = [&]
  { return 0.5 * (relaxation.Energy(0, goal) + relaxation.Energy(1, goal)); };
  const Progress part = progress.Part(0.5, 0.95, "reducing the distortion");
  map.MeasureBefore = measure();
  relaxation.Run(dirichlet, part.Part(0.0, isDirichlet ? 1.0 : 0.5));
  if (!isDirichlet)
  {
    map.MeasureBefore = measure();
    relaxation.Run(goal, part.Part(0.5, 1.0));
  }
  map.MeasureAfter = measure();
  map.Energy = relaxation.Energy(0, dirichlet);
  map.EnergyBack = relaxation.Energy(1, dirichlet);
  map.Maps.AToB =
    GetImages(a.Points().rows(), domain.A, flatA, relaxation.Places(0), domain.B, flatB);
  map.Maps.BToA =
    GetImages(b.Points().rows(), domain.B, flatB, relaxation.Places(1), domain.A, flatA);
  const SurfacePieces pieces(domain.A);
  map.PatchesOfA.resize(a.Points().rows());
  for (Eigen::Index t = 0; t < domain.A.Patches.size(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const int point = domain.A.Surface.Triangles(t, k);
      if (point < map.PatchesOfA.size())
      {
        map.PatchesOfA(point) = domain.A.Patches(t);
      }
    }
  }
  map.PatchesOfB.resize(b.Points().rows());
  for (Eigen::Index point = 0; point < map.PatchesOfB.size(); ++point)
  {
    map.PatchesOfB(point) = domain.A.Patches(
      pieces.Find({ map.Maps.BToA.Triangles(point), map.Maps.BToA.Barycentrics.row(point) }));
  }
  map.Paths = PathsOf(domain, pieces, PositionMap(flatA, relaxation.Places(0), flatB, domain.B));
  map.Flipped = CountFlipped(flatA) + CountFlipped(flatB);
  progress(1.0);
  return map;
}

} // namespace

// The relaxation has many local minima: which one it reaches depends on the order of the points.
CommonBaseMap MapThroughBase(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const CommonBaseOptions& options, const Progress& progress)
{
  const PositionOrder onA(a), onB(b);
  Landmarks ordered = landmarks;
  for (auto& [pointA, pointB] : ordered)
  {
    pointA = onA.PointOf.at(pointA);
    pointB = onB.PointOf.at(pointB);
  }
  CommonBaseOptions own = options;
  for (CurvePair& curve : own.Curves)
  {
    for (int& point : curve.OnA)
    {
      point = onA.PointOf.at(point);
    }
    for (int& point : curve.OnB)
    {
      point = onB.PointOf.at(point);
    }
  }
  CommonBaseMap map = MapOrdered(onA.Shape, onB.Shape, ordered, own, progress);
  map.Maps = { AsGiven(map.Maps.AToB, onA, onB), AsGiven(map.Maps.BToA, onB, onA) };
  map.PatchesOfA = AsGiven(map.PatchesOfA, onA);
  map.PatchesOfB = AsGiven(map.PatchesOfB, onB);
  return map;
}

} // namespace shape
