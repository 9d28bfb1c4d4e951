#include "Fill/FillHoles.h"

#include "Base/Errors.h"
#include "Fill/LoopChoice.h"
#include "Fill/Private/PatchSelfIntersections.h"
#include "Geometry/VertexNormals.h"
#include "Laplacian/Membrane.h"
#include "Mesh/BoundaryLoops.h"
#include "Mesh/Topology.h"
#include "Search/PointTree.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace shape
{
namespace
{

/// The order in which Automatic tries them.
/// From the smoothest to the most robust.
constexpr std::array<FillMethod, 3> Order = { FillMethod::Fair, FillMethod::Deformation,
  FillMethod::Membrane };

std::string NameOf(FillMethod method)
{
  switch (method)
  {
    case FillMethod::Deformation:
      return "the deformed disk";
    case FillMethod::Membrane:
      return "the membrane";
    default:
      return "the fair surface";
  }
}

/// Returns the hole that a triangle fills.
int OwnerOf(const FilledSurface& filled, int triangle)
{
  const auto after = std::upper_bound(filled.Holes.begin(), filled.Holes.end(), triangle,
    [](int value, const FilledHole& hole) { return value < hole.FirstTriangle; });
  return static_cast<int>(after - filled.Holes.begin()) - 1;
}

/// The provenance of the filled surface. A fill's point comes from the nearest point of its loop, a
/// triangle from the first triangle at that point. surface: without the fills.
Provenance TraceFills(const Mesh& surface, const FilledSurface& filled)
{
  Eigen::VectorXi triangleAt = Eigen::VectorXi::Constant(surface.Points.rows(), -1);
  // Backwards, so that the first triangle at each point is the one that stays.
  for (int t = static_cast<int>(surface.Triangles.rows()) - 1; t >= 0; --t)
  {
    triangleAt(surface.Triangles.row(t)).setConstant(t);
  }
  ProvenanceWriter writer(surface.Points.rows());
  writer.AddCopies(surface.Points.rows());
  Eigen::VectorXi cells(filled.Surface.Triangles.rows());
  std::iota(cells.begin(), cells.begin() + surface.Triangles.rows(), 0);
  for (const FilledHole& hole : filled.Holes)
  {
    const PointTree tree(surface.Points(hole.Loop, Eigen::all));
    const auto nearest = [&](const Eigen::RowVector3d& position)
    { return hole.Loop[tree.Nearest(position, 1).front()]; };
    for (int i = hole.FirstPoint; i < hole.FirstPoint + hole.Points; ++i)
    {
      writer.AddNearest(nearest(filled.Surface.Points.row(i)));
    }
    for (int t = hole.FirstTriangle; t < hole.FirstTriangle + hole.Triangles; ++t)
    {
      cells(t) = triangleAt(nearest(GetCorners(filled.Surface, t).colwise().mean()));
    }
  }
  return writer.Finish(cells);
}

/// The progress of the i-th of `count` equal parts.
Progress PartOf(const Progress& progress, std::size_t i, std::size_t count)
{
  const auto all = static_cast<double>(count);
  return progress.Part(static_cast<double>(i) / all, static_cast<double>(i + 1) / all);
}

} // namespace

struct SurfaceFiller::Hole
{
  Hole(BoundaryLoop boundary, const HoleFillerOptions& options)
    : Filler(std::move(boundary), options)
  {
    this->Facts.Nonplanarity = ComputeNonplanarity(this->Filler.Loop().Points);
  }

  HoleFiller Filler;
  LoopCorners Corners;
  FilledHole Facts;
  Mesh Patch;
  bool IsFilled = false;
};

SurfaceFiller::~SurfaceFiller() = default;

SurfaceFiller::SurfaceFiller(const shape::Surface& surface,
  const std::vector<std::vector<int>>& loops, const HoleFillerOptions& options)
  : Surface(surface)
{
  RequireLoops(surface.Points(), loops);
  std::vector<std::vector<int>> rims;
  for (const std::vector<int>& loop : loops)
  {
    rims.emplace_back(loop.rbegin(), loop.rend());
  }
  const TriangleFans fans(surface.Triangles(), surface.Points().rows());
  this->Add(
    rims,
    [&](const std::vector<int>& points) { return ComputeBoundaryNormals(surface, fans, points); },
    options);
}

SurfaceFiller::SurfaceFiller(const shape::Surface& surface,
  const std::vector<std::vector<int>>& rims, const Eigen::MatrixXd& normals,
  const HoleFillerOptions& options)
  : Surface(surface)
{
  RequireLoops(surface.Points(), rims);
  this->Add(
    rims,
    [&](const std::vector<int>& points) -> Eigen::MatrixXd { return normals(points, Eigen::all); },
    options);
}

/// Fills must not share edges with the surface or with each other: an edge with three triangles is
/// no manifold.
void SurfaceFiller::Add(const std::vector<std::vector<int>>& rims,
  const std::function<Eigen::MatrixXd(const std::vector<int>&)>& normals, HoleFillerOptions options)
{
  this->Taken = std::make_unique<UsedEdges>(this->Surface, rims);
  for (int i = 0; i < static_cast<int>(rims.size()); ++i)
  {
    LoopCorners corners = FindLoopCorners(rims[i], this->Surface.Points());
    options.IsTaken = this->Taken->Of(i, corners.Points);
    const BoundaryLoop boundary{ this->Surface.Points()(corners.Points, Eigen::all),
      normals(corners.Points) };
    this->Holes.emplace_back(boundary, options);
    this->Holes.back().Facts.Number = i;
    this->Holes.back().Facts.Loop = rims[i];
    this->Holes.back().Corners = std::move(corners);
  }
}

/// The surface with the present fills, that of `last` after the others.
FilledSurface SurfaceFiller::Joined(const Hole* last) const
{
  std::vector<const Hole*> order;
  for (const Hole& hole : this->Holes)
  {
    if (hole.IsFilled && &hole != last)
    {
      order.push_back(&hole);
    }
  }
  if (last)
  {
    order.push_back(last);
  }
  FilledSurface joined{ this->Surface, {}, {} };
  Eigen::Index points = this->Surface.Points().rows(), triangles = this->Surface.Triangles().rows();
  for (const Hole* hole : order)
  {
    FilledHole facts = hole->Facts;
    facts.FirstPoint = static_cast<int>(points);
    facts.FirstTriangle = static_cast<int>(triangles);
    facts.Points = static_cast<int>(hole->Patch.Points.rows() - hole->Corners.Points.size());
    facts.Triangles = static_cast<int>(hole->Patch.Triangles.rows() + hole->Corners.Slivers.rows());
    points += facts.Points;
    triangles += facts.Triangles;
    joined.Holes.push_back(std::move(facts));
  }
  joined.Surface.Points.conservativeResize(points, 3);
  joined.Surface.Triangles.conservativeResize(triangles, 3);
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    const FilledHole& facts = joined.Holes[i];
    const Mesh& patch = order[i]->Patch;
    const LoopCorners& corners = order[i]->Corners;
    const auto rim = static_cast<int>(corners.Points.size());
    joined.Surface.Points.middleRows(facts.FirstPoint, facts.Points) =
      patch.Points.bottomRows(facts.Points);
    joined.Surface.Triangles.middleRows(facts.FirstTriangle, facts.Triangles)
      << patch.Triangles.unaryExpr([&](int corner)
           { return corner < rim ? corners.Points[corner] : facts.FirstPoint + corner - rim; }),
      corners.Slivers;
  }
  return joined;
}

/// Fills a hole by one method; returns whether the result is usable.
/// Errors name the hole, since a surface may have hundreds.
bool SurfaceFiller::Try(
  Hole& hole, FillMethod method, const FillHolesOptions& options, const Progress& progress)
{
  try
  {
    HoleFill fill = hole.Filler.Fill(method, options.Deformation, options.Frames, progress);
    hole.Patch = std::move(fill.Patch);
    hole.Facts.Method = method;
    hole.Facts.DeviationBefore = fill.DeviationBefore;
    hole.Facts.DeviationAfter = fill.DeviationAfter;
    hole.Facts.Reason = !fill.Converged
      ? NameOf(method) + " did not converge; its smoothest fill is used"
      : fill.IsSound ? ""
                     : NameOf(method) + " has more than ten times the membrane's area";
    hole.IsFilled = true;
    return fill.IsSound;
  }
  catch (const SolveFailure& problem)
  {
    throw SolveFailure("the hole at point " + std::to_string(hole.Facts.Loop.front()) + ": " +
      problem.what() + "; repair the loop with Clean, or leave this hole out");
  }
}

/// Replaces a fill whose first method failed by the best of all methods. One that did not converge
/// is used only if the others have more intersections.
/// The search for intersections stops at the present minimum: a method with more is no candidate.
void SurfaceFiller::Replace(Hole& hole, const FillHolesOptions& options, const Progress& progress)
{
  std::string reason;
  Mesh bestPatch;
  FilledHole best;
  std::optional<FillMethod> unsettled;
  int minimum = std::numeric_limits<int>::max();
  const auto consider = [&]
  {
    const FilledSurface all = this->Joined(&hole);
    const auto crossings = static_cast<int>(
      FindPatchSelfIntersections(all.Surface, all.Holes.back().FirstTriangle, progress, minimum)
        .size());
    if (crossings < minimum)
    {
      minimum = crossings;
      bestPatch = hole.Patch;
      best = hole.Facts;
    }
    return crossings == 0;
  };
  for (const FillMethod method : Order)
  {
    try
    {
      if (!this->Try(hole, method, options, progress))
      {
        reason += NameOf(method) + " did not converge; ";
        unsettled = method;
      }
      else if (consider())
      {
        break;
      }
      else
      {
        reason += NameOf(method) + " intersects itself or the surface; ";
      }
    }
    catch (const SolveFailure&)
    {
      reason += NameOf(method) + " failed; ";
    }
  }
  if (minimum > 0 && unsettled)
  {
    this->Try(hole, *unsettled, options, progress);
    consider();
  }
  if (best.Loop.empty())
  {
    throw SolveFailure("the hole at point " + std::to_string(hole.Facts.Loop.front()) +
      " cannot be filled: " + reason + "repair the loop with Clean, or leave this hole out");
  }
  hole.Patch = std::move(bestPatch);
  hole.Facts = std::move(best);
  hole.Facts.Reason = reason +
    (minimum == 0 ? NameOf(hole.Facts.Method) + " has no intersections"
                  : NameOf(hole.Facts.Method) + " has the fewest intersections");
}

/// Fills each by the requested method, or Automatic's first; returns which need another one.
std::vector<bool> SurfaceFiller::FillEach(const FillHolesOptions& options, const Progress& progress)
{
  const bool isAutomatic = options.Method == FillMethod::Automatic;
  std::vector<bool> fails(this->Holes.size(), false);
  for (std::size_t i = 0; i < fails.size(); ++i)
  {
    Hole& hole = this->Holes[i];
    hole.IsFilled = false;
    try
    {
      const bool isSound = this->Try(hole, isAutomatic ? Order.front() : options.Method, options,
        PartOf(progress, i, fails.size()));
      fails[i] = isAutomatic && !isSound;
      hole.IsFilled = !fails[i];
    }
    catch (const SolveFailure&)
    {
      if (!isAutomatic)
      {
        throw;
      }
      fails[i] = true;
    }
  }
  return fails;
}

// 1. Fill each hole by the first method (FillEach).
// 2. Find the triangles of the fills that intersect each other or the surface.
// 3. With Automatic, replace these fills by the best of all methods, in two rounds (Replace).
// 4. Report the intersections that remain.
FilledSurface SurfaceFiller::Fill(const FillHolesOptions& options, const Progress& progress)
{
  // Whether or not a method uses them.
  RequireOptions(options.Deformation);
  RequireOptions(options.Frames);
  std::vector<bool> fails = this->FillEach(options, progress.Part(0.0, 0.7, "filling the holes"));
  FilledSurface filled = this->Joined(nullptr);
  const auto first = static_cast<int>(this->Surface.Triangles().rows());
  std::vector<Crossing> crossings = FindPatchSelfIntersections(
    filled.Surface, first, progress.Part(0.7, 0.75, "looking for self-intersections"));
  // In the first round one by one, so that no fill avoids another one that is still to be replaced;
  // then those that intersect a fill that came after them.
  const int rounds = options.Method == FillMethod::Automatic ? 2 : 0;
  for (int round = 0; round < rounds; ++round)
  {
    const bool isFirst = round == 0;
    for (const Crossing& crossing : crossings)
    {
      if (isFirst || crossing.First >= first)
      {
        fails[filled.Holes[OwnerOf(filled, crossing.Second)].Number] = true;
      }
      if (crossing.First >= first)
      {
        fails[filled.Holes[OwnerOf(filled, crossing.First)].Number] = true;
      }
    }
    if (std::find(fails.begin(), fails.end(), true) == fails.end())
    {
      break;
    }
    for (std::size_t i = 0; i < fails.size(); ++i)
    {
      this->Holes[i].IsFilled = !(isFirst && fails[i]);
    }
    const Progress part =
      progress.Part(0.75 + 0.1 * round, 0.85 + 0.1 * round, "refilling patches that intersect");
    for (std::size_t i = 0; i < fails.size(); ++i)
    {
      if (fails[i])
      {
        this->Replace(this->Holes[i], options, PartOf(part, i, fails.size()));
      }
    }
    fails.assign(fails.size(), false);
    filled = this->Joined(nullptr);
    crossings = FindPatchSelfIntersections(
      filled.Surface, first, progress.Part(0.95, 0.95, "looking for self-intersections"));
  }
  for (const Crossing& crossing : crossings)
  {
    ++filled.Holes[OwnerOf(filled, crossing.Second)].SelfIntersections;
  }
  filled.Provenance = TraceFills(this->Surface, filled);
  progress(1.0);
  return filled;
}

FilledSurface FillHoles(
  const Surface& surface, const FillHolesOptions& options, const Progress& progress)
{
  return FillLoops(surface, FindBoundaryLoops(surface).Loops, options, progress);
}

FilledSurface FillLoops(const Surface& surface, const std::vector<std::vector<int>>& loops,
  const FillHolesOptions& options, const Progress& progress)
{
  return SurfaceFiller(surface, loops, options.Filler).Fill(options, progress);
}

/// The Dirichlet problem on the fill, with the values at the loop.
Eigen::MatrixXd ExtendValuesOntoFill(
  const Mesh& surface, const FilledHole& hole, const Eigen::MatrixXd& values)
{
  std::map<int, int> rows; // of the patch: the rim, then the fill's own points
  std::vector<int> points, firsts;
  for (int i = 0; i < static_cast<int>(hole.Loop.size()); ++i)
  {
    if (rows.insert({ hole.Loop[i], static_cast<int>(points.size()) }).second)
    {
      points.push_back(hole.Loop[i]);
      firsts.push_back(i);
    }
  }
  for (int i = 0; i < hole.Points; ++i)
  {
    rows[hole.FirstPoint + i] = static_cast<int>(points.size());
    points.push_back(hole.FirstPoint + i);
  }
  Mesh patch{ surface.Points(points, Eigen::all),
    surface.Triangles.middleRows(hole.FirstTriangle, hole.Triangles) };
  for (int& corner : patch.Triangles.reshaped())
  {
    corner = rows.at(corner);
  }
  return SolveHarmonicValues(patch, values(firsts, Eigen::all)).bottomRows(hole.Points);
}

} // namespace shape
