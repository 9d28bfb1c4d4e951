#include "Correspondence/CommonBase/BaseDomain.h"

#include "Base/Errors.h"
#include "Correspondence/CommonBase/BaseGenus.h"
#include "Correspondence/CommonBase/Private/BaseCurves.h"
#include "Correspondence/CommonBase/Private/BaseGraph.h"
#include "Correspondence/CommonBase/Private/StripPaths.h"
#include "Correspondence/CommonBase/Private/TracedSurface.h"
#include "Correspondence/Pair/MatchingInput.h"
#include "Mesh/Topology.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <queue>
#include <string>
#include <tuple>
#include <utility>

namespace shape
{
namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

/// Two corners, and the lengths of the paths between them, divided by the surfaces' sizes.
struct CornerPair
{
  int From, To;
  double Length;
  std::array<StripPath, 2> Paths;
};

class BaseTracing
{
public:
  BaseTracing(const Surface& a, const Surface& b, const Landmarks& landmarks, int genus)
    : Graph(static_cast<int>(landmarks.size()))
    , Genus(genus)
    , Sides{ { { PathSurface(a), "SurfaceA", PointsOf(landmarks, 0), std::sqrt(ComputeArea(a)) },
        { PathSurface(b), "SurfaceB", PointsOf(landmarks, 1), std::sqrt(ComputeArea(b)) } } }
  {
  }

  void AddCurves(const std::vector<CurvePair>& curves)
  {
    std::vector<CurvePiece> pieces =
      DivideCurves(curves, { &this->Sides[0].Surface, &this->Sides[1].Surface },
        { &this->Sides[0].Nodes, &this->Sides[1].Nodes });
    this->Graph = BaseGraph(static_cast<int>(this->Sides[0].Nodes.size()));
    for (CurvePiece& piece : pieces)
    {
      this->AddPiece(piece);
    }
  }

  void Connect(const Progress& progress)
  {
    const auto joins = [this](int from, int to)
    { return !this->Graph.AreConnected(this->NodeOf(from), this->NodeOf(to)); };
    this->AddShortest(joins, this->Graph.ComponentCount() - 1, progress);
  }

  void CutHandles(const Progress& progress)
  {
    if (this->Genus == 0)
    {
      return;
    }
    for (TracedSurface& side : this->Sides)
    {
      side.Surface.SplitChords();
      side.Basis = FindHomologyBasis(side.Surface, this->IsClosing, side.Name);
    }
    for (int path = 0; path < static_cast<int>(this->IsClosing.size()); ++path)
    {
      if (this->IsClosing[path])
      {
        this->CutAcross(path, progress);
      }
    }
    while (this->HandlesCut() < this->Genus)
    {
      const int handle = this->HandlesCut();
      const Progress part =
        progress.Part(static_cast<double>(handle) / this->Genus, (handle + 1.0) / this->Genus);
      const CornerPair inner = this->ShortestCut(true, true, part.Part(0.0, 0.3)),
                       outer = this->ShortestCut(false, true, part.Part(0.3, 0.6));
      const bool isInner = inner.Length < outer.Length;
      const CornerPair& first = isInner ? inner : outer;
      this->Add(first, handle);
      const CornerPair second = this->ShortestCut(!isInner, false, part.Part(0.6, 1.0));
      this->Add(second, handle);
      for (int k = 0; k < 2; ++k)
      {
        TracedSurface& side = this->Sides[k];
        side.Cuts.push_back(
          { side.HomologyOf(first.Paths[k].Forms), side.HomologyOf(second.Paths[k].Forms) });
      }
    }
  }

  void Triangulate(const Progress& progress)
  {
    // A disk with n sides needs n - 3 diagonals.
    std::vector<int> cycles = this->Graph.BoundaryCycles();
    const int disks = *std::max_element(cycles.begin(), cycles.end()) + 1;
    const int diagonals = 2 * this->Graph.PathCount() - 3 * disks;
    int known = -1;
    const auto divides = [&](int from, int to)
    {
      if (known != this->Graph.PathCount())
      {
        known = this->Graph.PathCount();
        cycles = this->Graph.BoundaryCycles();
      }
      return cycles[from] == cycles[to] && this->Graph.NextAround(from) != to &&
        this->Graph.NextAround(to) != from;
    };
    this->AddShortest(divides, diagonals, progress);
  }

  BaseDomain Result();

private:
  int NodeOf(int corner) const { return this->Graph.NodeOfCorner(corner); }
  int HandlesCut() const { return static_cast<int>(this->Sides[0].Cuts.size()); }

  void AddPiece(CurvePiece& piece)
  {
    std::array<int, 2> corners;
    for (int end = 0; end < 2; ++end)
    {
      std::array<int, 2> found;
      for (int k = 0; k < 2; ++k)
      {
        const std::vector<int>& points = piece.Points[k];
        found[k] = this->Sides[k].CornerBefore(
          this->Graph, piece.Nodes[end], end == 0 ? points[1] : points[points.size() - 2]);
      }
      if (found[0] != found[1])
      {
        throw InvalidInput("curves leave landmark " + std::to_string(piece.Nodes[end]) +
          " in different orders on SurfaceA and SurfaceB; leave one out");
      }
      corners[end] = found[0];
    }
    this->IsClosing.push_back(this->Graph.AreConnected(piece.Nodes[0], piece.Nodes[1]));
    const int path = this->Graph.Add(corners[0], corners[1]);
    for (int k = 0; k < 2; ++k)
    {
      TracedSurface& side = this->Sides[k];
      for (std::size_t i = 1; i < piece.Points[k].size(); ++i)
      {
        side.Surface.Mark(side.Surface.Find(piece.Points[k][i - 1], piece.Points[k][i]), path);
      }
      side.Paths.push_back(std::move(piece.Points[k]));
    }
  }

  using LoopPair = std::array<Eigen::VectorXi, 2>; ///< a loop of each surface

  /// Returns the loops that a path closes with the tree.
  LoopPair LoopsOf(int path) const
  {
    LoopPair loops;
    for (int k = 0; k < 2; ++k)
    {
      loops[k] = this->Sides[k].HomologyOf(this->Sides[k].FormsAlong(path));
    }
    return loops;
  }

  /// Whether loops that go around handles bound on the same side of both surfaces.
  bool DoBound(const LoopPair& loops, bool inside) const
  {
    return !loops[0].isZero() && !loops[1].isZero() && this->Sides[0].Bounds(loops[0], inside) &&
      this->Sides[1].Bounds(loops[1], inside);
  }

  bool DoCross(const LoopPair& one, const LoopPair& other) const
  {
    return std::abs(this->Sides[0].Crossings(one[0], other[0])) == 1 &&
      std::abs(this->Sides[1].Crossings(one[1], other[1])) == 1;
  }

  /// Finds the second path of a handle around which a curve closes a loop: another curve, or a new
  /// path. Does nothing if the curve closes another loop.
  void CutAcross(int path, const Progress& progress)
  {
    const LoopPair loops = this->LoopsOf(path);
    if (loops[0].isZero() && loops[1].isZero())
    {
      return;
    }
    const bool isInner = this->DoBound(loops, true);
    if (!isInner && !this->DoBound(loops, false))
    {
      throw InvalidInput("the curves with landmarks " +
        std::to_string(this->Graph.NodeOf(2 * path)) + " and " +
        std::to_string(this->Graph.NodeOf(2 * path + 1)) +
        " close a loop that does not bound alike on both surfaces, inside or outside; leave one "
        "out");
    }
    LoopPair second;
    for (int other = path + 1; other < static_cast<int>(this->IsClosing.size()); ++other)
    {
      const LoopPair candidate = this->IsClosing[other] ? this->LoopsOf(other) : LoopPair();
      if (this->IsClosing[other] && second[0].size() == 0 && this->DoBound(candidate, !isInner) &&
        this->DoCross(candidate, loops))
      {
        second = candidate;
      }
    }
    if (second[0].size() == 0)
    {
      const CornerPair across = this->ShortestCut(!isInner, false, progress, loops);
      this->Add(across, this->HandlesCut());
      for (int k = 0; k < 2; ++k)
      {
        second[k] = this->Sides[k].HomologyOf(across.Paths[k].Forms);
      }
    }
    for (int k = 0; k < 2; ++k)
    {
      this->Sides[k].Cuts.push_back({ loops[k], second[k] });
    }
  }

  /// Finds the paths between a corner and others on both surfaces.
  /// longest: the lengths beyond which there is no search, divided by the surfaces' sizes.
  std::vector<CornerPair> FindPaths(int from, const std::vector<int>& to,
    const std::array<AcceptForms, 2>& accept = {}, double longest = Infinity) const
  {
    std::vector<CornerPair> pairs;
    for (const int corner : to)
    {
      pairs.push_back({ from, corner, 0.0, {} });
    }
    for (int k = 0; k < 2; ++k)
    {
      const TracedSurface& side = this->Sides[k];
      std::vector<SurfaceGap> gaps;
      for (const int corner : to)
      {
        gaps.push_back(side.GapOf(this->Graph, corner));
      }
      std::vector<StripPath> paths = FindStripPaths(
        side.Surface, side.GapOf(this->Graph, from), gaps, accept[k], longest * side.Size);
      for (std::size_t i = 0; i < pairs.size(); ++i)
      {
        pairs[i].Length += paths[i].Length / side.Size;
        pairs[i].Paths[k] = std::move(paths[i]);
      }
    }
    for (CornerPair& pair : pairs)
    {
      // A path from a landmark to itself is the last choice.
      constexpr double penalty = 1e3;
      pair.Length += this->NodeOf(pair.From) == this->NodeOf(pair.To) ? penalty : 0.0;
    }
    return pairs;
  }

  void Add(const CornerPair& pair, int handle = -1)
  {
    if (!(pair.Length < Infinity))
    {
      throw SolveFailure(handle < 0
          ? "no path joins landmarks " + std::to_string(this->NodeOf(pair.From)) + " and " +
            std::to_string(this->NodeOf(pair.To)) + "; give other landmarks"
          : "no path between landmarks goes around handle " + std::to_string(handle + 1) +
            " on both surfaces without crossing itself; give landmarks on each handle");
    }
    const int path = this->Graph.Add(pair.From, pair.To);
    for (int k = 0; k < 2; ++k)
    {
      TracedSurface& side = this->Sides[k];
      side.Paths.push_back(ImprintStripPath(side.Surface, pair.Paths[k], path));
    }
  }

  /// Adds the shortest path between two corners for which `isAllowed` is true, `count` times.
  void AddShortest(
    const std::function<bool(int, int)>& isAllowed, int count, const Progress& progress)
  {
    // More paths only lengthen others: the lengths of a pair's paths when last computed are lower
    // bounds. Those of a pair with a new corner are those of the corner that was divided.
    std::map<std::pair<int, int>, double> bounds;
    using Item = std::tuple<double, int, int>;
    std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
    const auto push = [&](int from, int to, double length)
    {
      bounds[{ from, to }] = bounds[{ to, from }] = length;
      queue.emplace(length, from, to);
    };
    const std::vector<int> corners = this->Graph.Corners();
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      std::vector<int> others;
      std::copy_if(corners.begin() + static_cast<std::ptrdiff_t>(i) + 1, corners.end(),
        std::back_inserter(others), [&](int other) { return isAllowed(corners[i], other); });
      for (const CornerPair& pair : this->FindPaths(corners[i], others))
      {
        push(pair.From, pair.To, pair.Length);
      }
      progress(0.5 * static_cast<double>(i) / static_cast<double>(corners.size()));
    }
    for (int added = 0; added < count;)
    {
      if (queue.empty())
      {
        throw SolveFailure("the landmarks cannot be joined by paths; give other landmarks");
      }
      const auto [bound, from, to] = queue.top();
      queue.pop();
      if (bound != bounds[{ from, to }] || !this->Graph.IsCorner(from) ||
        !this->Graph.IsCorner(to) || !isAllowed(from, to))
      {
        continue;
      }
      const CornerPair pair = this->FindPaths(from, { to }).front();
      if (!queue.empty() && pair.Length > std::get<0>(queue.top()))
      {
        push(from, to, pair.Length);
        continue;
      }
      this->Add(pair);
      ++added;
      this->Inherit(pair, bounds, push);
      progress(0.5 + 0.5 * added / count);
    }
  }

  /// Makes pairs of the corners that a path has made.
  template <typename Push>
  void Inherit(const CornerPair& pair, const std::map<std::pair<int, int>, double>& bounds,
    const Push& push) const
  {
    const int first = 2 * (this->Graph.PathCount() - 1);
    const std::array<std::pair<int, int>, 2> divided{ { { pair.From, first },
      { pair.To, first + 1 } } };
    const std::vector<int> corners = this->Graph.Corners();
    const auto parentOf = [&](int corner) {
      return corner == first ? pair.From : corner == first + 1 ? pair.To : corner;
    };
    for (const auto& [parent, corner] : divided)
    {
      for (const int other : corners)
      {
        const auto bound = bounds.find({ parent, parentOf(other) });
        if (other != corner)
        {
          push(corner, other, bound == bounds.end() ? 0.0 : bound->second);
        }
      }
    }
  }

  /// Returns the shortest path that cuts a handle. isInner: whether its loop bounds inside the
  /// surface, and not outside. isOneCycle: whether it joins a boundary cycle with itself.
  /// across: if given, a loop of each surface that its loop crosses once.
  CornerPair ShortestCut(
    bool isInner, bool isOneCycle, const Progress& progress, const LoopPair& across = {}) const
  {
    std::array<AcceptForms, 2> accept;
    for (int k = 0; k < 2; ++k)
    {
      accept[k] = [isInner, &crossed = across[k], &side = this->Sides[k]](const FormValues& forms)
      {
        const Eigen::VectorXi loop = side.HomologyOf(forms);
        return !loop.isZero() && side.Bounds(loop, isInner) &&
          (crossed.size() == 0 || std::abs(side.Crossings(loop, crossed)) == 1);
      };
    }
    const std::vector<int> cycles = this->Graph.BoundaryCycles();
    const std::vector<int> corners = this->Graph.Corners();
    CornerPair best{ corners[0], corners[0], Infinity, {} };
    // The number of homology classes grows quickly with the length of paths, so short ones come
    // first. The longest ones are as long as a path along any shape that triangles can follow.
    constexpr double first = 0.5, last = 64.0;
    for (double longest = first; longest <= last && !(best.Length < Infinity); longest *= 2.0)
    {
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        std::vector<int> others;
        std::copy_if(corners.begin() + static_cast<std::ptrdiff_t>(i) + 1, corners.end(),
          std::back_inserter(others),
          [&](int other) { return (cycles[corners[i]] == cycles[other]) == isOneCycle; });
        for (CornerPair& pair :
          this->FindPaths(corners[i], others, accept, std::min(longest, best.Length)))
        {
          if (pair.Length < best.Length)
          {
            best = std::move(pair);
          }
        }
        progress(static_cast<double>(i) / static_cast<double>(corners.size()));
      }
    }
    return best;
  }

  BaseGraph Graph;
  std::vector<bool> IsClosing; ///< whether each piece of a curve closes a loop with earlier ones
  int Genus;
  std::array<TracedSurface, 2> Sides;
};

BaseDomain BaseTracing::Result()
{
  BaseDomain domain;
  domain.Genus = this->Genus;
  for (int path = 0; path < this->Graph.PathCount(); ++path)
  {
    domain.Paths.push_back({ this->Graph.NodeOf(2 * path), this->Graph.NodeOf(2 * path + 1) });
  }
  for (int side = 0; side < 2 * this->Graph.PathCount(); ++side)
  {
    const int second = this->Graph.NextAround(side), third = this->Graph.NextAround(second);
    if (side < second && side < third)
    {
      domain.Patches.push_back({ side, second, third });
    }
  }
  for (TracedSurface& side : this->Sides)
  {
    side.Surface.SplitChords();
    PatchedSurface& patched = &side == this->Sides.data() ? domain.A : domain.B;
    patched.Surface = side.Surface.ToMesh();
    patched.Patches = side.FindPatches(domain.Patches);
    patched.Paths = side.Paths;
    patched.CurvePaths = static_cast<int>(this->IsClosing.size());
    patched.SplitEdges = side.Surface.SplitEdges();
    const Eigen::Index triangles = patched.Patches.size();
    patched.GivenTriangles.resize(triangles);
    for (int t = 0; t < triangles; ++t)
    {
      const auto& [given, corners] = side.Surface.Given(t);
      patched.GivenTriangles(t) = given;
      patched.GivenBarycentrics.push_back(corners);
    }
  }
  return domain;
}

void RequirePair(const Surface& a, const Surface& b, const Landmarks& landmarks)
{
  RequireClosedSurface(a, "SurfaceA");
  RequireClosedSurface(b, "SurfaceB");
  RequireConnected(a, "SurfaceA");
  RequireConnected(b, "SurfaceB");
  RequireLandmarks(landmarks, a, b);
  const int genus = ComputeGenus(a.Topology()), other = ComputeGenus(b.Topology());
  if (genus != other || genus > MaximumBaseGenus)
  {
    throw InvalidInput("the surfaces have genus " + std::to_string(genus) + " and " +
      std::to_string(other) + ", but a common base domain needs one genus, at most " +
      std::to_string(MaximumBaseGenus) + "; take ReversibleHarmonic");
  }
  const std::size_t minimum = genus == 0 ? 3 : 2;
  if (landmarks.size() < minimum)
  {
    throw InvalidInput("there are " + std::to_string(landmarks.size()) +
      " landmarks, but a common base domain of genus " + std::to_string(genus) + " needs " +
      std::to_string(minimum) + "; give more");
  }
}

} // namespace

BaseDomain TraceBaseDomain(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const std::vector<CurvePair>& curves, const Progress& progress)
{
  RequirePair(a, b, landmarks);
  BaseTracing tracing(a, b, landmarks, ComputeGenus(a.Topology()));
  tracing.AddCurves(curves);
  tracing.Connect(progress.Part(0.0, 0.3));
  tracing.CutHandles(progress.Part(0.3, 0.6));
  tracing.Triangulate(progress.Part(0.6, 1.0));
  return tracing.Result();
}

} // namespace shape
