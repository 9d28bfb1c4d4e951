#include "Hex/Grid/Private/SeparateSolids.h"

#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Solids/Nesting.h"
#include "Solids/SolidBoundary.h"

#include <algorithm>
#include <cstddef>

namespace shape
{
namespace
{

void Append(Mesh& mesh, const Mesh& other)
{
  const Eigen::Index points = mesh.Points.rows(), triangles = mesh.Triangles.rows();
  mesh.Points.conservativeResize(points + other.Points.rows(), 3);
  mesh.Points.bottomRows(other.Points.rows()) = other.Points;
  mesh.Triangles.conservativeResize(triangles + other.Triangles.rows(), 3);
  mesh.Triangles.bottomRows(other.Triangles.rows()) =
    other.Triangles.array() + static_cast<int>(points);
}

/// Appends rows of indices, each increased by an offset.
void Append(Eigen::MatrixXi& numbers, const Eigen::MatrixXi& others, Eigen::Index offset)
{
  const Eigen::Index rows = numbers.rows();
  numbers.conservativeResize(rows + others.rows(), others.cols());
  numbers.bottomRows(others.rows()) = others.array() + static_cast<int>(offset);
}

void Append(Eigen::VectorXi& numbers, const Eigen::VectorXi& others, Eigen::Index offset)
{
  const Eigen::Index rows = numbers.size();
  numbers.conservativeResize(rows + others.size());
  numbers.tail(others.size()) = others.array() + static_cast<int>(offset);
}

/// A component of a surface.
struct Component
{
  Mesh Boundary;
  std::vector<int> Triangles; ///< of the whole surface
  double Volume;              ///< negative for a void
};

std::vector<Component> FindComponents(const Surface& surface)
{
  std::vector<Component> components;
  for (Mesh& mesh : SplitComponents(surface))
  {
    const double volume = ComputeEnclosedVolume(mesh);
    components.push_back({ std::move(mesh), {}, volume });
  }
  const Eigen::VectorXi& componentOf = surface.Topology().ComponentId;
  for (int t = 0; t < static_cast<int>(surface.Triangles().rows()); ++t)
  {
    components[componentOf(surface.Triangles()(t, 0))].Triangles.push_back(t);
  }
  return components;
}

} // namespace

std::vector<SeparateSolid> SplitSolids(const Surface& surface, const Progress& progress)
{
  const Surface outward = OrientOutwards(surface);
  if (RequireClosedSurface(outward, "the surface").Components == 1 ||
    ExtractSolidBoundary(outward, progress.Part(0.0, 0.5)).Crossings > 0 ||
    OrientByNesting(outward, "the surface", progress.Part(0.5, 1.0)).Triangles() !=
      outward.Triangles())
  {
    return {};
  }
  std::vector<Component> outer, voids;
  for (Component& component : FindComponents(outward))
  {
    (component.Volume > 0.0 ? outer : voids).push_back(std::move(component));
  }
  if (outer.size() < 2)
  {
    return {};
  }
  // In ascending order, so that the first solid found around a void is the innermost.
  std::sort(outer.begin(), outer.end(),
    [](const Component& a, const Component& b) { return a.Volume < b.Volume; });
  std::vector<Component> whole = outer;
  for (const Component& hole : voids)
  {
    const auto around = std::find_if(outer.begin(), outer.end(),
      [&](const Component& solid)
      {
        // The winding number is 1 inside and 0 outside, up to rounding.
        constexpr double half = 0.5;
        return ComputeWindingNumber(solid.Boundary.Points, solid.Boundary.Triangles,
                 hole.Boundary.Points.row(0)) > half;
      });
    Component& into = whole[around - outer.begin()];
    Append(into.Boundary, hole.Boundary);
    into.Triangles.insert(into.Triangles.end(), hole.Triangles.begin(), hole.Triangles.end());
  }
  std::vector<SeparateSolid> solids;
  for (Component& component : whole)
  {
    solids.push_back({ Surface(std::move(component.Boundary)), std::move(component.Triangles) });
  }
  return solids;
}

HexFit JoinFits(const std::vector<HexFit>& fits)
{
  HexFit joined = fits.front();
  const auto count = [](const HexFit& fit) { return fit.Solid.Hexahedra.rows(); };
  double sum = joined.MeanScaledJacobian * static_cast<double>(count(joined));
  for (std::size_t i = 1; i < fits.size(); ++i)
  {
    const HexFit& fit = fits[i];
    const Eigen::Index points = joined.Solid.Points.rows();
    joined.Solid.Points.conservativeResize(points + fit.Solid.Points.rows(), 3);
    joined.Solid.Points.bottomRows(fit.Solid.Points.rows()) = fit.Solid.Points;
    Append(joined.Solid.Hexahedra, fit.Solid.Hexahedra, points);
    Append(joined.Core, fit.Core, points);
    Append(joined.Quads, fit.Quads, points);
    Append(joined.PatchOf, fit.PatchOf, joined.PatchOf.maxCoeff() + 1);
    Append(joined.RegionOf, fit.RegionOf, 0);
    joined.MinimumScaledJacobian =
      std::min(joined.MinimumScaledJacobian, fit.MinimumScaledJacobian);
    // The mean is weighted by the number of hexahedra.
    sum += fit.MeanScaledJacobian * static_cast<double>(count(fit));
    joined.Inverted += fit.Inverted;
    joined.Released += fit.Released;
    joined.Distance = std::max(joined.Distance, fit.Distance);
    joined.CreasesKept = joined.CreasesKept && fit.CreasesKept;
    joined.Followed.insert(joined.Followed.end(), fit.Followed.begin(), fit.Followed.end());
    joined.Creases.Distance = std::max(joined.Creases.Distance, fit.Creases.Distance);
    for (const int point : fit.Creases.CornerPoints)
    {
      joined.Creases.CornerPoints.push_back(static_cast<int>(points) + point);
    }
  }
  joined.MeanScaledJacobian = sum / static_cast<double>(count(joined));
  return joined;
}

SurfaceFeatures JoinFeatures(
  const std::vector<SurfaceFeatures>& features, const std::vector<Surface>& solids)
{
  SurfaceFeatures joined;
  int points = 0;
  for (std::size_t i = 0; i < features.size(); ++i)
  {
    Append(joined.PatchOf, features[i].PatchOf, joined.Patches);
    for (FeatureCurve curve : features[i].Curves)
    {
      for (int& point : curve.Points)
      {
        point += points;
      }
      for (int& patch : curve.Patches)
      {
        patch += joined.Patches;
      }
      joined.Curves.push_back(std::move(curve));
    }
    for (const int corner : features[i].Corners)
    {
      joined.Corners.push_back(corner + points);
    }
    joined.CreaseLength += features[i].CreaseLength;
    joined.CurveLength += features[i].CurveLength;
    joined.Patches += features[i].Patches;
    points += static_cast<int>(solids[i].Points().rows());
  }
  return joined;
}

std::vector<double> ComputeVolumeShares(const std::vector<Surface>& solids)
{
  // The total for all solids that are small.
  constexpr double small = 0.25;
  std::vector<double> shares;
  double sum = 0.0;
  for (const Surface& solid : solids)
  {
    shares.push_back(ComputeEnclosedVolume(solid));
    sum += shares.back();
  }
  double all = 0.0;
  for (double& share : shares)
  {
    share = std::max(share / sum, small / static_cast<double>(solids.size()));
    all += share;
  }
  for (double& share : shares)
  {
    share /= all;
  }
  return shares;
}

} // namespace shape
