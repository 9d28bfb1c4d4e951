#include "Correspondence/Symmetry.h"

#include "Base/Errors.h"
#include "Correspondence/Evaluate/SurfaceMapFacts.h"
#include "Correspondence/Pair/CoarsePair.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Correspondence/Private/CompactSurface.h"
#include "Correspondence/Private/SelfMaps.h"
#include "Correspondence/Private/SymmetrySearch.h"
#include "Geodesics/HeatGeodesics.h"
#include "Remesh/Coarsening.h"
#include "Remesh/LongestEdgeBisection.h"
#include "Search/ClosestPoint.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// Returns the surface, and new points within its edges after its own ones, until it has `points`.
Surface Bisect(const Surface& surface, int points)
{
  if (surface.Points().rows() >= points)
  {
    return surface;
  }
  Mesh mesh = surface;
  while (mesh.Points.rows() < points)
  {
    BisectLongestEdges(mesh, std::vector<char>(mesh.Triangles.rows(), 1));
  }
  return mesh;
}

/// Returns the part of a map of the bisected surface that the given surface's points have, with
/// positions on its triangles.
SurfacePoints FindMapOfGiven(
  const Surface& given, const Surface& bisected, const SurfacePoints& map)
{
  if (bisected.Points().rows() == given.Points().rows())
  {
    return map;
  }
  const Eigen::MatrixXd images = PullBack(map, bisected.Triangles(), bisected.Points());
  return SurfaceLocator(given).Find(images.topRows(given.Points().rows()));
}

/// Returns the number of times after which an element is the identity.
int FindOrder(const Eigen::MatrixXi& composition, int element)
{
  int order = 1;
  for (int power = element; power != 0; power = composition(element, power))
  {
    ++order;
  }
  return order;
}

/// Returns where the linear interpolation of `values` is 0 in the triangles that are `wanted`.
std::vector<std::array<Eigen::RowVector3d, 2>> TraceZeros(
  const Surface& surface, const Eigen::VectorXd& values, const std::vector<bool>& wanted)
{
  std::vector<std::array<Eigen::RowVector3d, 2>> segments;
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    std::vector<Eigen::RowVector3d> crossings;
    for (int k = 0; k < 3 && wanted[t]; ++k)
    {
      const int a = surface.Triangles()(t, k), b = surface.Triangles()(t, (k + 1) % 3);
      if ((values(a) < 0.0) != (values(b) < 0.0))
      {
        // Both triangles of the edge get the same bits.
        const int low = std::min(a, b), high = std::max(a, b);
        const double along = values(low) / (values(low) - values(high));
        crossings.emplace_back(
          (1.0 - along) * surface.Points().row(low) + along * surface.Points().row(high));
      }
    }
    if (crossings.size() == 2)
    {
      segments.push_back({ crossings[0], crossings[1] });
    }
  }
  return segments;
}

/// The points that a reflection keeps. Points there are as far from any point as from its image;
/// and they are near their own images.
std::vector<std::array<Eigen::RowVector3d, 2>> FindFixedCurves(
  const Surface& surface, const SurfacePoints& map)
{
  const Eigen::MatrixXd images = PullBack(map, surface.Triangles(), surface.Points());
  const Eigen::VectorXd moved = (images - surface.Points()).rowwise().norm();
  Eigen::Index farthest = 0;
  moved.maxCoeff(&farthest);
  const int image = FindNearestCorners(map, surface.Triangles())(farthest);
  const Eigen::MatrixXd distances =
    ComputeHeatDistances(surface, { static_cast<int>(farthest), image });
  // The difference is made exactly odd under the map.
  const Eigen::VectorXd difference = distances.col(0) - distances.col(1);
  const Eigen::VectorXd odd =
    0.5 * (difference - PullBack(map, surface.Triangles(), difference).col(0));
  const double near = 0.1 * std::sqrt(ComputePointAreas(surface).sum());
  std::vector<bool> wanted(surface.Triangles().rows());
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    wanted[t] = moved(surface.Triangles().row(t)).maxCoeff() < near;
  }
  return TraceZeros(surface, odd, wanted);
}

/// Returns the point whose images are as far apart as possible: those of `generic` on the surface.
int FindGenericPoint(const Surface& surface, const std::vector<Symmetry>& elements)
{
  Eigen::VectorXd least =
    Eigen::VectorXd::Constant(surface.Points().rows(), std::numeric_limits<double>::infinity());
  for (std::size_t i = 1; i < elements.size(); ++i)
  {
    least = least.cwiseMin(
      (PullBack(elements[i].Map, surface.Triangles(), surface.Points()) - surface.Points())
        .rowwise()
        .norm());
  }
  Eigen::Index generic = 0;
  least.maxCoeff(&generic);
  return static_cast<int>(generic);
}

/// Returns the corner of the image's triangle that is in the domain and nearest to the image, or
/// -1.
int FindCornerInDomain(const Surface& surface, const SurfacePoints& map, Eigen::Index point,
  const Eigen::VectorXi& copies)
{
  int best = -1;
  double share = -1.0;
  for (int k = 0; k < 3; ++k)
  {
    const int corner = surface.Triangles()(map.Triangles(point), k);
    if (copies(corner) == 0 && map.Barycentrics(point, k) > share)
    {
      share = map.Barycentrics(point, k);
      best = corner;
    }
  }
  return best;
}

/// Divides the surface into the copies of a fundamental domain (a Dirichlet domain), and finds the
/// orbits. A point is as far from the image of the generic point under an element as its own image
/// under the inverse is from the generic point itself. So one distance function suffices, and
/// copies are as exact as the maps.
void DivideByGroup(const Surface& surface, SymmetryResult& result)
{
  const auto order = static_cast<int>(result.Elements.size());
  const Eigen::Index points = surface.Points().rows();
  result.Copies = Eigen::VectorXi::Zero(points);
  result.Orbits = Eigen::VectorXi::LinSpaced(points, 0, static_cast<int>(points) - 1);
  if (order == 1)
  {
    return;
  }
  const Eigen::VectorXd distances =
    ComputeHeatDistances(surface, { FindGenericPoint(surface, result.Elements) }).col(0);
  Eigen::MatrixXd ofImages(points, order);
  for (int i = 0; i < order; ++i)
  {
    ofImages.col(i) = PullBack(result.Elements[i].Map, surface.Triangles(), distances);
  }
  Eigen::VectorXi home(points); // the element that takes the point into the domain
  std::vector<int> domain;
  for (int point = 0; point < static_cast<int>(points); ++point)
  {
    Eigen::Index nearest = 0, inverse = 0;
    ofImages.row(point).minCoeff(&nearest);
    (result.Composition.row(nearest).array() == 0).cast<int>().maxCoeff(&inverse);
    home(point) = static_cast<int>(nearest);
    result.Copies(point) = static_cast<int>(inverse);
    if (nearest == 0)
    {
      domain.push_back(point);
    }
  }
  for (int point = 0; point < static_cast<int>(points); ++point)
  {
    if (home(point) == 0)
    {
      continue;
    }
    const SurfacePoints& map = result.Elements[home(point)].Map;
    result.Orbits(point) = FindCornerInDomain(surface, map, point, result.Copies);
    if (result.Orbits(point) < 0)
    {
      // The image is at the border of the domain.
      const Eigen::RowVector3d image =
        GetPosition(surface, { map.Triangles(point), map.Barycentrics.row(point) });
      Eigen::Index nearest = 0;
      (surface.Points()(domain, Eigen::all).rowwise() - image)
        .rowwise()
        .squaredNorm()
        .minCoeff(&nearest);
      result.Orbits(point) = domain[nearest];
    }
  }
}

} // namespace

// 1. The group, on a coarse surface. It always has as many points, as evenly spread: a surface with
//    fewer than twice as many is bisected first.
// 2. Its elements on the surface itself, or on a finer coarse surface.
// 3. The quotient.
SymmetryResult FindSymmetries(
  const Surface& given, const SymmetryOptions& options, const Progress& progress)
{
  const CompactSurface compact(given, "the surface");
  const Surface& surface = compact.Surface;
  RequireConnected(surface, "the surface");
  RequireOption(options.Tolerance > 0.0 && options.Tolerance <= 0.1, "Tolerance", options.Tolerance,
    "positive and at most 0.1");
  RequireOption(options.MaximumOrder >= 1, "MaximumOrder", options.MaximumOrder, "at least 1");
  RequireOption(options.SearchPoints >= 100, "SearchPoints", options.SearchPoints, "at least 100");
  RequireOption(options.CoarsePoints >= 100, "CoarsePoints", options.CoarsePoints, "at least 100");

  const Surface bisected =
    Bisect(surface, 2 * std::min(options.SearchPoints, options.CoarsePoints));
  const CoarsePair fine(
    bisected, bisected, {}, options.CoarsePoints, progress.Part(0.0, 0.05, "coarsening"));
  const Surface& working = fine.A();
  std::vector<int> kept(working.Points().rows());
  std::iota(kept.begin(), kept.end(), 0);
  Surface coarse = working;
  if (static_cast<int>(kept.size()) > options.SearchPoints)
  {
    CoarseSurface coarsened =
      CoarsenSurface(working, options.SearchPoints, {}, progress.Part(0.05, 0.1, "coarsening"));
    kept = coarsened.Points;
    coarse = coarsened.Surface;
  }
  const PointSymmetries found =
    FindPointSymmetries(coarse, options.Tolerance, options.MaximumOrder, progress.Part(0.1, 0.5));

  SymmetryResult result;
  result.Composition = found.Composition;
  result.Bound = found.Bound;
  result.Rejected = found.Rejected;
  const auto order = static_cast<int>(found.Elements.size());
  std::optional<SelfMaps> maps;
  if (order > 1)
  {
    maps.emplace(working, progress.Part(0.5, 0.6, "computing the eigenfunctions"));
  }
  const Progress refining = progress.Part(0.6, 0.9, "refining the symmetries");
  for (int i = 0; i < order; ++i)
  {
    const Progress part = refining.Part(double(i) / order, (i + 1.0) / order);
    Symmetry element;
    SurfacePoints map;
    if (i == 0)
    {
      element.Map = MakeSurfacePointsAtVertices(Eigen::VectorXi::LinSpaced(surface.Points().rows(),
                                                  0, static_cast<int>(surface.Points().rows()) - 1),
        surface);
    }
    else
    {
      const Eigen::VectorXi& images = found.Elements[i].Images;
      std::vector<int> to;
      for (const int image : images)
      {
        to.push_back(kept[image]);
      }
      map = maps->Refine(maps->Fit(kept, to, part.Part(0.0, 0.4)), part.Part(0.4, 0.8));
      element.Distortion = found.Elements[i].Distortion;
      const SurfaceMaps both{ map, map };
      element.Reversing = EvaluateMaps(working, working, both).ReversedArea > 0.5;
      map = fine.OnFine(both, part.Part(0.8, 1.0)).AToB;
      element.Map = FindMapOfGiven(surface, bisected, map);
    }
    element.Order = FindOrder(result.Composition, i);
    element.Generator = std::count(found.Generators.begin(), found.Generators.end(), i) > 0;
    if (element.Reversing && element.Order == 2)
    {
      element.Fixed = FindFixedCurves(bisected, map);
    }
    result.Elements.push_back(std::move(element));
  }
  progress.Part(0.9, 1.0, "dividing the surface")(0.0);
  DivideByGroup(surface, result);
  // Back to the given points and triangles.
  const Eigen::MatrixXd copies = compact.Expand(Eigen::MatrixXd(result.Copies.cast<double>())),
                        orbits = compact.Expand(Eigen::MatrixXd(result.Orbits.cast<double>()));
  result.Copies = copies.col(0).cast<int>();
  result.Orbits = orbits.col(0).cast<int>().unaryExpr([&](int i) { return compact.Points[i]; });
  for (Symmetry& element : result.Elements)
  {
    element.Map = compact.Expand(element.Map);
  }
  progress(1.0);
  return result;
}

Eigen::MatrixXd Symmetrize(
  const SymmetryResult& symmetries, const Eigen::MatrixXi& triangles, const Eigen::MatrixXd& values)
{
  Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(values.rows(), values.cols());
  for (const Symmetry& element : symmetries.Elements)
  {
    mean +=
      PullBack(element.Map, triangles, values) / static_cast<double>(symmetries.Elements.size());
  }
  return mean;
}

} // namespace shape
