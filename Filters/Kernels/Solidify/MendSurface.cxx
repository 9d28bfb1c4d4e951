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

/// Throws InvalidInput if triangles are degenerate or intersect.
void RequireNoIntersections(const Surface& surface, const Progress& progress)
{
  const std::vector<int> collinear = FindDegenerateTriangles(surface);
  if (!collinear.empty())
  {
    throw InvalidInput("the mended surface has " + std::to_string(collinear.size()) +
      " triangles without area (first at " +
      Describe(GetCorners(surface, collinear.front()).colwise().mean()) +
      "); raise Tolerance, or repair the surface there");
  }
  constexpr int most = 1000000;
  const std::vector<Crossing> crossings = FindSelfIntersectionsFrom(surface, 0, most, progress);
  if (!crossings.empty())
  {
    throw InvalidInput("the mended surface intersects itself in " +
      std::to_string(crossings.size()) + " pairs of triangles (first at " +
      Describe(crossings.front().Position) +
      "); find them with the method Report, and separate or unite the parts");
  }
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
    RemoveRedundantSheets(draft, progress.Part(0.05, 0.3, "removing redundant sheets"));
  const SeparatedSheets separated =
    SeparateSheets(draft, progress.Part(0.3, 0.4, "separating sheets"));
  mended.ReversedTriangles = separated.Reversed;
  mended.RemovedPieces = RemoveSmallPieces(draft, options.SmallestPiece);
  if (draft.Triangles.empty())
  {
    throw InvalidInput("no triangle of the surface is left; give a surface with an area, or lower "
                       "Tolerance and SmallestPiece");
  }

  // Points and triangles keep their indices until the holes are filled, so that errors name them.
  const FilledSurface filled = FillAllHoles(draft.Surface, progress.Part(0.4, 0.8));
  const SplitSheets split = SplitTouchingSheets(filled.Surface);
  const std::vector<int> used =
    FindUsedPoints(split.Surface.Triangles, split.Surface.Points.rows());
  Mesh closed{ split.Surface.Points(used, Eigen::all),
    RenumberPoints(split.Surface.Triangles, used, split.Surface.Points.rows()) };
  MoveCopiesApart(closed);
  const Surface result(std::move(closed));
  RequireClosedSurface(result, "the mended surface");
  RequireNoIntersections(result, progress.Part(0.8, 0.9, "looking for self-intersections"));
  const Surface oriented = OrientByNesting(result, "the mended surface", progress.Part(0.9, 1.0));
  for (Eigen::Index t = 0; t < oriented.Triangles().rows(); ++t)
  {
    mended.ReversedTriangles += oriented.Triangles().row(t) != result.Triangles().row(t);
  }

  const Provenance drafted =
    TraceCopies(draft.Points, surface.Points.rows(), ToVector(draft.Triangles));
  std::vector<int> copied(used.size());
  std::transform(
    used.begin(), used.end(), copied.begin(), [&](int point) { return split.Copied[point]; });
  const auto triangles = static_cast<int>(filled.Surface.Triangles.rows());
  mended.Provenance = Compose(Compose(drafted, filled.Provenance),
    TraceCopies(copied, filled.Surface.Points.rows(),
      Eigen::VectorXi::LinSpaced(triangles, 0, triangles - 1)));
  mended.SplitPoints =
    separated.SplitPoints + static_cast<int>(split.Copied.size() - filled.Surface.Points.rows());
  mended.GapsClosed = static_cast<int>(filled.Holes.size());
  mended.Surface = oriented;
  mended.Origin = FindOrigins(mended.Surface, surface, mended.Provenance.Cells,
    static_cast<Eigen::Index>(draft.Triangles.size()));
  return mended;
}

} // namespace shape
