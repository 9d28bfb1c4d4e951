#include "Hex/HexRemesh.h"

#include "Base/Errors.h"
#include "Base/FormatNumber.h"
#include "Hex/FacePatches.h"
#include "Hex/Grid/GridHexes.h"
#include "Hex/Grid/SizedHexes.h"
#include "Hex/Polycube/FlatShare.h"
#include "Hex/Polycube/PolycubeHexes.h"
#include "Hex/Private/HexQuality.h"
#include "Mesh/Extent.h"
#include "Mesh/Surface.h"
#include "Mesh/Topology.h"
#include "Solids/SolidBoundary.h"
#include "Solids/SolidVolume.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace shape
{
namespace
{

using MethodType = HexRemeshOptions::MethodType;

/// Snapping seldom brings a polycube from farther than this, as a fraction of the diagonal, to
/// AcceptedDistance: a grid is tried first.
constexpr double SnappedDistance = 2.0 * AcceptedDistance;

/// Returns the options of one method.
template <typename MethodOptions>
MethodOptions OfMethod(const HexMeshOptions& options)
{
  MethodOptions own;
  static_cast<HexMeshOptions&>(own) = options;
  own.MaximumHexahedra = options.CellSize > 0.0 ? MaximumOfGivenSize : options.MaximumHexahedra;
  return own;
}

HexRemeshResult OfHexes(GridHexesResult result, const Progress& progress)
{
  HexRemeshResult hexes;
  hexes.Grid = FindHexGrid(result.Fit, {}, result.CellSize, progress);
  hexes.Fit = std::move(result.Fit);
  hexes.Features = std::move(result.Features);
  hexes.CellSize = result.CellSize;
  hexes.Crossings = result.Crossings;
  hexes.InnerCreasesKept = result.InnerCreasesKept;
  hexes.TopologyAgreed = result.TopologyAgreed;
  return hexes;
}

HexRemeshResult ByGrid(const Surface& surface, const HexRemeshOptions& options,
  const Progress& progress, const HexRemeshGuides& guides = {})
{
  auto grid = OfMethod<GridHexesOptions>(options);
  if (guides.Sizes.size() == 0)
  {
    return OfHexes(
      BuildGridHexahedra(surface, grid, progress, guides.InnerSurfaces), progress.Part(1.0, 1.0));
  }
  grid.MaximumHexahedra = MaximumOfGivenSize;
  SizedHexesResult sized =
    BuildSizedHexahedra(surface, guides.Sizes, grid, progress, guides.InnerSurfaces);
  HexRemeshResult result = OfHexes(std::move(sized.Hexes), progress.Part(1.0, 1.0));
  result.SizeRatios = std::move(sized.Ratios);
  return result;
}

/// Uses smaller cells if creases are farther than wanted, the maximum allows cells that are small
/// enough, and the distance falls: it is proportional to the square of the size.
PolycubeHexesResult WithNearCreases(const Surface& surface, PolycubeHexesOptions options,
  PolycubeHexesResult coarse, const Progress& progress)
{
  const HexFit& fit = coarse.Fit;
  const double wanted = GridHexesOptions().WantedCreaseDistance * ComputeBoxDiagonal(surface);
  if (!fit.CreasesKept || fit.MinimumScaledJacobian < AcceptedScaledJacobian ||
    fit.Creases.Distance <= wanted)
  {
    return coarse;
  }
  // Aims below the wanted distance, because the proportionality is only approximate.
  constexpr double safety = 0.8;
  const double needed = std::sqrt(safety * wanted / fit.Creases.Distance),
               minimum = std::cbrt(static_cast<double>(fit.Solid.Hexahedra.rows()) /
                 static_cast<double>(options.MaximumHexahedra));
  if (needed < minimum)
  {
    return coarse;
  }
  options.CellSize = coarse.CellSize * needed;
  options.NeedsCreases = true;
  try
  {
    PolycubeHexesResult fine = BuildPolycubeHexahedra(surface, options, progress);
    if (fine.Fit.CreasesKept && fine.Fit.MinimumScaledJacobian >= AcceptedScaledJacobian &&
      fine.Fit.Creases.Distance < fit.Creases.Distance)
    {
      return fine;
    }
  }
  catch (const SolveFailure&)
  {
    // There is no polycube of such cells; the coarse result is kept.
  }
  return coarse;
}

/// Snaps to the surface in the same way as BuildGridHexahedra, unless it is farther than
/// `farthest`.
void SnapIfFar(HexFit& fit, const Surface& surface, const Progress& progress,
  double farthest = std::numeric_limits<double>::infinity())
{
  SnappingOptions options;
  options.WantedDistance = GridHexesOptions().WantedDistance * ComputeBoxDiagonal(surface);
  if (fit.Inverted == 0 && fit.Distance > options.WantedDistance && fit.Distance <= farthest)
  {
    SnapToSurface(fit, surface, options, progress);
  }
}

/// Cells of a polycube, made smaller if creases are too far, then snapped (SnapIfFar).
HexRemeshResult ByPolycube(const Surface& surface, const HexRemeshOptions& options,
  const Progress& progress, double farthest = std::numeric_limits<double>::infinity())
{
  const auto polycube = OfMethod<PolycubeHexesOptions>(options);
  const bool isAutomatic = options.CellSize == 0.0;
  PolycubeHexesResult result = BuildPolycubeHexahedra(surface, polycube, progress.Part(0.0, 0.95));
  if (isAutomatic)
  {
    result = WithNearCreases(surface, polycube, std::move(result), progress.Part(0.95, 0.97));
  }
  SnapIfFar(result.Fit, surface, progress.Part(0.97, 1.0, "moving the boundary onto the surface"),
    farthest);
  const char* maps[] = {
    "mapped by the harmonic map of the polycube's boundary",
    "mapped by the map of tetrahedra onto the polycube, because the harmonic map of its boundary "
    "would invert more cells",
    "taken from a grid in the solid deformed towards the axes, because no better polycube was found"
  };
  HexRemeshResult hexes;
  hexes.Grid = FindHexGrid(
    result.Fit, result.CellSize * result.Positions, result.CellSize, progress.Part(1.0, 1.0));
  hexes.Fit = std::move(result.Fit);
  hexes.Features = std::move(result.Features);
  hexes.Method = MethodType::Polycube;
  hexes.Reason = std::string("its cells ") + maps[static_cast<int>(result.Map)];
  hexes.CellSize = result.CellSize;
  return hexes;
}

HexRemeshResult ByGivenPolycube(const Surface& surface, const HexRemeshOptions& options,
  const GivenPolycube& polycube, const Progress& progress)
{
  const GivenPolycubeCells cells = BuildPolycubeCells(polycube, surface, options.CellSize,
    OfMethod<HexMeshOptions>(options).MaximumHexahedra,
    progress.Part(0.0, 0.4, "mapping the polycube"));
  HexRemeshResult result;
  result.Method = MethodType::Polycube;
  result.CellSize = cells.CellSize;
  result.Features = FindFeatures(surface, options, cells.CellSize);
  result.Fit = FitHexahedra(
    cells.Solid, surface, result.Features, { options.PaddingLayers }, progress.Part(0.4, 0.9));
  result.Grid = FindHexGrid(result.Fit, cells.Positions, cells.Spacing, progress.Part(0.9, 0.9));
  SnapIfFar(result.Fit, surface, progress.Part(0.9, 1.0, "moving the boundary onto the surface"));
  result.Reason =
    "the Polycube is given; its cells are mapped by the harmonic map of its SourcePosition";
  return result;
}

/// Whether a polycube is likely to be good: it needs creases that its edges follow, or flat parts
/// that its faces follow.
bool SuitsPolycube(const Surface& surface, const HexRemeshOptions& options)
{
  constexpr double minimum = 0.25; // of the area; about that of a cube whose edges are rounded
  return !FindFeatures(surface, options, 0.0).Curves.empty() ||
    ComputeFlatShare(surface) >= minimum;
}

/// The hexahedra of a method, or why it gives none.
struct Attempt
{
  std::optional<HexRemeshResult> Result;
  std::string WhyNot;
};

Attempt TryGrid(const Surface& surface, const HexRemeshOptions& options, const Progress& progress)
{
  try
  {
    return { ByGrid(surface, options, progress), {} };
  }
  catch (const SolveFailure& failure)
  {
    return { std::nullopt, failure.what() };
  }
}

/// Is not snapped from farther than SnappedDistance.
Attempt TryPolycube(
  const Surface& surface, const HexRemeshOptions& options, const Progress& progress)
{
  try
  {
    return { ByPolycube(surface, options, progress, SnappedDistance * ComputeBoxDiagonal(surface)),
      {} };
  }
  catch (const SolveFailure& failure)
  {
    return { std::nullopt, failure.what() };
  }
  catch (const InvalidInput& failure) // by Tetrahedralize, which requires more than a grid
  {
    return { std::nullopt, failure.what() };
  }
}

/// Takes the better result, or the only one. Throws SolveFailure if there is none.
HexRemeshResult TakeBetter(Attempt polycube, Attempt grid, const Surface& surface,
  double nearCreases, const Progress& progress)
{
  if (!polycube.Result && !grid.Result)
  {
    throw SolveFailure(grid.WhyNot + "; no polycube: " + polycube.WhyNot);
  }
  if (!polycube.Result)
  {
    grid.Result->Reason = "no polycube: " + polycube.WhyNot;
    return std::move(*grid.Result);
  }
  const double diagonal = ComputeBoxDiagonal(surface);
  HexFit& fit = polycube.Result->Fit;
  if (grid.Result && !IsBetter(fit, grid.Result->Fit, nearCreases))
  {
    grid.Result->Reason = "better than the polycube, whose minimum scaled Jacobian is " +
      FormatNumber(fit.MinimumScaledJacobian) + ", at a distance from the surface of " +
      FormatNumber(fit.Distance / diagonal) + " of the diagonal" +
      (!fit.CreasesKept ? ", without the creases"
          : fit.Creases.Distance > nearCreases
          ? ", and from its creases of " + FormatNumber(fit.Creases.Distance / diagonal)
          : "");
    return std::move(*grid.Result);
  }
  if (fit.Distance > SnappedDistance * diagonal)
  {
    SnapIfFar(fit, surface, progress.Part(0.0, 1.0, "moving the boundary onto the surface"));
  }
  polycube.Result->Reason = (grid.Result ? "better than a grid" : "no grid (" + grid.WhyNot + ")") +
    ": a polycube with " + polycube.Result->Reason;
  return std::move(*polycube.Result);
}

/// A polycube is tried first: its hexahedra have few singular edges. A grid is built only if there
/// is no polycube or it is not good enough. If the surface has nothing that a polycube could
/// follow, a grid is tried first, and a polycube only if the grid is not good enough.
HexRemeshResult ByTheBetter(
  const Surface& surface, const HexRemeshOptions& options, const Progress& progress)
{
  const double diagonal = ComputeBoxDiagonal(surface);
  // Edges of a given size are as near to curved creases as that size allows: that is no reason for
  // another method.
  const double nearCreases = options.CellSize > 0.0 ? std::numeric_limits<double>::infinity()
                                                    : AcceptedCreaseDistance * diagonal;
  Attempt polycube, grid;
  const bool isGridFirst = !SuitsPolycube(surface, options);
  if (isGridFirst)
  {
    grid = TryGrid(surface, options, progress.Part(0.0, 0.8));
    if (grid.Result && IsGoodGrid(grid.Result->Fit, diagonal))
    {
      progress(1.0);
      grid.Result->Reason = "good, and the surface has neither creases nor flat parts that the "
                            "edges and faces of a polycube could follow";
      return std::move(*grid.Result);
    }
  }
  // Whether the other method follows is known only after the first: either way, progress is not far
  // off.
  polycube =
    TryPolycube(surface, options, isGridFirst ? progress.Part(0.8, 0.97) : progress.Part(0.0, 0.8));
  if (polycube.Result && IsGoodPolycube(polycube.Result->Fit, diagonal, nearCreases))
  {
    polycube.Result->Reason = "a polycube was found, with " + polycube.Result->Reason;
    return std::move(*polycube.Result);
  }
  if (!isGridFirst)
  {
    grid = TryGrid(surface, options, progress.Part(0.8, 0.97));
  }
  return TakeBetter(
    std::move(polycube), std::move(grid), surface, nearCreases, progress.Part(0.97, 1.0));
}

bool NeedsGrid(const HexRemeshGuides& guides)
{
  return guides.Sizes.size() > 0 || !guides.InnerSurfaces.empty();
}

/// Throws if options contradict the guides.
void RequireAgreement(
  const Surface& surface, const HexRemeshOptions& options, const HexRemeshGuides& guides)
{
  if (guides.Sizes.size() > 0)
  {
    RequireSizes(surface, guides.Sizes);
    if (options.CellSize > 0.0 || options.CellsOnLongestSide > 0)
    {
      throw InvalidInput("a SizeArray is given together with CellSize or CellsOnLongestSide; set "
                         "both options to 0, or give no SizeArray");
    }
  }
  if (NeedsGrid(guides) && options.Method == MethodType::Polycube)
  {
    throw InvalidInput("a SizeArray or InnerSurfaces need a grid; choose Method Automatic or Grid");
  }
  if (options.Draft &&
    (options.Method == MethodType::Polycube || guides.Polycube.Surface.Triangles.rows() > 0))
  {
    throw InvalidInput(
      "a Draft uses the cells of a grid; choose Method Automatic or Grid without a "
      "Polycube, or no Draft");
  }
  if (guides.Polycube.Surface.Triangles.rows() > 0 &&
    (NeedsGrid(guides) || options.Method == MethodType::Grid))
  {
    throw InvalidInput(
      "a Polycube is given, but Method Grid, a SizeArray and InnerSurfaces use the "
      "cells of a grid; disconnect the Polycube, or use none of the others");
  }
}

/// Throws if given patches do not fit the surface.
void RequirePatches(const Surface& surface, const Eigen::VectorXi& patches)
{
  if (patches.size() == 0)
  {
    return;
  }
  if (patches.size() != surface.Triangles().rows())
  {
    throw InvalidInput(std::to_string(patches.size()) + " patches are given for " +
      std::to_string(surface.Triangles().rows()) + " triangles; give one for each");
  }
  Eigen::Index at = 0;
  if (patches.minCoeff(&at) < 0)
  {
    throw InvalidInput("the given patch of triangle " + std::to_string(at) + " is " +
      std::to_string(patches(at)) + "; patches are numbers from 0");
  }
  if (const int crossings = ExtractSolidBoundary(surface).Crossings; crossings > 0)
  {
    throw InvalidInput("patches are given, but the surface intersects itself at " +
      std::to_string(crossings) +
      " pairs of triangles; mend it with Shape Solidify, or set PatchArray to None");
  }
}

/// Gives each quad of the boundary the number of its given patch.
void NumberAsGiven(HexFit& fit, const Surface& surface, const Eigen::VectorXi& patches)
{
  const Eigen::VectorXi nearest = FindNearestPatches(fit.Solid.Points, fit.Quads, surface, patches);
  // Without creases, a patch of the boundary lies on several given ones.
  fit.PatchOf = fit.CreasesKept ? TakeMostFrequent(nearest, fit.PatchOf) : nearest;
}

/// Finds the lost creases, also those of patches too small to be asked for, and names the longest.
void FindLostCreases(
  const Surface& surface, const HexRemeshOptions& options, HexRemeshResult& result)
{
  constexpr double tolerance = 1e-6; // of the diagonal: the lines have the same points
  result.LostCreases = FindUncovered(BuildCreaseLines(surface, FindFeatures(surface, options, 0.0)),
    result.Fit.Followed, tolerance * ComputeBoxDiagonal(surface));
  std::vector<CreaseLine>& lost = result.LostCreases;
  std::stable_sort(lost.begin(), lost.end(),
    [](const CreaseLine& a, const CreaseLine& b)
    { return ComputeLength({ a }) > ComputeLength({ b }); });
  if (!lost.empty())
  {
    const Eigen::RowVector3d at = FindMidpoint(lost.front());
    result.Reason += "; " + std::to_string(lost.size()) +
      (lost.size() == 1 ? " crease is lost, near (" : " creases are lost, the longest near (") +
      FormatNumber(at(0)) + ", " + FormatNumber(at(1)) + ", " + FormatNumber(at(2)) + ")";
  }
}

/// Chooses the method by the guides, the option, and whether the surface crosses itself.
HexRemeshResult Made(const Surface& surface, const HexRemeshOptions& options,
  const HexRemeshGuides& guides, const Progress& progress)
{
  if (guides.Polycube.Surface.Triangles.rows() > 0)
  {
    return ByGivenPolycube(surface, options, guides.Polycube, progress);
  }
  HexRemeshResult result;
  if (options.Method == MethodType::Polycube)
  {
    result = ByPolycube(surface, options, progress);
    result.Reason = "chosen as Method, with " + result.Reason;
    return result;
  }
  if (options.Method == MethodType::Grid || NeedsGrid(guides) || options.Draft)
  {
    result = ByGrid(surface, options, progress, guides);
    result.Reason = options.Method == MethodType::Grid ? "chosen as Method"
      : !NeedsGrid(guides)                             ? "a draft uses the cells of a grid"
      : guides.InnerSurfaces.empty()
      ? "a SizeArray is given, and the cells of a polycube cannot have given sizes"
      : "InnerSurfaces are given, and polycubes do not contain them";
    result.Reason += result.InnerCreasesKept ? "" : "; creases of InnerSurfaces are rounded";
    result.Reason +=
      options.Draft ? "; these are a draft: apply without Draft for better ones" : "";
    return result;
  }
  if (const int crossings =
        ExtractSolidBoundary(surface, progress.Part(0.0, 0.02, "checking the surface")).Crossings;
      crossings > 0)
  {
    result = ByGrid(surface, options, progress.Part(0.02, 1.0));
    result.Reason = "the surface intersects itself at " + std::to_string(crossings) +
      " pairs of triangles; the solid is the region with a winding number of at least 1" +
      (result.TopologyAgreed
          ? ""
          : ", and no two grids agree on its Euler number and number of components, "
            "so those of one grid are used");
    return result;
  }
  return ByTheBetter(surface, options, progress.Part(0.02, 1.0));
}

} // namespace

void RequireOneSize(const HexRemeshOptions& options)
{
  RequireOption(options.CellsOnLongestSide >= 0, "CellsOnLongestSide", options.CellsOnLongestSide,
    "positive, or 0 for none");
  if (options.CellSize > 0.0 && options.CellsOnLongestSide > 0)
  {
    throw InvalidInput("CellSize is " + FormatNumber(options.CellSize) +
      " and CellsOnLongestSide is " + std::to_string(options.CellsOnLongestSide) +
      ", but only one of them can give the size of the cells; set the other to 0");
  }
}

HexRemeshResult RemeshHexahedra(const Surface& surface, const HexRemeshOptions& given,
  const Progress& progress, const HexRemeshGuides& guides)
{
  RequireInRange(given);
  RequireOneSize(given);
  RequireClosedSurface(surface, "the surface");
  RequireVolume(surface, "the surface");
  RequireAgreement(surface, given, guides);
  RequirePatches(surface, given.Patches);
  HexRemeshOptions options = given;
  if (given.CellsOnLongestSide > 0)
  {
    options.CellSize = ComputeLongestBoxEdge(surface) / given.CellsOnLongestSide;
  }
  HexRemeshResult result = Made(surface, options, guides, progress);
  FindLostCreases(surface, options, result);
  if (result.Fit.Released > 0)
  {
    result.Reason += "; " + std::to_string(result.Fit.Released) +
      " boundary points left the surface, because hexahedra there would stay inverted or bad";
  }
  if (result.Fit.Inverted > 0)
  {
    throw SolveFailure(std::to_string(result.Fit.Inverted) +
      " hexahedra stay inverted; try another CellSize" +
      (options.Method == MethodType::Polycube ? ", or Method Grid" : ""));
  }
  if (given.Patches.size() > 0)
  {
    NumberAsGiven(result.Fit, surface, given.Patches);
  }
  return result;
}

} // namespace shape
