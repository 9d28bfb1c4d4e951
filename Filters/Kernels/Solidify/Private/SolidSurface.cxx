#include "Solidify/Private/SolidSurface.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Surface.h"
#include "Search/ClosestPoint.h"
#include "Solidify/Private/ClosedDraft.h"
#include "Solidify/Private/ContactSplit.h"
#include "Solidify/Private/GridSurface.h"
#include "Solidify/Private/JoinedSoup.h"
#include "Solidify/Private/SolidSampling.h"
#include "Solidify/Private/WindingBoundary.h"
#include "Solids/Nesting.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// A surface on its way to the boundary of a solid, and what it has in common with the input.
struct Stage
{
  Mesh Surface;
  shape::Provenance Provenance; ///< from the input
  std::vector<char> IsMade;     ///< for each triangle
};

/// Splits the triangles of a closed surface that cross others, and keeps those on the boundary of
/// the region with a winding number of at least 1.
Stage UniteParts(
  const Stage& closed, const std::vector<Crossing>& crossings, const Progress& progress)
{
  SplitContacts split =
    SplitAtContacts(closed.Surface, crossings, progress.Part(0.0, 0.4, "splitting triangles"));
  // The same points of different triangles are joined, which leaves some triangles without area.
  JoinedSoup soup = JoinSoup(split.Surface, 0.0, progress.Part(0.4, 0.5));
  MendedDraft draft{ std::move(soup.Surface), std::move(soup.Triangles), {} };
  SplitAtCollinearCorners(draft);
  const WindingBoundary boundary =
    ExtractWindingBoundary(draft.Surface, progress.Part(0.5, 1.0, "evaluating winding numbers"));
  Stage united;
  united.Surface = boundary.Surface;
  const Eigen::VectorXi triangles = Eigen::Map<const Eigen::VectorXi>(
    draft.Triangles.data(), static_cast<Eigen::Index>(draft.Triangles.size()));
  split.Provenance.Cells =
    ComposeIndices(split.Provenance.Cells, ComposeIndices(triangles, boundary.Parents));
  united.Provenance = Compose(closed.Provenance, split.Provenance);
  for (const int parent : split.Provenance.Cells)
  {
    united.IsMade.push_back(closed.IsMade[parent]);
  }
  return united;
}

/// The steps 1 and 2 of MakeSolid. first: the draft of the surface. Throws InvalidInput or
/// SolveFailure if they do not succeed.
MendedSurface MakeSolidOfDraft(const Mesh& surface, const OrientedDraft& first,
  const SurfaceDefectOptions& options, const Progress& progress)
{
  Stage stage{ surface, TraceIdentity(surface.Points.rows(), surface.Triangles.rows()),
    std::vector<char>(surface.Triangles.rows(), 0) };
  MendedSurface result;
  std::vector<Crossing> crossings;
  constexpr int rounds = 5;
  for (int round = 0; round < rounds; ++round)
  {
    const Progress part =
      progress.Part(round / static_cast<double>(rounds), (round + 1) / static_cast<double>(rounds));
    const OrientedDraft drafted = round == 0
      ? first
      : DraftSurface(stage.Surface, { 0.0, options.SmallestPiece }, part.Part(0.0, 0.3));
    const ClosedDraft closed = CloseDraft(drafted.Draft, part.Part(0.3, 0.4));
    result.SplitPoints += drafted.SplitPoints + closed.SplitPoints();
    result.RemovedPieces += drafted.RemovedPieces;
    result.ReversedTriangles += drafted.ReversedTriangles;
    result.GapsClosed += static_cast<int>(closed.Filled.Holes.size());
    stage.Provenance = Compose(stage.Provenance, TraceClosing(closed, stage.Surface.Points.rows()));
    std::vector<char> isMade(closed.Result.Triangles().rows(), 1);
    std::transform(closed.Draft.Triangles.begin(), closed.Draft.Triangles.end(), isMade.begin(),
      [&](int triangle) { return stage.IsMade[triangle]; });
    stage.IsMade = std::move(isMade);
    stage.Surface = closed.Result;
    crossings =
      FindSelfIntersections(closed.Result, part.Part(0.4, 0.5, "looking for self-intersections"));
    if (crossings.empty())
    {
      break;
    }
    if (round == 0)
    {
      stage.Surface = OrientCrossingPieces(closed.Result, part.Part(0.5, 0.6));
    }
    stage = UniteParts(stage, crossings, part.Part(0.6, 1.0));
    if (stage.Surface.Triangles.rows() == 0)
    {
      break;
    }
  }
  if (!crossings.empty())
  {
    throw SolveFailure("intersections remain after rounding"); // the grid takes over
  }
  const shape::Surface oriented = OrientByNesting(stage.Surface, "the solid");
  result.Surface = oriented;
  result.Provenance = stage.Provenance;
  result.Origin = FindOrigins(result.Surface, surface, stage.Provenance.Cells, stage.IsMade);
  std::vector<char> isUsed(surface.Triangles.rows(), 0);
  for (const int cell : stage.Provenance.Cells)
  {
    if (cell >= 0)
    {
      isUsed[cell] = 1;
    }
  }
  result.RemovedTriangles = static_cast<int>(std::count(isUsed.begin(), isUsed.end(), 0));
  if (!FindSurfaceDefects(result.Surface).Defects.empty())
  {
    throw SolveFailure("defects remain after rounding"); // the grid takes over
  }
  return result;
}

/// Step 3 of MakeSolid. oriented: the triangles, oriented if they can be.
MendedSurface MakeSolidOnGrid(const Mesh& surface, const Mesh& oriented,
  const SolidSurfaceOptions& options, const Progress& progress)
{
  const double spacing = ChooseDetailSize(oriented, options.DetailSize);
  const Mesh made = ContourWinding(
    CloseByCones(oriented), spacing, progress.Part(0.0, 0.6, "sampling winding numbers"));
  return AdoptGridSurface(
    made, spacing, surface, options.Defects.SmallestPiece, "the solid", progress.Part(0.6, 1.0));
}

/// The draft of a surface; none if it has no orientation of its own.
std::optional<OrientedDraft> TryDraft(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress)
{
  try
  {
    return DraftSurface(surface, options, progress);
  }
  catch (const InvalidInput&) // such as a piece with one side only
  {
    return std::nullopt;
  }
}

/// Throws NoSolid if the solid lacks parts of the triangles: positions on a hundredth or more
/// of their area that are neither in it nor within `near` of it.
void RequireParts(const Mesh& triangles, const Mesh& solid, double near, const Progress& progress)
{
  constexpr int count = 2000;
  constexpr double most = 0.01;
  const Eigen::MatrixXd positions = SampleRandomly(triangles, count, 1);
  const ClosestPoints nearest =
    SurfaceLocator(shape::Surface(solid)).Find(positions, progress.Part(0.0, 0.5));
  int lost = 0;
  for (Eigen::Index i = 0; i < positions.rows(); ++i)
  {
    progress(0.5 + 0.5 * static_cast<double>(i) / count);
    lost += nearest.Distances(i) > near &&
      ComputeWindingNumber(solid.Points, solid.Triangles, positions.row(i)) < 0.5;
  }
  if (lost >= most * count)
  {
    throw NoSolid("the solid lacks " + std::to_string(100 * lost / count) +
      " % of the surface's area, which encloses nothing; choose the method Wrap, or remove these "
      "parts");
  }
}

} // namespace

MendedSurface MakeSolidOfTriangles(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress)
{
  const OrientedDraft drafted = DraftSurface(surface, options, progress.Part(0.0, 0.3));
  return MakeSolidOfDraft(surface, drafted, options, progress.Part(0.3, 1.0));
}

MendedSurface MakeSolid(
  const Mesh& surface, const SolidSurfaceOptions& options, const Progress& progress)
{
  const std::optional<OrientedDraft> drafted =
    TryDraft(surface, options.Defects, progress.Part(0.0, 0.2));
  const Mesh triangles = drafted
    ? drafted->Draft.Surface
    : JoinSoup(surface, options.Defects.Tolerance, progress.Part(0.2, 0.25)).Surface;
  RequireNoSheets(triangles);
  const Progress check = progress.Part(0.95, 1.0);
  const double near = 2.0 * ChooseDetailSize(triangles, options.DetailSize);
  try
  {
    if (drafted)
    {
      MendedSurface solid =
        MakeSolidOfDraft(surface, *drafted, options.Defects, progress.Part(0.25, 0.6));
      RequireParts(triangles, solid.Surface, near, check);
      return solid;
    }
  }
  catch (const NoSolid&) // the grid would lack the same
  {
    throw;
  }
  catch (const InvalidInput&) // such as a hole without a loop
  {
  }
  catch (const SolveFailure&)
  {
  }
  MendedSurface solid = MakeSolidOnGrid(surface,
    drafted ? OrientCrossingPieces(triangles, progress.Part(0.6, 0.7)) : triangles, options,
    progress.Part(0.7, 0.95));
  RequireParts(triangles, solid.Surface, near, check);
  return solid;
}

} // namespace shape
