#include "Untangle/Untangle.h"

#include "Base/Errors.h"
#include "Geometry/Orientation.h"
#include "Mesh/Topology.h"
#include "Search/ClosestPoint.h"
#include "Untangle/FoldoverFree.h"
#include "Untangle/Private/CellSplits.h"
#include "Untangle/Private/SlidingBoundary.h"
#include "Untangle/Private/SolidCells.h"
#include "Untangle/Private/TutteEmbedding.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>

namespace shape
{
namespace
{

/// How many rings of points around inverted cells move, one round after the other; cells that
/// stayed inverted are split in one edge from FirstSplitting on, and all around from FirstCollar
/// on.
constexpr int Rings[] = { 1, 2, 2, 3, 3, 4, 4, 5, 5, 6, 6, 8, 8, 12, 12, 16, 16 };
constexpr int FirstSplitting = 1, FirstCollar = 2;
constexpr int Rounds = static_cast<int>(std::size(Rings));
/// This many rounds without fewer inverted cells than ever before are the end.
constexpr int Patience = 6;
/// This many times more inverted cells than there have been are a wrong way: it is left.
constexpr std::size_t MaximumIncrease = 2;
/// This many rounds after one another the edges of a fixed point may be split once more.
constexpr int RoundsPerCollar = 4;

class Untangler
{
public:
  Untangler(const Cells& cells, const Eigen::MatrixXd& rest, const UntangleOptions& options)
    : Options(options)
    , Solid(cells, rest, "the Input")
  {
    if (!options.FixBoundary)
    {
      this->Sliding =
        std::make_unique<SlidingBoundary>(this->Solid.Points, this->Solid.BoundaryTriangles());
    }
  }

  /// Forgets where the points inside are, and begins with each in the middle of its neighbours.
  void StartFromMeans() { this->Solid.Points = SolveTutteEmbedding(this->Solid); }

  /// Moves points, in steps that may take `patience` times as many iterations as asked for, until
  /// no cell is inverted or no way to fewer of them is found. Returns how many are.
  int Run(int patience, const Progress& progress)
  {
    this->MaximumSteps = patience *
      std::min(this->Options.MaximumIterations, std::numeric_limits<int>::max() / patience);
    progress(0.02);
    std::vector<int> bad = this->InvertedCells(progress.Part(0.02, 0.05));
    CellSplits splits(this->Solid, [this](int point) { return this->Movable(point); });
    std::size_t minimum = bad.size();
    auto best = bad.empty() ? nullptr : std::make_unique<SolidCells>(this->Solid);
    for (int round = 0, last = 0; round < Rounds && !bad.empty() && round <= last + Patience;
         ++round)
    {
      const Progress part =
        progress.Part(0.05 + 0.9 * round / Rounds, 0.05 + 0.9 * (round + 1.0) / Rounds);
      splits.Impossible(bad);
      if (round >= FirstSplitting)
      {
        splits.Stubborn(this->InvertedCells(),
          round < FirstCollar ? 0 : 1 + (round - FirstCollar) / RoundsPerCollar);
      }
      this->MovePoints(Rings[round], part);
      bad = this->InvertedCells(part.Part(0.99, 1.0));
      if (bad.size() < minimum)
      {
        minimum = bad.size();
        last = round;
        *best = this->Solid;
      }
      else if (bad.size() > MaximumIncrease * minimum)
      {
        this->Solid = *best;
        bad = this->InvertedCells();
      }
    }
    if (bad.size() > minimum)
    {
      this->Solid = *best;
      bad = this->InvertedCells();
    }
    progress(1.0);
    return static_cast<int>(bad.size());
  }

  UntangleResult Finish()
  {
    UntangleResult result;
    result.Iterations = this->Iterations;
    result.Solid = this->Solid.Result();
    ProvenanceWriter provenance(this->Solid.OriginalPointCount);
    provenance.AddCopies(this->Solid.OriginalPointCount);
    for (const std::array<int, 4>& parents : this->Solid.Parents)
    {
      provenance.AddMean({ parents.begin(), std::find(parents.begin(), parents.end(), -1) });
    }
    result.Provenance = provenance.Finish(
      Eigen::Map<const Eigen::VectorXi>(this->Solid.OriginalCells.data(), this->Solid.CellCount()));
    result.Inverted = Eigen::VectorXi::Zero(this->Solid.CellCount());
    for (const int cell : this->InvertedCells())
    {
      result.Inverted(cell) = 1;
    }
    result.InvertedAfter = result.Inverted.sum();
    Eigen::VectorXi parts = Eigen::VectorXi::Zero(this->Solid.CellCount());
    for (const int original : this->Solid.OriginalCells)
    {
      ++parts(original);
    }
    result.SplitCells = static_cast<int>((parts.array() > 1).count());
    return result;
  }

  std::vector<int> InvertedCells(const Progress& progress = {})
  {
    std::vector<int> inverted;
    for (int cell = 0; cell < this->Solid.CellCount(); ++cell)
    {
      if (cell % 16384 == 0)
      {
        progress(static_cast<double>(cell) / this->Solid.CellCount());
      }
      if (this->Solid.Inverted(cell))
      {
        inverted.push_back(cell);
      }
    }
    return inverted;
  }

private:
  bool Movable(int point) const
  {
    return !this->Solid.OnBoundary(point) || (this->Sliding && this->Sliding->Freedom(point) > 0);
  }

  /// Each set of movable points around inverted cells that is connected is a patch of its own.
  void MovePoints(int rings, const Progress& progress)
  {
    const Eigen::VectorXd sizes = ComputeLogarithmicSizes(this->Solid);
    std::vector<char> chosen(this->Solid.PointCount(), 0);
    std::vector<int> front;
    for (const int cell : this->InvertedCells())
    {
      this->Choose(this->Solid.PointsOf(cell), chosen, front);
    }
    for (int ring = 1; ring < rings; ++ring)
    {
      std::vector<int> next;
      for (const int point : front)
      {
        for (const int cell : this->Solid.CellsOf(point))
        {
          this->Choose(this->Solid.PointsOf(cell), chosen, next);
        }
      }
      front = std::move(next);
    }
    std::vector<char> taken(this->Solid.PointCount(), 0);
    std::vector<std::vector<int>> patches;
    for (int point = 0; point < this->Solid.PointCount(); ++point)
    {
      if (chosen[point] && this->Movable(point) && !taken[point])
      {
        patches.push_back(this->Together(point, chosen, taken));
      }
    }
    for (std::size_t i = 0; i < patches.size(); ++i)
    {
      this->Move(patches[i], sizes,
        progress.Part(static_cast<double>(i) / patches.size(), (i + 1.0) / patches.size()));
    }
  }

  void Choose(const std::vector<int>& points, std::vector<char>& chosen, std::vector<int>& front)
  {
    for (const int point : points)
    {
      if (!chosen[point])
      {
        chosen[point] = 1;
        front.push_back(point);
      }
    }
  }

  std::vector<int> Together(int first, const std::vector<char>& chosen, std::vector<char>& taken)
  {
    std::vector<int> all = { first };
    taken[first] = 1;
    for (std::size_t i = 0; i < all.size(); ++i)
    {
      for (const int cell : this->Solid.CellsOf(all[i]))
      {
        for (const int point : this->Solid.PointsOf(cell))
        {
          if (chosen[point] && this->Movable(point) && !taken[point])
          {
            taken[point] = 1;
            all.push_back(point);
          }
        }
      }
    }
    std::sort(all.begin(), all.end());
    return all;
  }

  void Move(const std::vector<int>& points, const Eigen::VectorXd& sizes, const Progress& progress)
  {
    SimplexPatch patch;
    patch.FreePoints = points;
    std::vector<int> cells;
    for (const int point : points)
    {
      const std::vector<int>& around = this->Solid.CellsOf(point);
      cells.insert(cells.end(), around.begin(), around.end());
    }
    std::sort(cells.begin(), cells.end());
    cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
    int before = 0;
    for (const int cell : cells)
    {
      const auto simplices = this->Solid.SimplicesOf(cell);
      for (std::size_t k = 0; k < simplices.size(); ++k)
      {
        const std::array<int, 4>& c = simplices[k];
        if (std::none_of(c.begin(), c.end(),
              [&](int point) { return std::binary_search(points.begin(), points.end(), point); }))
        {
          continue;
        }
        double size = 0.0;
        for (const int point : c)
        {
          size += 0.25 * sizes(point);
        }
        patch.Simplices.push_back({ c,
          ComputeHatGradients(this->Solid.Reference(cell, static_cast<int>(k), std::exp(size))) });
        const Eigen::MatrixXd& x = this->Solid.Points;
        before += EvaluateOrientation(x.row(c[0]), x.row(c[1]), x.row(c[2]), x.row(c[3])) <= 0;
      }
    }
    if (before == 0)
    {
      return;
    }
    PatchOptions options;
    options.MaximumSteps = this->MaximumSteps;
    const Eigen::MatrixXd kept = this->Solid.Points(points, Eigen::all);
    const PatchResult moved =
      MinimizeEnergy(this->Solid.Points, patch, this->Sliding.get(), options, progress);
    this->Iterations += moved.Steps;
    if (moved.Negative > before)
    {
      this->Solid.Points(points, Eigen::all) = kept;
    }
  }

  UntangleOptions Options;
  SolidCells Solid;
  std::unique_ptr<SlidingBoundary> Sliding;
  int MaximumSteps = 0, Iterations = 0;
};

} // namespace

UntangleResult Untangle(const Cells& cells, const Eigen::MatrixXd& rest,
  const UntangleOptions& options, const Progress& progress)
{
  if (options.MaximumIterations < 1)
  {
    throw InvalidInput("MaximumIterations is " + std::to_string(options.MaximumIterations) +
      "; it must be at least 1");
  }
  RequireFinite(cells.Points, "the Input");
  if (rest.rows() > 0)
  {
    RequireFinite(rest, "the RestShape");
    if (rest.rows() != cells.Points.rows())
    {
      throw InvalidInput("the RestShape has " + std::to_string(rest.rows()) +
        " points, the Input " + std::to_string(cells.Points.rows()) +
        "; give the same cells before they were moved");
    }
  }
  // What is left then is a matter of patience, or of where it began.
  constexpr int patience = 3;
  auto best = std::make_unique<Untangler>(cells, rest, options);
  const auto invertedBefore = static_cast<int>(best->InvertedCells().size());
  int left = best->Run(1, progress.Part(0.0, 0.5));
  left = left > 0 ? best->Run(patience, progress.Part(0.5, 0.7)) : 0;
  if (left > 0)
  {
    auto other = std::make_unique<Untangler>(cells, rest, options);
    other->StartFromMeans();
    if (other->Run(patience, progress.Part(0.7, 0.95)) < left)
    {
      best.swap(other);
    }
  }
  UntangleResult result = best->Finish();
  result.InvertedBefore = invertedBefore;
  progress(1.0);
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    result.MovedPoints += result.Solid.Points.row(i) != cells.Points.row(i);
  }
  return result;
}

namespace
{

constexpr double OnSurface = 1e-6;

} // namespace

UntangleResult ComputeFoldFreeMap(const Cells& domain, const Eigen::MatrixXd& moved,
  const Mesh& boundary, const Eigen::MatrixXd& targets, const Progress& progress)
{
  RequireFinite(domain.Points, "the Domain");
  const SolidCells solid(domain, {}, "the Domain");
  std::vector<int> outer;
  for (int point = 0; point < solid.PointCount(); ++point)
  {
    if (solid.OnBoundary(point))
    {
      outer.push_back(point);
    }
  }
  const ClosestPoints closest =
    SurfaceLocator(boundary).Find(domain.Points(outer, Eigen::all), progress.Part(0.0, 0.1));
  const Eigen::MatrixXd images = PullBack(closest, boundary.Triangles, targets);
  Cells carried = domain;
  carried.Points = moved;
  const double farthest = OnSurface * ComputeLongestBoxEdge(boundary.Points);
  for (std::size_t i = 0; i < outer.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    if (closest.Distances(row) <= farthest)
    {
      // At a point of the surface its own image, to the bit.
      int corner = 0;
      const bool atCorner = closest.Barycentrics.row(row).maxCoeff(&corner) > 1.0 - 1e-9;
      carried.Points.row(outer[i]) = atCorner
        ? targets.row(boundary.Triangles(closest.Triangles(row), corner))
        : images.row(row);
    }
  }
  return Untangle(carried, domain.Points, {}, progress.Part(0.1, 1.0));
}

} // namespace shape
