#include "Parameterize/HyperbolicOrbifold.h"

#include "Base/Errors.h"
#include "Laplacian/CotangentWeights.h"
#include "Linear/SparseSolve.h"
#include "Mesh/BoundaryLoops.h"
#include "Parameterize/ConvexCombination.h"
#include "Parameterize/OrbifoldInput.h"
#include "Parameterize/Private/HyperbolicEnergy.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// The cut surface on the tile: which of its points are unknown, and an initial map.
struct TileProblem
{
  std::vector<HyperbolicPosition> Positions; ///< of the cut surface's points
  Eigen::MatrixXd Start;                     ///< u x 3: the unknowns
};

/// Returns the lengths of the path up to each of its points.
std::vector<double> LengthsAlong(const Mesh& surface, const std::vector<int>& points)
{
  std::vector<double> lengths = { 0.0 };
  for (std::size_t i = 1; i < points.size(); ++i)
  {
    lengths.push_back(
      lengths.back() + (surface.Points.row(points[i]) - surface.Points.row(points[i - 1])).norm());
  }
  return lengths;
}

/// The initial map takes each leg to a side of the tile in proportion to lengths, and the inside
/// of the surface to weighted means in the Klein model. The tile is convex there.
TileProblem BuildTileProblem(
  const HyperbolicImage& image, const EdgePath& path, const Mesh& surface, const Progress& progress)
{
  const Mesh& cut = image.Cut.Surface;
  // The boundary follows the path to its end and returns.
  std::vector<int> loop = FindManifoldBoundaryLoops(cut).front();
  std::rotate(loop.begin(),
    std::find_if(loop.begin(), loop.end(),
      [&](int point) { return image.Cut.Provenance.Points(point) == path.Points.front(); }),
    loop.end());
  const auto count = static_cast<int>(loop.size());
  const auto twin = [&](int i) { return loop[(count - i) % count]; };
  const std::vector<double> lengths = LengthsAlong(surface, path.Points);
  TileProblem problem;
  problem.Positions.resize(cut.Points.rows());
  Eigen::MatrixXd start(cut.Points.rows(), 3);
  std::vector<int> owners(problem.Positions.size(), -1); // the unknown's own point
  int unknowns = 0;
  const auto last = static_cast<int>(path.Stops.size()) - 1;
  for (int stop = 0; stop <= last; ++stop)
  {
    const int begin = path.Stops[stop];
    problem.Positions[loop[begin]].Given = image.Tile.There[stop];
    problem.Positions[twin(begin)].Given = image.Tile.Back[stop];
    start.row(loop[begin]) = image.Tile.There[stop];
    start.row(twin(begin)) = image.Tile.Back[stop];
    for (int i = begin + 1; stop < last && i < path.Stops[stop + 1]; ++i)
    {
      problem.Positions[loop[i]].Unknown = problem.Positions[twin(i)].Unknown = unknowns;
      problem.Positions[twin(i)].Motion = stop;
      const double share =
        (lengths[i] - lengths[begin]) / (lengths[path.Stops[stop + 1]] - lengths[begin]);
      start.row(loop[i]) =
        InterpolateHyperbolic(image.Tile.There[stop], image.Tile.There[stop + 1], share);
      start.row(twin(i)) = MoveHyperbolic(image.Tile.Legs[stop], start.row(loop[i]).transpose());
      owners[unknowns++] = loop[i];
    }
  }
  std::vector<char> onLoop(problem.Positions.size(), 0);
  for (const int point : loop)
  {
    onLoop[point] = 1;
  }
  for (int point = 0; point < static_cast<int>(problem.Positions.size()); ++point)
  {
    if (onLoop[point] == 0)
    {
      problem.Positions[point].Unknown = unknowns;
      owners[unknowns++] = point;
    }
  }
  const Eigen::MatrixXd klein = SolveConvexCombination(
    cut, CombinationWeights::MeanValue, loop, ProjectToKlein(start(loop, Eigen::all)), progress);
  problem.Start.resize(unknowns, 3);
  for (int i = 0; i < unknowns; ++i)
  {
    problem.Start.row(i) = LiftFromKlein(klein.row(owners[i]));
  }
  return problem;
}

/// Finds for each half-edge whether it is cut (HyperbolicImage::Cuts).
std::vector<int> FindCuts(const Surface& surface, const EdgePath& path)
{
  std::map<std::array<int, 2>, int> sides;
  for (std::size_t leg = 0; leg + 1 < path.Stops.size(); ++leg)
  {
    for (int i = path.Stops[leg]; i < path.Stops[leg + 1]; ++i)
    {
      const int number = static_cast<int>(leg) + 1;
      sides[{ path.Points[i], path.Points[i + 1] }] = number;
      sides[{ path.Points[i + 1], path.Points[i] }] = -number;
    }
  }
  const Eigen::MatrixXi& triangles = surface.Triangles();
  std::vector<int> cuts(3 * triangles.rows(), 0);
  for (int side = 0; side < static_cast<int>(cuts.size()); ++side)
  {
    const auto found =
      sides.find({ triangles(side / 3, side % 3), triangles(side / 3, (side + 1) % 3) });
    cuts[side] = found == sides.end() ? 0 : found->second;
  }
  return cuts;
}

/// Returns the edges of the surface, each once, between points of the cut surface. Weights are
/// cotangents, and at least MinimumEdgeWeight: with positive weights nothing flips.
std::vector<HyperbolicEdge> FindWeightedEdges(const Surface& surface, const Mesh& cut)
{
  constexpr double minimum = 1e-2;
  const Eigen::MatrixXi& triangles = surface.Triangles();
  const Eigen::SparseMatrix<double> stiffness =
    BuildPositiveStiffness(BuildCotangentStiffness(triangles,
                             ComputeTriangleAngles(surface).Cotangents, surface.Points().rows()),
      minimum);
  std::vector<HyperbolicEdge> edges;
  const std::vector<int>& twins = surface.Twins();
  for (int side = 0; side < static_cast<int>(twins.size()); ++side)
  {
    if (side < twins[side])
    {
      const int t = side / 3, k = side % 3, next = (k + 1) % 3;
      edges.push_back({ cut.Triangles(t, k), cut.Triangles(t, next),
        -stiffness.coeff(triangles(t, k), triangles(t, next)) });
    }
  }
  return edges;
}

/// Newton's method with backtracking. Returns the unknowns and the number of steps.
std::pair<Eigen::MatrixXd, int> Minimize(
  const HyperbolicEnergy& energy, Eigen::MatrixXd unknowns, const Progress& progress)
{
  constexpr int maximum = 200;       // far more than are needed: the energy is convex
  constexpr double converged = 1e-9; // the next step would be about its square
  constexpr double decrease = 1e-4;  // Armijo's condition
  constexpr double rounding = 1e-9;  // energies that differ by less are not compared; relative
  constexpr double longest = 2.0;    // step: the second derivatives change beyond
  if (unknowns.rows() == 0)
  {
    return { std::move(unknowns), 0 }; // all points are cones
  }
  SparseCholesky solver;
  double value = energy.Value(unknowns), before = std::numeric_limits<double>::infinity();
  for (int step = 1; step <= maximum; ++step)
  {
    const double begin = (step - 1.0) / (step + 3.0), end = step / (step + 4.0);
    const Progress part = progress.Part(begin, end);
    part(0.0);
    const HyperbolicEnergy::Derivatives derivatives = energy.Differentiate(unknowns);
    solver.Factorize(derivatives.Hessian, part.Part(0.3, 0.9));
    const Eigen::VectorXd direction = -solver.Solve(derivatives.Gradient);
    const double slope = derivatives.Gradient.dot(direction);
    const double reach =
      std::sqrt(direction.reshaped(2, unknowns.rows()).colwise().squaredNorm().maxCoeff());
    // Near the minimum, steps shrink quadratically until they are rounding.
    const bool isNear = -slope < rounding * value;
    if (isNear && (reach < converged || reach > 0.5 * before))
    {
      return { std::move(unknowns), step };
    }
    before = isNear ? reach : std::numeric_limits<double>::infinity();
    double share = std::min(1.0, longest / reach);
    Eigen::MatrixXd next = HyperbolicEnergy::Move(unknowns, share * direction);
    double after = energy.Value(next);
    while (!isNear && !(after <= value + decrease * share * slope))
    {
      share *= 0.5;
      if (share * reach < converged)
      {
        throw SolveFailure("the harmonic energy on the hyperbolic orbifold no longer falls after " +
          std::to_string(step) + " steps; remove triangles without area");
      }
      next = HyperbolicEnergy::Move(unknowns, share * direction);
      after = energy.Value(next);
    }
    unknowns = std::move(next);
    value = after;
  }
  throw SolveFailure("the harmonic energy on the hyperbolic orbifold is not minimal after " +
    std::to_string(maximum) + " steps; remove triangles without area");
}

} // namespace

HyperbolicImage MapToHyperbolicOrbifold(
  const Surface& surface, const std::vector<int>& cones, const Progress& progress)
{
  RequireOrbifoldInput(surface, cones);
  BuildHyperbolicTile(static_cast<int>(cones.size())); // throws if there are too few
  return MapToHyperbolicOrbifold(surface,
    FindEdgePathThrough(surface, cones, progress.Part(0.0, 0.1, "cutting the surface")),
    progress.Part(0.1, 1.0));
}

// Outline:
// 1. The surface is cut along the path, which makes it a disk.
// 2. Cones have given positions. A point on the cut has two copies: one is an unknown, the other
//    is its image under the leg's isometry.
// 3. The energy is minimized.
// 4. The result is checked with exact predicates in the Klein model, where edges are straight.
HyperbolicImage MapToHyperbolicOrbifold(
  const Surface& surface, const EdgePath& path, const Progress& progress)
{
  progress(0.0);
  HyperbolicImage image;
  for (const int stop : path.Stops)
  {
    image.Cones.push_back(path.Points[stop]);
  }
  RequireOrbifoldInput(surface, image.Cones);
  image.Tile = BuildHyperbolicTile(static_cast<int>(image.Cones.size()));
  std::vector<std::array<int, 2>> edges;
  for (std::size_t i = 1; i < path.Points.size(); ++i)
  {
    edges.push_back({ path.Points[i - 1], path.Points[i] });
  }
  image.Cut = CutAlongEdges(surface, edges);
  image.Cuts = FindCuts(surface, path);
  TileProblem problem = BuildTileProblem(
    image, path, surface, progress.Part(0.05, 0.2, "mapping the surface to the tile"));
  const HyperbolicEnergy energy(std::move(problem.Positions), image.Tile.Legs,
    FindWeightedEdges(surface, image.Cut.Surface), static_cast<int>(problem.Start.rows()));
  const auto [unknowns, steps] = Minimize(
    energy, std::move(problem.Start), progress.Part(0.2, 0.95, "minimizing the harmonic energy"));
  image.Iterations = steps;
  image.Energy = energy.Value(unknowns);
  image.Points = energy.Positions(unknowns);
  RequireUnflippedTile(image.Cut.Surface, ProjectToKlein(image.Points));
  progress(1.0);
  return image;
}

} // namespace shape
