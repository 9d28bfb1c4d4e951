#include "Solidify/Private/ClosedDraft.h"

#include "Geometry/SelfIntersections.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/CoincidentPoints.h"
#include "Mesh/UsedPoints.h"
#include "Mesh/VertexFans.h"
#include "Solidify/Private/JoinedSoup.h"
#include "Solidify/Private/SheetPairing.h"
#include "Solidify/Private/SolidSampling.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <sstream>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

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

/// The area vector of a loop, whose length is the least area of a surface that spans it.
RowVector3d ComputeAreaVector(const Eigen::MatrixXd& points, const std::vector<int>& loop)
{
  const RowVector3d origin = points.row(loop.front());
  RowVector3d sum = RowVector3d::Zero();
  for (std::size_t i = 0; i + 1 < loop.size(); ++i)
  {
    const RowVector3d begin = points.row(loop[i]) - origin, end = points.row(loop[i + 1]) - origin;
    sum += 0.5 * begin.cross(end);
  }
  return sum;
}

/// Returns the numbers of the loops, ascending, whose fills bulge: they have more than twice the
/// least area that spans their loops. Half of a sphere has exactly twice this area.
std::vector<int> FindBulgingFills(const FilledSurface& filled)
{
  constexpr double most = 2.0;
  std::vector<int> bulging;
  for (const FilledHole& hole : filled.Holes)
  {
    const Mesh fill{ filled.Surface.Points,
      filled.Surface.Triangles.middleRows(hole.FirstTriangle, hole.Triangles) };
    const double least = 0.5 * ComputeAreaVectors(fill).colwise().sum().norm();
    if (ComputeArea(fill) > most * least)
    {
      bulging.push_back(hole.Number);
    }
  }
  std::sort(bulging.begin(), bulging.end());
  return bulging;
}

/// Returns the area of each connected component, by ComponentId.
Eigen::VectorXd ComputePieceAreas(const Surface& surface)
{
  const Topology& topology = surface.Topology();
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(topology.Components);
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    areas(topology.ComponentId(surface.Triangles()(t, 0))) +=
      0.5 * surface.AreaVectors().row(t).norm();
  }
  return areas;
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
  // Holes are filled several times if triangles cross. Each of the fills takes at most a second.
  FillHolesOptions options;
  options.Filler.MaximumPoints = 2000;
  // A smooth fill of a large hole can bulge by the length of its piece.
  constexpr double large = 0.2; // of the area
  const Eigen::VectorXd areas = ComputePieceAreas(surface);
  std::vector<std::vector<int>> smooth, flat;
  for (const std::vector<int>& loop : boundary.Loops)
  {
    const double least = ComputeAreaVector(surface.Points(), loop).norm();
    const double area = areas(surface.Topology().ComponentId(loop.front()));
    (least > large * (area + least) ? flat : smooth).push_back(loop);
  }
  FilledSurface filled = FillLoops(surface, smooth, options, progress.Part(0.0, 0.4));
  const std::vector<int> bulging = FindBulgingFills(filled);
  if (!bulging.empty())
  {
    for (auto i = bulging.rbegin(); i != bulging.rend(); ++i)
    {
      flat.push_back(smooth[*i]);
      smooth.erase(smooth.begin() + *i);
    }
    filled = FillLoops(surface, smooth, options, progress.Part(0.4, 0.6));
  }
  if (flat.empty())
  {
    return filled;
  }
  options.Method = FillMethod::Membrane;
  FilledSurface all = FillLoops(filled.Surface, flat, options, progress.Part(0.6, 1.0));
  all.Provenance = Compose(filled.Provenance, all.Provenance);
  all.Holes.insert(all.Holes.begin(), filled.Holes.begin(), filled.Holes.end());
  return all;
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

Eigen::VectorXi ToVector(const std::vector<int>& values)
{
  return Eigen::Map<const Eigen::VectorXi>(values.data(), static_cast<Eigen::Index>(values.size()));
}

} // namespace

std::string DescribePosition(const RowVector3d& position)
{
  std::ostringstream words;
  words << "(" << position(0) << ", " << position(1) << ", " << position(2) << ")";
  return words.str();
}

OrientedDraft DraftSurface(
  const Mesh& surface, const SurfaceDefectOptions& options, const Progress& progress)
{
  JoinedSoup soup = JoinSoup(surface, options.Tolerance, progress.Part(0.0, 0.2));
  MendedDraft draft{ std::move(soup.Surface), std::move(soup.Triangles), {} };
  draft.Points.resize(draft.Surface.Points.rows());
  std::iota(draft.Points.begin(), draft.Points.end(), 0);

  OrientedDraft drafted;
  drafted.RemovedTriangles = static_cast<int>(soup.Collapsed.size());
  drafted.RemovedTriangles += SplitAtCollinearCorners(draft);
  drafted.RemovedTriangles += RemoveSameTriangles(draft);
  drafted.RemovedTriangles +=
    RemoveRedundantSheets(draft, progress.Part(0.2, 0.7, "removing redundant sheets"));
  const SeparatedSheets separated =
    SeparateSheets(draft, progress.Part(0.7, 1.0, "separating sheets"));
  drafted.SplitPoints = separated.SplitPoints;
  drafted.ReversedTriangles = separated.Reversed;
  drafted.RemovedPieces = RemoveSmallPieces(draft, options.SmallestPiece);
  if (draft.Triangles.empty())
  {
    throw InvalidInput("no triangle of the surface is left; give a surface with an area, or lower "
                       "Tolerance and SmallestPiece");
  }
  drafted.Draft = std::move(draft);
  return drafted;
}

void RequireNoSheets(const Mesh& surface)
{
  const Topology topology = ComputeTopology(surface);
  const Mesh closed = CloseByCones(surface);
  const Eigen::MatrixXd vectors = 0.5 * ComputeAreaVectors(closed);
  Eigen::VectorXd own = Eigen::VectorXd::Zero(topology.Components), fills = own;
  std::map<int, RowVector3d> holes; // the area vectors of the cones, by their apexes
  std::map<int, int> componentOf;
  for (Eigen::Index t = 0; t < vectors.rows(); ++t)
  {
    const int component = topology.ComponentId(closed.Triangles(t, 0));
    if (t < surface.Triangles.rows())
    {
      own(component) += vectors.row(t).norm();
      continue;
    }
    const int apex = closed.Triangles(t, 2);
    holes.emplace(apex, RowVector3d::Zero()).first->second += vectors.row(t);
    componentOf[apex] = component;
  }
  for (const auto& [apex, vector] : holes)
  {
    fills(componentOf[apex]) += vector.norm(); // no fill of the hole has a smaller area
  }
  constexpr double most = 0.45, share = 0.1; // half of a flat sheet with its fill is the fill
  double sheets = 0.0;
  int count = 0;
  for (Eigen::Index component = 0; component < own.size(); ++component)
  {
    if (fills(component) >= most * (own(component) + fills(component)))
    {
      sheets += own(component);
      ++count;
    }
  }
  if (count > 0 && sheets >= share * own.sum())
  {
    throw NoSolid("the solid of the surface is empty: it has " + std::to_string(count) +
      " sheet(s), which enclose nothing, since their holes are as large as they are; choose the "
      "method Wrap, or remove them");
  }
}

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
      DescribePosition(GetCorners(closed.Result, collinear.front()).colwise().mean()) +
      "); raise Tolerance, or repair the surface there");
  }
  return closed;
}

Provenance TraceClosing(const ClosedDraft& closed, Eigen::Index points)
{
  const Provenance drafted =
    TraceCopies(closed.Draft.Points, points, ToVector(closed.Draft.Triangles));
  std::vector<int> copied(closed.Points.size());
  std::transform(closed.Points.begin(), closed.Points.end(), copied.begin(),
    [&](int point) { return closed.Split.Copied[point]; });
  const Mesh& filled = closed.Filled.Surface;
  const auto triangles = static_cast<int>(filled.Triangles.rows());
  return Compose(Compose(drafted, closed.Filled.Provenance),
    TraceCopies(
      copied, filled.Points.rows(), Eigen::VectorXi::LinSpaced(triangles, 0, triangles - 1)));
}

Eigen::VectorXi FindOrigins(const Mesh& mended, const Mesh& input, const Eigen::VectorXi& cells,
  const std::vector<char>& isMade)
{
  Eigen::VectorXi origin(mended.Triangles.rows());
  for (Eigen::Index t = 0; t < origin.size(); ++t)
  {
    const auto is = isMade[t]                                ? TriangleOrigin::Made
      : GetCorners(mended, t) == GetCorners(input, cells(t)) ? TriangleOrigin::Kept
                                                             : TriangleOrigin::Mended;
    origin(t) = static_cast<int>(is);
  }
  return origin;
}

} // namespace shape
