#include "Solidify/MendSurface.h"

#include "Base/Errors.h"
#include "Fill/FillHoles.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/Surface.h"
#include "Mesh/TouchingSheets.h"
#include "Mesh/UsedPoints.h"
#include "Mesh/VertexFans.h"
#include "Solidify/Private/JoinedSoup.h"
#include "Solidify/Private/SheetPairing.h"
#include "Solidify/Private/SoupRepair.h"
#include "Solids/Nesting.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

std::string Describe(const RowVector3d& position)
{
  std::ostringstream words;
  words << "(" << position(0) << ", " << position(1) << ", " << position(2) << ")";
  return words.str();
}

/// Removes pieces whose bounding box has no edge of this length. Returns their number.
int RemoveSmallPieces(MendedDraft& draft, double smallest)
{
  const Surface surface = draft.Surface;
  const Topology& topology = surface.Topology();
  std::vector<Eigen::AlignedBox3d> boxes(topology.Components);
  for (Eigen::Index point = 0; point < surface.Points().rows(); ++point)
  {
    if (topology.ComponentId(point) >= 0)
    {
      boxes[topology.ComponentId(point)].extend(surface.Points().row(point).transpose());
    }
  }
  const auto isSmall = [&](int component)
  { return boxes[component].sizes().maxCoeff() < smallest; };
  std::vector<int> kept;
  for (int t = 0; t < static_cast<int>(draft.Triangles.size()); ++t)
  {
    if (!isSmall(topology.ComponentId(surface.Triangles()(t, 0))))
    {
      kept.push_back(t);
    }
  }
  int removed = 0;
  for (int component = 0; component < topology.Components; ++component)
  {
    removed += isSmall(component);
  }
  draft.Keep(kept);
  return removed;
}

/// Fills all holes. A surface whose boundary does not close has no solid.
FilledSurface FillAllHoles(const Surface& surface, const Progress& progress)
{
  const BoundaryLoops boundary = FindBoundaryLoops(surface);
  if (boundary.UnclosedSides > 0)
  {
    throw InvalidInput(std::to_string(boundary.UnclosedSides) +
      " boundary edges of the surface form no closed loop; find them with the method Report, and "
      "remove the triangles beside them");
  }
  return FillLoops(surface, boundary.Loops, {}, progress);
}

/// Moves copies of a point apart, each towards the points around it.
void MoveCopiesApart(Mesh& mesh)
{
  const std::vector<int> first = FindCoincidentPoints(mesh.Points);
  std::vector<int> copies(first.size(), 0);
  for (const int point : first)
  {
    ++copies[point];
  }
  constexpr double share = 1e-3; // of the shortest edge
  const VertexFans fans(mesh.Triangles, static_cast<int>(mesh.Points.rows()));
  const Eigen::MatrixXd before = mesh.Points;
  for (int point = 0; point < static_cast<int>(first.size()); ++point)
  {
    if (copies[first[point]] < 2)
    {
      continue;
    }
    RowVector3d away = RowVector3d::Zero();
    double shortest = std::numeric_limits<double>::infinity();
    for (int i = fans.First[point]; i < fans.First[point + 1]; ++i)
    {
      const RowVector3d edge = before.row(fans.Triangles[i].Next) - before.row(point);
      away += edge.normalized();
      shortest = std::min(shortest, edge.norm());
    }
    if (away.norm() > 0.0)
    {
      mesh.Points.row(point) += share * shortest * away.normalized();
    }
  }
}

/// A draft whose holes are filled.
struct ClosedDraft
{
  MendedDraft Draft;       ///< before
  FilledSurface Filled;    ///< the draft and the fills
  SplitSheets Split;       ///< without points where fans touch
  std::vector<int> Points; ///< the points of Split that are used
  Surface Result;          ///< with these points, and copies of a point apart
};

ClosedDraft CloseDraft(MendedDraft draft, const Progress& progress)
{
  ClosedDraft closed{ std::move(draft), {}, {}, {}, {} };
  // Points keep their indices until the holes are filled, so that errors name those of the input.
  closed.Filled = FillAllHoles(closed.Draft.Surface, progress);
  closed.Split = SplitTouchingSheets(closed.Filled.Surface);
  const Mesh& split = closed.Split.Surface;
  closed.Points = FindUsedPoints(split.Triangles, split.Points.rows());
  Mesh mesh{ split.Points(closed.Points, Eigen::all),
    RenumberPoints(split.Triangles, closed.Points, split.Points.rows()) };
  MoveCopiesApart(mesh);
  closed.Result = Surface(std::move(mesh));
  RequireClosedSurface(closed.Result, "the mended surface");
  const std::vector<int> collinear = FindDegenerateTriangles(closed.Result);
  if (!collinear.empty())
  {
    throw InvalidInput("the mended surface has " + std::to_string(collinear.size()) +
      " triangles without area (first at " +
      Describe(GetCorners(closed.Result, collinear.front()).colwise().mean()) +
      "); raise Tolerance, or repair the surface there");
  }
  return closed;
}

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
    " pairs of triangles (first at " + Describe(crossings.front().Position) +
    "); find them with the method Report, and separate or unite the parts");
}

/// Compares the triangles with those of the input from which they come.
Eigen::VectorXi FindOrigins(
  const Mesh& mended, const Mesh& input, const Eigen::VectorXi& cells, Eigen::Index made)
{
  Eigen::VectorXi origin(mended.Triangles.rows());
  for (Eigen::Index t = 0; t < origin.size(); ++t)
  {
    const auto is = t >= made                                ? TriangleOrigin::Made
      : GetCorners(mended, t) == GetCorners(input, cells(t)) ? TriangleOrigin::Kept
                                                             : TriangleOrigin::Mended;
    origin(t) = static_cast<int>(is);
  }
  return origin;
}

Eigen::VectorXi ToVector(const std::vector<int>& values)
{
  return Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size()));
}

} // namespace

MendedSurface MendSurface(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress)
{
  JoinedSoup soup = JoinSoup(surface, options.Tolerance, progress.Part(0.0, 0.05));
  MendedDraft draft{ std::move(soup.Surface), std::move(soup.Triangles), {} };
  draft.Points.resize(draft.Surface.Points.rows());
  std::iota(draft.Points.begin(), draft.Points.end(), 0);

  MendedSurface mended;
  mended.RemovedTriangles = static_cast<int>(soup.Collapsed.size());
  mended.RemovedTriangles += SplitAtCollinearCorners(draft);
  mended.RemovedTriangles += RemoveSameTriangles(draft);
  mended.RemovedTriangles +=
    RemoveRedundantSheets(draft, progress.Part(0.05, 0.2, "removing redundant sheets"));
  const SeparatedSheets separated =
    SeparateSheets(draft, progress.Part(0.2, 0.3, "separating sheets"));
  mended.ReversedTriangles = separated.Reversed;
  mended.RemovedPieces = RemoveSmallPieces(draft, options.SmallestPiece);
  if (draft.Triangles.empty())
  {
    throw InvalidInput("no triangle of the surface is left; give a surface with an area, or lower "
                       "Tolerance and SmallestPiece");
  }

  const ClosedDraft closed =
    CloseWithoutCrossings(draft, mended.RemovedTriangles, progress.Part(0.3, 0.9));
  const Surface oriented =
    OrientByNesting(closed.Result, "the mended surface", progress.Part(0.9, 1.0));
  for (Eigen::Index t = 0; t < oriented.Triangles().rows(); ++t)
  {
    mended.ReversedTriangles += oriented.Triangles().row(t) != closed.Result.Triangles().row(t);
  }

  const Provenance drafted =
    TraceCopies(closed.Draft.Points, surface.Points.rows(), ToVector(closed.Draft.Triangles));
  std::vector<int> copied(closed.Points.size());
  std::transform(closed.Points.begin(), closed.Points.end(), copied.begin(),
    [&](int point) { return closed.Split.Copied[point]; });
  const Mesh& filled = closed.Filled.Surface;
  const auto triangles = static_cast<int>(filled.Triangles.rows());
  mended.Provenance = Compose(Compose(drafted, closed.Filled.Provenance),
    TraceCopies(
      copied, filled.Points.rows(), Eigen::VectorXi::LinSpaced(triangles, 0, triangles - 1)));
  mended.SplitPoints =
    separated.SplitPoints + static_cast<int>(closed.Split.Copied.size() - filled.Points.rows());
  mended.GapsClosed = static_cast<int>(closed.Filled.Holes.size());
  mended.Surface = oriented;
  mended.Origin = FindOrigins(mended.Surface, surface, mended.Provenance.Cells,
    static_cast<Eigen::Index>(closed.Draft.Triangles.size()));
  return mended;
}

} // namespace shape
