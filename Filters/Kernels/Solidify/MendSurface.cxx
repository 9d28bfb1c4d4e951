#include "Solidify/MendSurface.h"

#include "Base/Errors.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Surface.h"
#include "Solidify/Private/ClosedDraft.h"
#include "Solids/Nesting.h"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Returns the triangles of a draft without those that intersect others, and without `rings` rings
/// of triangles around these.
std::vector<int> FindApartFromCrossings(
  const MendedDraft& draft, const std::vector<Crossing>& crossings, int rings)
{
  const auto count = static_cast<int>(draft.Triangles.size());
  std::vector<char> isRemoved(count, 0);
  for (const Crossing& crossing : crossings)
  {
    for (const int t : { crossing.First, crossing.Second })
    {
      if (t < count) // else it is a fill
      {
        isRemoved[t] = 1;
      }
    }
  }
  const Eigen::MatrixXi& triangles = draft.Surface.Triangles;
  for (int ring = 0; ring < rings; ++ring)
  {
    std::vector<char> isNear(draft.Surface.Points.rows(), 0);
    for (int t = 0; t < count; ++t)
    {
      for (int k = 0; k < 3 && isRemoved[t]; ++k)
      {
        isNear[triangles(t, k)] = 1;
      }
    }
    for (int t = 0; t < count; ++t)
    {
      isRemoved[t] = isRemoved[t] || isNear[triangles(t, 0)] || isNear[triangles(t, 1)] ||
        isNear[triangles(t, 2)];
    }
  }
  std::vector<int> kept;
  for (int t = 0; t < count; ++t)
  {
    if (!isRemoved[t])
    {
      kept.push_back(t);
    }
  }
  return kept;
}

/// Closes a draft. Triangles that intersect others are replaced by fills, if this changes neither
/// the number of components nor the Euler number. Else it throws InvalidInput with the number of
/// intersections. removed: is raised by the number of triangles that were replaced.
ClosedDraft CloseWithoutCrossings(const MendedDraft& draft, int& removed, const Progress& progress)
{
  constexpr int most = 1000000;
  ClosedDraft closed = CloseDraft(draft, progress.Part(0.0, 0.5));
  const std::vector<Crossing> crossings = FindSelfIntersectionsFrom(
    closed.Result, 0, most, progress.Part(0.5, 0.6, "looking for self-intersections"));
  if (crossings.empty())
  {
    return closed;
  }
  const Topology& wanted = closed.Result.Topology();
  MendedDraft rest = draft;
  std::vector<Crossing> remaining = crossings;
  constexpr int rounds = 6;
  for (int round = 0, rings = 0; round < rounds; ++round, ++rings)
  {
    MendedDraft less = rest;
    less.Keep(FindApartFromCrossings(rest, remaining, rings));
    const auto replaced = static_cast<double>(draft.Triangles.size() - less.Triangles.size());
    constexpr double local = 0.1;
    if (replaced > local * static_cast<double>(draft.Triangles.size()))
    {
      break;
    }
    const Progress part =
      progress.Part(0.6 + 0.06 * round, 0.66 + 0.06 * round, "replacing intersections");
    try
    {
      ClosedDraft again = CloseDraft(less, part);
      std::vector<Crossing> found = FindSelfIntersectionsFrom(again.Result, 0, most, part);
      if (found.empty() && again.Result.Topology().Components == wanted.Components &&
        again.Result.Topology().EulerNumber == wanted.EulerNumber)
      {
        removed += static_cast<int>(replaced);
        return again;
      }
      if (!found.empty() && found.size() < remaining.size())
      {
        // What the new fills intersect is replaced next.
        rest = std::move(less);
        remaining = std::move(found);
        rings = -1;
      }
    }
    catch (const InvalidInput&) // its holes cannot be filled; more rings may help
    {
    }
    catch (const SolveFailure&)
    {
    }
  }
  throw InvalidInput("the mended surface intersects itself in " + std::to_string(crossings.size()) +
    " pairs of triangles (first at " + DescribePosition(crossings.front().Position) +
    "); find them with the method Report, and separate or unite the parts");
}

} // namespace

MendedSurface MendSurface(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress)
{
  const OrientedDraft drafted = DraftSurface(surface, options, progress.Part(0.0, 0.3));
  RequireNoSheets(drafted.Draft.Surface);
  MendedSurface mended;
  mended.RemovedTriangles = drafted.RemovedTriangles;
  mended.ReversedTriangles = drafted.ReversedTriangles;
  mended.RemovedPieces = drafted.RemovedPieces;
  const ClosedDraft closed =
    CloseWithoutCrossings(drafted.Draft, mended.RemovedTriangles, progress.Part(0.3, 0.9));
  const Surface oriented =
    OrientByNesting(closed.Result, "the mended surface", progress.Part(0.9, 1.0));
  for (Eigen::Index t = 0; t < oriented.Triangles().rows(); ++t)
  {
    mended.ReversedTriangles += oriented.Triangles().row(t) != closed.Result.Triangles().row(t);
  }

  mended.Provenance = TraceClosing(closed, surface.Points.rows());
  mended.SplitPoints = drafted.SplitPoints + closed.SplitPoints();
  mended.GapsClosed = static_cast<int>(closed.Filled.Holes.size());
  mended.Surface = oriented;
  std::vector<char> isMade(oriented.Triangles().rows(), 1);
  std::fill_n(isMade.begin(), closed.Draft.Triangles.size(), 0);
  mended.Origin = FindOrigins(mended.Surface, surface, mended.Provenance.Cells, isMade);
  return mended;
}

} // namespace shape
