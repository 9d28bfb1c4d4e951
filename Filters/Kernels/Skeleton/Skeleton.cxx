#include "Skeleton/Skeleton.h"

#include "Base/Errors.h"
#include "Distance/SignedDistance.h"
#include "Mesh/Extent.h"
#include "Remesh/IsotropicRemesh.h"
#include "Skeleton/Private/Contraction.h"
#include "Skeleton/Private/CurveSurgery.h"
#include "Skeleton/Private/MedialBalls.h"
#include "Skeleton/Private/SkeletonBranches.h"
#include "Solids/Nesting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>

namespace shape
{
namespace
{

/// The Resolution, if it is automatic, as a share of the box's diagonal.
constexpr double AutomaticShare = 0.01;
/// The most points of the remeshed surface, so that memory and time remain bounded.
constexpr double MostPoints = 20000.0;
/// The length of edges that the contraction collapses, as a share of those of the remeshed surface:
/// the paper has 0.002 of the diagonal.
constexpr double ShortestShare = 0.2;
/// The share of the points whose medial balls are smaller than "thin".
constexpr double ThinQuantile = 0.1;

/// Returns the surface with points in the order of their coordinates and triangles in the order of
/// their points, so that the result does not depend on numbers.
Mesh SortMesh(const Mesh& mesh)
{
  std::vector<int> order(mesh.Points.rows());
  std::iota(order.begin(), order.end(), 0);
  const auto key = [&](int i) {
    return std::array<double, 3>{ mesh.Points(i, 0), mesh.Points(i, 1), mesh.Points(i, 2) };
  };
  std::sort(order.begin(), order.end(), [&](int a, int b) { return key(a) < key(b); });
  Mesh sorted{ Eigen::MatrixXd(mesh.Points.rows(), 3), mesh.Triangles };
  std::vector<int> number(order.size());
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    number[order[i]] = static_cast<int>(i);
    sorted.Points.row(static_cast<Eigen::Index>(i)) = mesh.Points.row(order[i]);
  }
  std::vector<std::array<int, 3>> triangles;
  for (const auto& row : mesh.Triangles.rowwise())
  {
    std::array<int, 3> corners = { number[row(0)], number[row(1)], number[row(2)] };
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    triangles.push_back(corners);
  }
  std::sort(triangles.begin(), triangles.end());
  for (std::size_t t = 0; t < triangles.size(); ++t)
  {
    sorted.Triangles.row(static_cast<Eigen::Index>(t)) << triangles[t][0], triangles[t][1],
      triangles[t][2];
  }
  return sorted;
}

/// Returns the components, facing outwards. Throws InvalidInput if one lies inside another.
std::vector<Mesh> SeparateSolids(const Surface& surface, const Progress& progress)
{
  const Surface oriented = OrientByNesting(surface, "the surface", progress);
  std::vector<Mesh> solids = SplitComponents(oriented);
  const auto hollow = std::find_if(solids.begin(), solids.end(),
    [](const Mesh& solid) { return ComputeEnclosedVolume(solid) < 0.0; });
  if (hollow != solids.end())
  {
    throw InvalidInput("component " + std::to_string(hollow - solids.begin()) +
      " of the surface bounds a void in another one, and the skeleton of a hollow solid is not a "
      "curve; remove the inner surface, such as with Connectivity and Threshold");
  }
  return solids;
}

/// Returns an even mesh of the surface that is fine enough for its thin parts.
Mesh RemeshFinely(const Surface& surface, double resolution, const Progress& progress)
{
  const double finest = std::sqrt(ComputeArea(surface) / (0.5 * std::sqrt(3.0) * MostPoints));
  IsotropicRemeshOptions options;
  options.EdgeLength = std::max(resolution, finest);
  Mesh mesh = RemeshIsotropically(surface, options, progress.Part(0.0, 0.4));
  Eigen::VectorXd radii = ShrinkMedialBalls(mesh, progress.Part(0.4, 0.5)).Radii;
  std::sort(radii.begin(), radii.end());
  const double thin = radii(static_cast<Eigen::Index>(ThinQuantile * (radii.size() - 1.0)));
  const double wanted = std::max({ 0.6 * thin, 0.5 * resolution, finest });
  if (wanted < 0.9 * options.EdgeLength)
  {
    options.EdgeLength = wanted;
    mesh = RemeshIsotropically(surface, options, progress.Part(0.5, 1.0));
  }
  progress(1.0);
  return mesh;
}

CurveSkeleton ExtractOne(const Mesh& solid, double resolution, const CurveSkeletonOptions& options,
  const Progress& progress)
{
  const Surface surface = SortMesh(solid);
  const Mesh mesh =
    RemeshFinely(surface, resolution, progress.Part(0.0, 0.2, "remeshing the surface"));
  const MedialBalls balls =
    ShrinkMedialBalls(mesh, progress.Part(0.2, 0.25, "finding the medial axis"));
  ContractionOptions flow;
  flow.VelocityWeight = options.VelocityWeight;
  flow.MedialWeight = options.MedialWeight;
  flow.ShortestEdge =
    ShortestShare * std::sqrt(ComputeArea(mesh) / (0.5 * std::sqrt(3.0) * mesh.Points.rows()));
  const Mesh contracted =
    ContractSurface(mesh, balls.Centres, flow, progress.Part(0.25, 0.9, "contracting the surface"));
  const CurveGraph graph =
    CollapseToCurves(contracted, progress.Part(0.9, 0.97, "collapsing to curves"));
  CurveSkeleton skeleton = MakeBranches(graph, SignedDistance(surface), resolution);
  const int genus = (2 - surface.Topology().EulerNumber) / 2;
  if (skeleton.Components != 1 || skeleton.Cycles != genus)
  {
    throw SolveFailure("the skeleton has " + std::to_string(skeleton.Components) +
      " component(s) and " + std::to_string(skeleton.Cycles) +
      " cycle(s), but the solid has one component and genus " + std::to_string(genus) +
      "; lower Resolution");
  }
  return skeleton;
}

void Append(CurveSkeleton& all, const CurveSkeleton& part)
{
  const int first = static_cast<int>(all.Points.rows());
  const Eigen::Index count = first + part.Points.rows();
  all.Points.conservativeResize(count, 3);
  all.Radii.conservativeResize(count);
  all.Degrees.conservativeResize(count);
  all.Points.bottomRows(part.Points.rows()) = part.Points;
  all.Radii.tail(part.Radii.size()) = part.Radii;
  all.Degrees.tail(part.Degrees.size()) = part.Degrees;
  for (std::vector<int> branch : part.Branches)
  {
    std::transform(
      branch.begin(), branch.end(), branch.begin(), [&](int point) { return point + first; });
    all.Branches.push_back(branch);
  }
  all.Components += part.Components;
  all.Cycles += part.Cycles;
  all.OutsidePoints += part.OutsidePoints;
}

/// Sorts solids by their lowest points, in the order of coordinates.
void SortSolids(std::vector<Mesh>& solids)
{
  const auto lowest = [](const Mesh& solid)
  {
    std::array<double, 3> low = { INFINITY, INFINITY, INFINITY };
    for (const auto& point : solid.Points.rowwise())
    {
      low = std::min(low, { point(0), point(1), point(2) });
    }
    return low;
  };
  std::stable_sort(solids.begin(), solids.end(),
    [&](const Mesh& a, const Mesh& b) { return lowest(a) < lowest(b); });
}

} // namespace

CurveSkeleton ExtractCurveSkeleton(
  const Surface& surface, const CurveSkeletonOptions& options, const Progress& progress)
{
  RequireOption(std::isfinite(options.Resolution) && options.Resolution >= 0.0, "Resolution",
    options.Resolution, "at least 0 and finite");
  RequireOption(options.VelocityWeight >= 1e-3 && options.VelocityWeight <= 1e3, "Velocity Weight",
    options.VelocityWeight, "between 0.001 and 1000");
  RequireOption(options.MedialWeight >= 0.0 && options.MedialWeight <= 1e3, "Medial Weight",
    options.MedialWeight, "between 0 and 1000");
  RequireClosedSurface(surface, "the surface");
  const double resolution = options.Resolution > 0.0
    ? options.Resolution
    : AutomaticShare * ComputeBoxDiagonal(surface.AsMesh());
  std::vector<Mesh> solids = SeparateSolids(surface, progress.Part(0.0, 0.05));
  SortSolids(solids);
  CurveSkeleton skeleton;
  skeleton.Points.resize(0, 3);
  const double count = static_cast<double>(solids.size());
  for (std::size_t i = 0; i < solids.size(); ++i)
  {
    Append(skeleton,
      ExtractOne(solids[i], resolution, options,
        progress.Part(0.05 + 0.95 * i / count, 0.05 + 0.95 * (i + 1) / count)));
  }
  progress(1.0);
  return skeleton;
}

} // namespace shape
