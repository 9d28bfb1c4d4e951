#include "Correspondence/CommonBase/BaseDomain.h"

#include "Base/Errors.h"
#include "Correspondence/CommonBase/BaseGenus.h"
#include "Correspondence/CommonBase/Private/BaseGraph.h"
#include "Correspondence/CommonBase/Private/HomologyBasis.h"
#include "Correspondence/CommonBase/Private/StripPaths.h"
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

/// One of the two surfaces while paths are traced on it.
struct TracedSurface
{
  PathSurface Surface;
  std::string Name;
  std::vector<int> Nodes; ///< the landmarks
  double Size;            ///< the root of the area
  std::vector<std::vector<int>> Paths = {};
  HomologyBasis Basis = {};
  /// For each handle that has been cut, the homology of the loops of its two paths.
  std::vector<std::array<Eigen::VectorXi, 2>> Cuts = {};

  SurfaceGap GapOf(const BaseGraph& graph, int corner) const
  {
    const int point = this->Nodes[graph.NodeOfCorner(corner)];
    if (corner < 0)
    {
      return { point, -1 };
    }
    const std::vector<int>& path = this->Paths[corner / 2];
    return { point, corner % 2 == 0 ? path[1] : path[path.size() - 2] };
  }

  /// Returns the homology of the loop of a path and the tree, without its turns around handles that
  /// have been cut: its intersection numbers with the loops of the cuts are 0.
  Eigen::VectorXi HomologyOf(const FormValues& forms) const
  {
    const Eigen::MatrixXi& linking = this->Basis.Linking;
    Eigen::VectorXi loop(linking.rows());
    for (Eigen::Index i = 0; i < loop.size(); ++i)
    {
      loop(i) = forms[i];
    }
    // The difference of the linking numbers on both sides is the intersection number.
    const Eigen::MatrixXi intersection = linking - linking.transpose();
    for (const auto& [one, other] : this->Cuts)
    {
      const int sign = one.dot(intersection * other); // 1 or -1
      const int alongOne = sign * loop.dot(intersection * other),
                alongOther = -sign * loop.dot(intersection * one);
      loop -= alongOne * one + alongOther * other;
    }
    return loop;
  }
};

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

  void Connect(const Progress& progress)
  {
    const auto joins = [this](int from, int to)
    { return !this->Graph.AreConnected(this->NodeOf(from), this->NodeOf(to)); };
    this->AddShortest(joins, static_cast<int>(this->Graph.Corners().size()) - 1, progress);
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
      side.Basis = FindHomologyBasis(side.Surface, side.Name);
    }
    for (int handle = 0; handle < this->Genus; ++handle)
    {
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
    const int diagonals = 2 * this->Graph.PathCount() - 3;
    std::vector<int> cycles, sizes;
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
  CornerPair ShortestCut(bool isInner, bool isOneCycle, const Progress& progress) const
  {
    std::array<AcceptForms, 2> accept;
    for (int k = 0; k < 2; ++k)
    {
      // A loop bounds inside if it is not linked with any loop outside (BaseDomain.h).
      const Eigen::MatrixXi& linking = this->Sides[k].Basis.Linking;
      const Eigen::MatrixXi matrix = isInner ? Eigen::MatrixXi(linking.transpose()) : linking;
      accept[k] = [matrix, &side = this->Sides[k]](const FormValues& forms)
      {
        const Eigen::VectorXi loop = side.HomologyOf(forms);
        return !loop.isZero() && (matrix * loop).isZero();
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
  int Genus;
  std::array<TracedSurface, 2> Sides;
};

/// The patch of each triangle: filled from the half-edges along the first side of each patch.
Eigen::VectorXi FindPatches(
  const TracedSurface& side, const std::vector<std::array<int, 3>>& patches)
{
  const PathSurface& surface = side.Surface;
  Eigen::VectorXi patchOf = Eigen::VectorXi::Constant(surface.SideCount() / 3, -1);
  for (std::size_t patch = 0; patch < patches.size(); ++patch)
  {
    const int first = patches[patch][0];
    const std::vector<int>& path = side.Paths[first / 2];
    std::vector<int> open{
      (first % 2 == 0 ? surface.Find(path[0], path[1]) : surface.Find(path[1], path[0])) / 3
    };
    patchOf(open[0]) = static_cast<int>(patch);
    while (!open.empty())
    {
      const int triangle = open.back();
      open.pop_back();
      for (int edge = 3 * triangle; edge < 3 * triangle + 3; ++edge)
      {
        const int next = surface.Twin(edge) / 3;
        if (surface.PathOf(edge) < 0 && patchOf(next) < 0)
        {
          patchOf(next) = static_cast<int>(patch);
          open.push_back(next);
        }
      }
    }
  }
  return patchOf;
}

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
    patched.Patches = FindPatches(side, domain.Patches);
    patched.Paths = side.Paths;
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

BaseDomain TraceBaseDomain(
  const Surface& a, const Surface& b, const Landmarks& landmarks, const Progress& progress)
{
  RequirePair(a, b, landmarks);
  BaseTracing tracing(a, b, landmarks, ComputeGenus(a.Topology()));
  tracing.Connect(progress.Part(0.0, 0.3));
  tracing.CutHandles(progress.Part(0.3, 0.6));
  tracing.Triangulate(progress.Part(0.6, 1.0));
  return tracing.Result();
}

} // namespace shape
