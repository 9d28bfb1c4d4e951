#include "Volume/Untangle.h"

#include "Core/Errors.h"
#include "Core/Orientation.h"
#include "Core/Topology.h"
#include "Volume/LocalSizes.h"
#include "Volume/SimplexPatch.h"
#include "Volume/SlidingBoundary.h"
#include "Volume/SolidCells.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
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
/// So many rounds without fewer inverted cells than ever before are the end.
constexpr int Patience = 6;
/// So many rounds after one another the edges of a fixed point may be split once more.
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

  UntangleResult Run(const Progress& progress)
  {
    std::vector<int> bad = this->InvertedCells();
    this->Result.InvertedBefore = static_cast<int>(bad.size());
    std::size_t least = bad.size();
    for (int round = 0, last = 0; round < Rounds && !bad.empty() && round <= last + Patience;
         ++round)
    {
      const Progress part =
        progress.Part(static_cast<double>(round) / Rounds, (round + 1.0) / Rounds);
      this->SplitImpossible(bad);
      if (round >= FirstSplitting)
      {
        this->SplitStubborn(this->InvertedCells(), round);
      }
      this->MovePoints(Rings[round], part);
      bad = this->InvertedCells();
      if (bad.size() < least)
      {
        least = bad.size();
        last = round;
      }
    }
    this->Finish(bad);
    return std::move(this->Result);
  }

private:
  std::vector<int> InvertedCells()
  {
    std::vector<int> inverted;
    for (int cell = 0; cell < this->Solid.CellCount(); ++cell)
    {
      if (this->Solid.Inverted(cell))
      {
        inverted.push_back(cell);
      }
    }
    return inverted;
  }

  bool Movable(int point) const
  {
    return !this->Solid.OnBoundary(point) || (this->Sliding && this->Sliding->Freedom(point) > 0);
  }

  /// Inverted tetrahedra without a point that may move get one in an edge between such points, or
  /// in a face, which neighbours share, too.
  void SplitImpossible(const std::vector<int>& bad)
  {
    for (const int cell : bad)
    {
      const std::vector<int> points = this->Solid.PointsOf(cell);
      if (points.size() == 4 &&
        std::none_of(points.begin(), points.end(), [&](int point) { return this->Movable(point); }))
      {
        this->SplitLongest(points) || this->SplitFace(points);
      }
    }
  }

  /// Tetrahedra that stay inverted get room: every edge from their fixed points into the solid is
  /// split, so that what lies around one fixed point can move without what
  /// lies around the others. Where that was done, their longest edge is split.
  void SplitStubborn(const std::vector<int>& bad, int round)
  {
    this->Collared.resize(this->Solid.PointCount(), 0);
    const int allowed = round < FirstCollar ? 0 : 1 + (round - FirstCollar) / RoundsPerCollar;
    std::set<int> collar;
    for (const int cell : bad)
    {
      for (const int point : this->Solid.PointsOf(cell))
      {
        if (!this->Movable(point) && this->Collared[point] < allowed)
        {
          collar.insert(point);
        }
      }
    }
    std::set<int> touched;
    for (const int point : collar)
    {
      ++this->Collared[point];
      std::set<int> ends;
      for (const int cell : this->Solid.CellsOf(point))
      {
        ends.insert(this->Solid.PointsOf(cell).begin(), this->Solid.PointsOf(cell).end());
      }
      ends.erase(point);
      for (const int end : ends)
      {
        if (this->Solid.CanSplit({ point, end }))
        {
          this->Solid.Split({ point, end });
        }
      }
      touched.insert(point);
    }
    for (const int cell : bad)
    {
      const std::vector<int> points = this->Solid.PointsOf(cell);
      if (points.size() != 4 ||
        std::any_of(points.begin(), points.end(), [&](int point) { return touched.count(point); }))
      {
        continue;
      }
      if (this->SplitLongest(points) || this->SplitFace(points))
      {
        touched.insert(this->Solid.PointCount() - 1);
      }
    }
  }

  /// Edges between points that cannot move come first, then those with one.
  bool SplitLongest(const std::vector<int>& points)
  {
    const Eigen::MatrixXd& places =
      this->Solid.Rest.rows() > 0 ? this->Solid.Rest : this->Solid.Points;
    std::pair<int, double> best = { -1, 0.0 };
    std::vector<int> edge;
    for (int a = 0; a < 4; ++a)
    {
      for (int b = 0; b < a; ++b)
      {
        const std::pair<int, double> rank = { !this->Movable(points[a]) + !this->Movable(points[b]),
          (places.row(points[a]) - places.row(points[b])).norm() };
        if (rank > best && this->Solid.CanSplit({ points[a], points[b] }))
        {
          best = rank;
          edge = { points[a], points[b] };
        }
      }
    }
    if (!edge.empty())
    {
      this->Solid.Split(edge);
    }
    return !edge.empty();
  }

  bool SplitFace(const std::vector<int>& points)
  {
    for (int left = 0; left < 4; ++left)
    {
      std::vector<int> face = points;
      face.erase(face.begin() + left);
      if (this->Solid.CanSplit(face))
      {
        this->Solid.Split(face);
        return true;
      }
    }
    return false;
  }

  /// Each set of movable points around inverted cells that hangs together is a patch of its own.
  void MovePoints(int rings, const Progress& progress)
  {
    const Eigen::VectorXd sizes = LogarithmicSizes(this->Solid);
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
        patch.Simplices.push_back(
          { c, HatGradients(this->Solid.Reference(cell, static_cast<int>(k), std::exp(size))) });
        const Eigen::MatrixXd& x = this->Solid.Points;
        before += Orientation(x.row(c[0]), x.row(c[1]), x.row(c[2]), x.row(c[3])) <= 0;
      }
    }
    if (before == 0)
    {
      return;
    }
    PatchOptions options;
    options.MaximumSteps = this->Options.MaximumIterations;
    const Eigen::MatrixXd kept = this->Solid.Points(points, Eigen::all);
    const PatchResult moved =
      LowerEnergy(this->Solid.Points, patch, this->Sliding.get(), options, progress);
    this->Result.Iterations += moved.Steps;
#ifdef UNTANGLE_TRACE
    printf("  patch %zu points %zu simplices neg %d -> %d steps %d energy %g -> %g\n",
      points.size(), patch.Simplices.size(), before, moved.Negative, moved.Steps,
      moved.EnergyBefore, moved.EnergyAfter);
#endif
    if (moved.Negative > before)
    {
      this->Solid.Points(points, Eigen::all) = kept;
    }
  }

  void Finish(const std::vector<int>& bad)
  {
    UntangleResult& result = this->Result;
    result.Solid = this->Solid.Result();
    result.OriginalCell =
      Eigen::Map<const Eigen::VectorXi>(this->Solid.OriginalCells.data(), this->Solid.CellCount());
    result.Parents = this->Solid.Parents;
    result.InvertedAfter = static_cast<int>(bad.size());
    result.Inverted = Eigen::VectorXi::Zero(this->Solid.CellCount());
    for (const int cell : bad)
    {
      result.Inverted(cell) = 1;
    }
    Eigen::VectorXi parts = Eigen::VectorXi::Zero(this->Solid.CellCount());
    for (const int original : this->Solid.OriginalCells)
    {
      ++parts(original);
    }
    result.SplitCells = static_cast<int>((parts.array() > 1).count());
  }

  UntangleOptions Options;
  SolidCells Solid;
  std::unique_ptr<SlidingBoundary> Sliding;
  std::vector<int> Collared; ///< how often the edges of a fixed point were split
  UntangleResult Result;
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
  UntangleResult result = Untangler(cells, rest, options).Run(progress);
  for (Eigen::Index i = 0; i < cells.Points.rows(); ++i)
  {
    result.MovedPoints += result.Solid.Points.row(i) != cells.Points.row(i);
  }
  return result;
}

} // namespace shape
