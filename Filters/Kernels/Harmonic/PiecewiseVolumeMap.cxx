#include "Harmonic/PiecewiseVolumeMap.h"

#include "Base/Errors.h"
#include "Harmonic/HarmonicVolumeMap.h"
#include "Mesh/Extent.h"
#include "Mesh/Topology.h"
#include "Mesh/UsedPoints.h"
#include "Search/ClosestPoint.h"
#include "Solids/Nesting.h"
#include "Solids/SolidRegions.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace shape
{

namespace
{

/// A surface with the image of each of its points.
struct Mapped
{
  Mesh Surface;
  Eigen::MatrixXd Targets;
};

void Append(Mapped& all, const Mapped& part)
{
  all.Surface = JoinMeshes({ all.Surface, part.Surface });
  const Eigen::Index before = all.Targets.rows();
  all.Targets.conservativeResize(before + part.Targets.rows(), 3);
  all.Targets.bottomRows(part.Targets.rows()) = part.Targets;
}

Mapped Nothing()
{
  return { { Eigen::MatrixXd(0, 3), Eigen::MatrixXi(0, 3) }, Eigen::MatrixXd(0, 3) };
}

/// Divides every triangle into four at the midpoints of its edges.
Mesh Refined(const Mesh& mesh)
{
  std::map<std::pair<int, int>, int> midpoints;
  std::vector<std::pair<int, int>> edges;
  const auto n = static_cast<int>(mesh.Points.rows());
  const auto midpoint = [&](int a, int b)
  {
    // The two triangles of an edge share its midpoint.
    const auto [found, isNew] =
      midpoints.try_emplace(std::minmax(a, b), n + static_cast<int>(edges.size()));
    if (isNew)
    {
      edges.push_back(std::minmax(a, b));
    }
    return found->second;
  };
  Mesh refined;
  refined.Triangles.resize(4 * mesh.Triangles.rows(), 3);
  for (Eigen::Index t = 0; t < mesh.Triangles.rows(); ++t)
  {
    const Eigen::RowVector3i corner = mesh.Triangles.row(t);
    const int a = midpoint(corner(1), corner(2)), b = midpoint(corner(2), corner(0));
    const int c = midpoint(corner(0), corner(1));
    refined.Triangles.middleRows<4>(4 * t) << corner(0), c, b, c, corner(1), a, b, a, corner(2), a,
      b, c;
  }
  refined.Points.resize(n + static_cast<Eigen::Index>(edges.size()), 3);
  refined.Points.topRows(n) = mesh.Points;
  for (std::size_t e = 0; e < edges.size(); ++e)
  {
    refined.Points.row(n + static_cast<Eigen::Index>(e)) =
      0.5 * (mesh.Points.row(edges[e].first) + mesh.Points.row(edges[e].second));
  }
  return refined;
}

/// One layer of a solid: the surfaces that bound it, with the images of their points.
struct Layer
{
  int Region = 0;
  int Parent = -1;           ///< index of the layer around it, -1 for none
  Mapped Around;             ///< the outer surface, facing outwards
  Mapped Within = Nothing(); ///< borders of the layers inside, and walls of voids
  Mapped Voids = Nothing();  ///< the walls of voids alone
};

std::vector<Layer> FindLayers(const std::vector<ExactSurface>& surfaces, const Progress& progress)
{
  std::vector<Surface> meshes;
  std::vector<std::string> names;
  for (const ExactSurface& surface : surfaces)
  {
    RequireClosedSurface(surface.Surface, surface.Name);
    RequireFinite(surface.Targets, "the list of images of " + surface.Name);
    if (surface.Targets.rows() != surface.Surface.Points().rows() || surface.Targets.cols() != 3)
    {
      throw InvalidInput(surface.Name + " has " + std::to_string(surface.Surface.Points().rows()) +
        " points and " + std::to_string(surface.Targets.rows()) +
        " images; give each point one image of three coordinates");
    }
    meshes.push_back(surface.Surface);
    names.push_back(surface.Name);
  }
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    for (std::size_t j = i + 1; j < meshes.size(); ++j)
    {
      // Throws if the two surfaces touch or cross; its result is not needed.
      OrientByNesting(JoinMeshes({ meshes[i], meshes[j] }),
        "the union of " + names[i] + " and " + names[j], progress);
    }
  }
  // Pieces come from the outside inwards, so the layer around a piece is known.
  const SolidRegions regions(meshes, names, progress);
  const std::vector<SolidRegions::Component>& pieces = regions.Pieces();
  std::vector<Layer> layers;
  std::vector<int> layerOf(pieces.size(), -1);
  int next = static_cast<int>(surfaces.size());
  std::vector<bool> taken(surfaces.size(), false);
  for (std::size_t i = 0; i < pieces.size(); ++i)
  {
    const SolidRegions::Component& piece = pieces[i];
    const ExactSurface& owner = surfaces[piece.Owner];
    const Eigen::VectorXi& ids = owner.Surface.Topology().ComponentId;
    std::vector<int> rows;
    for (int p = 0; p < ids.size(); ++p)
    {
      if (ids(p) == ids(piece.FirstPoint))
      {
        rows.push_back(p);
      }
    }
    const Mapped mapped{ piece.Surface, owner.Targets(rows, Eigen::all) };
    const int parent = piece.Parent == -1 ? -1 : layerOf[piece.Parent];
    if (parent != -1)
    {
      Append(layers[parent].Within, mapped);
    }
    if (piece.Region == SolidRegions::Void)
    {
      Append(layers[parent].Voids, mapped);
      continue;
    }
    if (parent == -1 && i > 0)
    {
      throw InvalidInput("the boundary bounds several solids that do not touch; separate them "
                         "with Connectivity and map each of them alone");
    }
    Layer layer;
    // The first piece of a region keeps its number; further pieces are numbered after the surfaces.
    layer.Region = taken[piece.Region] ? next++ : piece.Region;
    taken[piece.Region] = true;
    layer.Parent = parent;
    layer.Around = mapped;
    layerOf[i] = static_cast<int>(layers.size());
    layers.push_back(std::move(layer));
  }
  return layers;
}

/// Joins the surfaces of all layers; each triangle gets the region that it encloses.
PiecewiseCharges WithoutCharges(const std::vector<Layer>& layers)
{
  PiecewiseCharges charges;
  charges.Maps.resize(layers.size());
  Mapped all = Nothing();
  std::vector<std::pair<Eigen::Index, int>> runs;
  for (const Layer& layer : layers)
  {
    Append(all, layer.Around);
    runs.emplace_back(layer.Around.Surface.Triangles.rows(), layer.Region);
    Append(all, layer.Voids);
    runs.emplace_back(layer.Voids.Surface.Triangles.rows(), PiecewiseCharges::Void);
  }
  charges.Regions.resize(all.Surface.Triangles.rows());
  charges.Surface = std::move(all.Surface);
  Eigen::Index first = 0;
  for (const auto& [count, region] : runs)
  {
    charges.Regions.segment(first, count).setConstant(region);
    first += count;
  }
  charges.Skins = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(layers.size()));
  return charges;
}

VolumeFeatures Select(const VolumeFeatures& features, const Eigen::VectorXi& regions, int region)
{
  std::vector<int> rows;
  for (int i = 0; i < regions.size(); ++i)
  {
    if (regions(i) == region)
    {
      rows.push_back(i);
    }
  }
  VolumeFeatures selected{ features.Points(rows, Eigen::all), features.Targets(rows, Eigen::all),
    {} };
  if (features.Weights.size() > 0)
  {
    selected.Weights = features.Weights(rows);
  }
  return selected;
}

/// Input of the fit of one layer's map, and samples that measure its jump.
struct LayerProblem
{
  Mapped Boundary;
  VolumeFeatures Features;
  Eigen::MatrixXd Positions; ///< random positions on the layer's outer border
  Eigen::MatrixXd Wanted;    ///< values of the outer map at these positions
};

/// Returns the maximum thickness of the skin inside a border. The map of the outer layer must be
/// valid there, and the skins of inner borders must not overlap it.
double ThickestSkin(const Layer& layer, double chargesDistance)
{
  double gap = chargesDistance;
  if (layer.Within.Surface.Points.rows() > 0)
  {
    gap = std::min(gap,
      SurfaceLocator(layer.Around.Surface).Find(layer.Within.Surface.Points).Distances.minCoeff());
  }
  return 0.5 * gap;
}

/// Returns the errors of a map at a surface whose images are given.
PiecewiseVolumeMapResult::Border ErrorsAt(const Mapped& surface, const ChargeSet& map, double size)
{
  const Eigen::VectorXd vertices =
    (Evaluate(map, surface.Surface.Points) - surface.Targets).rowwise().norm() / size;
  const Eigen::VectorXd inside = (Evaluate(map, ComputeOffCentres(surface.Surface)) -
                                   InterpolateAtOffCentres(surface.Surface, surface.Targets))
                                   .rowwise()
                                   .norm() /
    size;
  PiecewiseVolumeMapResult::Border border;
  border.RMSEVertices = std::sqrt(vertices.squaredNorm() / vertices.size());
  border.RMSEInside = std::sqrt(inside.squaredNorm() / inside.size());
  border.Maximum = std::max(vertices.maxCoeff(), inside.maxCoeff());
  return border;
}

} // namespace

PiecewiseVolumeMapResult ComputePiecewiseVolumeMap(const Surface& boundary,
  const Eigen::MatrixXd& targets, const std::vector<ExactSurface>& surfaces,
  const VolumeFeatures& features, const HarmonicVolumeMapOptions& options,
  const PiecewiseVolumeMapOptions& layered, const Progress& progress)
{
  if (layered.InterfaceRefinement < 0 || !(layered.SkinPerJump >= 0.0))
  {
    throw InvalidInput("InterfaceRefinement and SkinPerJump must not be negative");
  }
  // Outline:
  // 1. The surfaces are divided into layers, from the outside inwards.
  // 2. Each feature is assigned to the layer that contains it.
  // 3. For each layer the boundary values are collected: given images, but at its outer border the
  //    values of the map around it.
  // 4. The layer's harmonic map is fitted.
  // 5. The jump between both maps at the border determines the thickness of the skin.
  std::vector<ExactSurface> all{ { boundary, targets, "the Boundary" } };
  all.insert(all.end(), surfaces.begin(), surfaces.end());
  // Step 1: layers.
  const std::vector<Layer> layers = FindLayers(all, progress.Part(0.0, 0.05));
  const auto count = static_cast<int>(layers.size());

  PiecewiseVolumeMapResult result;
  result.Charges = WithoutCharges(layers);
  result.Layers.resize(count);
  result.Borders.resize(count);
  result.OffsetDistance = 1.0;
  const PiecewiseHarmonicMap positions(result.Charges, progress.Part(0.05, 0.1));
  // Step 2: features.
  const Eigen::VectorXi featureRegions = positions.RegionsAt(features.Points);
  const double size = ComputeLongestBoxEdge(boundary), targetSize = ComputeLongestBoxEdge(targets);
  // offsets of the nearest charges, in the order of the layers
  std::vector<double> offsets(count, 0.0);
  double featureSquares = 0.0;
  for (int i = 0; i < count; ++i)
  {
    const Progress part = progress.Part(0.1 + 0.9 * i / count, 0.1 + 0.9 * (i + 1) / count);
    const Layer& layer = layers[i];
    // Step 3: boundary values.
    LayerProblem problem{ layer.Around, Select(features, featureRegions, layer.Region), {}, {} };
    const ChargeSet* around =
      layer.Parent < 0 ? nullptr : &result.Charges.Maps[layers[layer.Parent].Region];
    if (around)
    {
      for (int k = 0; k < layered.InterfaceRefinement; ++k)
      {
        problem.Boundary.Surface = Refined(problem.Boundary.Surface);
      }
      problem.Boundary.Targets = Evaluate(*around, problem.Boundary.Surface.Points);
      // Positions where the jump is measured, about one for each triangle.
      constexpr int fewest = 2000;
      problem.Positions = SampleRandomly(layer.Around.Surface,
        std::max(fewest, static_cast<int>(layer.Around.Surface.Triangles.rows())), options.Seed);
      problem.Wanted = Evaluate(*around, problem.Positions);
    }
    // Inner borders and walls of voids have given images.
    Append(problem.Boundary, layer.Within);
    // Step 4: the fit.
    HarmonicVolumeMapResult& own = result.Layers[layer.Region];
    own = ComputeHarmonicVolumeMap(
      problem.Boundary.Surface, problem.Boundary.Targets, problem.Features, options, part);
    offsets[i] = own.OffsetDistance * ComputeLongestBoxEdge(problem.Boundary.Surface.Points);
    result.OffsetDistance = std::min(result.OffsetDistance, offsets[i] / size);
    PiecewiseVolumeMapResult::Border& border = result.Borders[layer.Region];
    Mapped surface = layer.Around;
    Append(surface, layer.Parent < 0 ? layer.Voids : Nothing());
    // Values at an inner border come from the map around it, because the skin blends on the inside.
    border = ErrorsAt(surface, around ? *around : own.Map, targetSize);
    if (around)
    {
      // Step 5: the skin.
      const Eigen::VectorXd jumps =
        (problem.Wanted - Evaluate(own.Map, problem.Positions)).rowwise().norm() / targetSize;
      border.JumpRMS = std::sqrt(jumps.squaredNorm() / jumps.size());
      border.JumpMaximum = jumps.maxCoeff();
      result.Charges.Skins(layer.Region) = std::min(layered.SkinPerJump * border.JumpMaximum * size,
        ThickestSkin(layer, offsets[layer.Parent]));
    }
    featureSquares +=
      (Evaluate(own.Map, problem.Features.Points) - problem.Features.Targets).squaredNorm() /
      (targetSize * targetSize);
    result.Charges.Maps[layer.Region] = own.Map;
  }
  result.Charges.Farthest = ComputeFarthest(result.OffsetDistance, boundary.Points());
  if (features.Points.rows() > 0)
  {
    result.RMSEFeatures = std::sqrt(featureSquares / features.Points.rows());
  }
  progress(1.0);
  return result;
}

} // namespace shape
