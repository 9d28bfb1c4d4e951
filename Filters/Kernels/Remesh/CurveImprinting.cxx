#include "Remesh/CurveImprinting.h"

#include "Base/Errors.h"
#include "Planar/TriangleSplit.h"
#include "Remesh/Private/ImprintNodes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace shape
{
namespace
{

using Eigen::RowVector3d;

/// Splits a closed sequence of points at points that occur repeatedly.
std::vector<std::vector<int>> SimpleLoops(const std::vector<int>& sequence)
{
  std::vector<std::vector<int>> loops;
  std::vector<int> open;
  std::map<int, std::size_t> placeOf;
  const auto close = [&](std::size_t begin)
  {
    std::vector<int> loop(open.begin() + static_cast<std::ptrdiff_t>(begin), open.end());
    for (const int point : loop)
    {
      placeOf.erase(point);
    }
    open.resize(begin);
    if (loop.size() > 2) // otherwise it only goes back and forth
    {
      loops.push_back(std::move(loop));
    }
  };
  for (const int point : sequence)
  {
    const auto found = placeOf.find(point);
    if (found != placeOf.end())
    {
      close(found->second);
    }
    placeOf[point] = open.size();
    open.push_back(point);
  }
  close(0);
  return loops;
}

/// Inserts loops, moved to points and edges that they are near to. Construction turns loops into
/// nodes and collects the triangles to split; Insert splits them, joins all triangles and follows
/// the loops over the new edges, in this order.
class LoopInserter
{
public:
  LoopInserter(const Mesh& surface, const std::vector<SurfaceLoop>& loops, double snapShare)
    : Surface(surface)
    , Numbered(surface, snapShare)
  {
    for (const SurfaceLoop& loop : loops)
    {
      this->AddLoop(loop);
    }
    this->AddTrianglesBeside();
  }

  ImprintedCurves Insert(const Progress& progress)
  {
    this->SplitTriangles(progress);
    ImprintedCurves result;
    const Eigen::Index given = this->Surface.Points.rows();
    const auto added = static_cast<Eigen::Index>(this->Numbered.NewPoints().size());
    result.Surface.Points.resize(given + added, 3);
    result.Surface.Points.topRows(given) = this->Surface.Points;
    ProvenanceWriter provenance(given);
    provenance.AddCopies(given);
    for (Eigen::Index i = 0; i < added; ++i)
    {
      const SurfacePoint& position = this->Numbered.NewPoints()[i];
      result.Surface.Points.row(given + i) =
        position.Barycentric * GetCorners(this->Surface, position.Triangle);
      provenance.AddOnTriangle(
        this->Surface.Triangles.row(position.Triangle), position.Barycentric);
    }
    result.Provenance = provenance.Finish(this->JoinTriangles(result.Surface.Triangles));
    this->FindLoops(result);
    return result;
  }

private:
  /// A triangle that is split.
  struct Parted
  {
    std::set<int> Inner;                    ///< new points inside
    std::vector<std::array<int, 2>> Chords; ///< between points on different sides, or inside
    std::vector<std::vector<int>> Chains;   ///< the points along each of them
    std::vector<Eigen::RowVector3i> Triangles;
  };
  /// A loop as nodes, and the triangle between each and the next one.
  struct NodeLoop
  {
    std::vector<ImprintNode> Nodes;
    std::vector<int> Triangles;
  };

  void AddLoop(const SurfaceLoop& loop)
  {
    NodeLoop own;
    for (std::size_t i = 0; i < loop.Positions.size(); ++i)
    {
      const ImprintNode node = this->Numbered.At(loop.Positions[i]);
      if (!own.Nodes.empty() && own.Nodes.back().Id == node.Id)
      {
        own.Triangles.back() = loop.Triangles[i];
        continue;
      }
      if (node.Low < 0)
      {
        this->Split[loop.Positions[i].Triangle].Inner.insert(node.Id);
      }
      own.Nodes.push_back(node);
      own.Triangles.push_back(loop.Triangles[i]);
    }
    for (std::size_t i = 0; i < own.Nodes.size(); ++i)
    {
      const ImprintNode &a = own.Nodes[i], &b = own.Nodes[(i + 1) % own.Nodes.size()];
      if (a.Id != b.Id && FindCommonEdge(a, b).first < 0)
      {
        this->Split[own.Triangles[i]].Chords.push_back({ a.Id, b.Id });
      }
    }
    this->Loops.push_back(std::move(own));
  }

  /// All triangles with an edge that has a new point on it.
  void AddTrianglesBeside()
  {
    std::vector<char> isEnd(this->Surface.Points.rows(), 0);
    for (const auto& [edge, points] : this->Numbered.OnEdges())
    {
      isEnd[edge.first] = isEnd[edge.second] = 1;
    }
    for (int t = 0; t < static_cast<int>(this->Surface.Triangles.rows()); ++t)
    {
      for (int k = 0; k < 3; ++k)
      {
        const int a = this->Surface.Triangles(t, k), b = this->Surface.Triangles(t, (k + 1) % 3);
        if (isEnd[a] != 0 && isEnd[b] != 0 && !this->Numbered.OnEdge(a, b).empty())
        {
          this->Split[t];
        }
      }
    }
  }

  /// Returns the points of a triangle that is split, with their positions in it. The points of its
  /// outline come first; their number is returned.
  int PointsOf(int triangle, const Parted& parted, std::vector<int>& ids,
    std::vector<RowVector3d>& positions) const
  {
    for (int k = 0; k < 3; ++k)
    {
      const int next = (k + 1) % 3;
      const int a = this->Surface.Triangles(triangle, k),
                b = this->Surface.Triangles(triangle, next);
      ids.push_back(a);
      positions.push_back(RowVector3d::Unit(k));
      const std::map<std::int64_t, int>& between = this->Numbered.OnEdge(a, b);
      const auto add = [&](const std::pair<const std::int64_t, int>& point)
      {
        const double along = static_cast<double>(point.first) / ImprintNodes::Parts;
        ids.push_back(point.second);
        positions.emplace_back(RowVector3d::Zero());
        positions.back()(next) = a < b ? along : 1.0 - along;
        positions.back()(k) = 1.0 - positions.back()(next);
      };
      if (a < b)
      {
        std::for_each(between.begin(), between.end(), add);
      }
      else
      {
        std::for_each(between.rbegin(), between.rend(), add);
      }
    }
    const auto outline = static_cast<int>(ids.size());
    for (const int id : parted.Inner)
    {
      ids.push_back(id);
      positions.push_back(this->Numbered.NewPoints()[id - this->Surface.Points.rows()].Barycentric);
    }
    return outline;
  }

  void SplitTriangles(const Progress& progress)
  {
    double done = 0.0;
    for (auto& [triangle, parted] : this->Split)
    {
      progress(done++ / static_cast<double>(this->Split.size()));
      std::vector<int> ids;
      std::vector<RowVector3d> positions;
      // The triangle as a polygon, with the new points on its edges; then the points inside.
      const int outline = this->PointsOf(triangle, parted, ids, positions);
      Eigen::MatrixXd points(positions.size(), 3);
      for (std::size_t i = 0; i < positions.size(); ++i)
      {
        points.row(static_cast<Eigen::Index>(i)) = positions[i];
      }
      const auto localOf = [&](int id)
      { return static_cast<int>(std::find(ids.begin(), ids.end(), id) - ids.begin()); };
      std::vector<std::array<int, 2>> chords;
      for (const auto& [a, b] : parted.Chords)
      {
        chords.push_back({ localOf(a), localOf(b) });
      }
      const TriangleSplit split =
        SplitTriangle(GetCorners(this->Surface, triangle), points, outline, chords);
      for (const auto& added : split.Added.rowwise())
      {
        ids.push_back(this->Numbered.Add({ triangle, added }));
      }
      for (const auto& local : split.Triangles.rowwise())
      {
        parted.Triangles.emplace_back(ids[local(0)], ids[local(1)], ids[local(2)]);
      }
      for (std::vector<int> chain : split.Chords)
      {
        std::transform(chain.begin(), chain.end(), chain.begin(), [&](int i) { return ids[i]; });
        parted.Chains.push_back(std::move(chain));
      }
    }
    progress(1.0);
  }

  /// Writes all triangles, and returns the one that each is a part of.
  Eigen::VectorXi JoinTriangles(Eigen::MatrixXi& triangles) const
  {
    Eigen::Index count = this->Surface.Triangles.rows();
    for (const auto& [triangle, parted] : this->Split)
    {
      count += static_cast<Eigen::Index>(parted.Triangles.size()) - 1;
    }
    triangles.resize(count, 3);
    Eigen::VectorXi originals(count);
    Eigen::Index row = 0;
    auto next = this->Split.begin();
    for (int t = 0; t < static_cast<int>(this->Surface.Triangles.rows()); ++t)
    {
      // The map is ordered by triangle, so one pass suffices.
      if (next == this->Split.end() || next->first != t)
      {
        originals(row) = t;
        triangles.row(row++) = this->Surface.Triangles.row(t);
        continue;
      }
      for (const Eigen::RowVector3i& part : (next++)->second.Triangles)
      {
        originals(row) = t;
        triangles.row(row++) = part;
      }
    }
    return originals;
  }

  /// Returns the points from a node to the next one along an edge, including the first.
  std::vector<int> AlongEdge(
    const PointPair& edge, const ImprintNode& a, const ImprintNode& b) const
  {
    const auto along = [&](const ImprintNode& node)
    {
      // A point of the surface lies at an end of the edge: at 0 or at Parts.
      return node.Low != node.High ? node.Along
        : node.Low == edge.first   ? std::int64_t(0)
                                   : static_cast<std::int64_t>(ImprintNodes::Parts);
    };
    const std::int64_t from = along(a), to = along(b);
    std::vector<int> points;
    for (const auto& [position, id] : this->Numbered.OnEdge(edge.first, edge.second))
    {
      if (position > std::min(from, to) && position < std::max(from, to))
      {
        points.push_back(id);
      }
    }
    if (from > to)
    {
      std::reverse(points.begin(), points.end());
    }
    points.insert(points.begin(), a.Id);
    return points;
  }

  void FindLoops(ImprintedCurves& result) const
  {
    std::map<int, std::size_t> nextChord; // of each triangle
    std::vector<std::pair<double, std::size_t>> order;
    std::vector<std::vector<int>> found;
    std::vector<int> owners;
    for (std::size_t l = 0; l < this->Loops.size(); ++l)
    {
      const NodeLoop& loop = this->Loops[l];
      std::vector<int> sequence;
      for (std::size_t i = 0; i < loop.Nodes.size(); ++i)
      {
        const ImprintNode &a = loop.Nodes[i], &b = loop.Nodes[(i + 1) % loop.Nodes.size()];
        const PointPair edge = FindCommonEdge(a, b);
        std::vector<int> stretch;
        if (edge.first >= 0)
        {
          stretch = this->AlongEdge(edge, a, b);
        }
        else if (a.Id != b.Id)
        {
          // AddLoop added the chords in this order.
          stretch = this->Split.at(loop.Triangles[i]).Chains[nextChord[loop.Triangles[i]]++];
          stretch.pop_back();
        }
        sequence.insert(sequence.end(), stretch.begin(), stretch.end());
      }
      for (std::vector<int>& simple : SimpleLoops(sequence))
      {
        double length = 0.0;
        for (std::size_t i = 0; i < simple.size(); ++i)
        {
          length += (result.Surface.Points.row(simple[(i + 1) % simple.size()]) -
            result.Surface.Points.row(simple[i]))
                      .norm();
        }
        order.emplace_back(-length, found.size());
        found.push_back(std::move(simple));
        owners.push_back(static_cast<int>(l));
      }
    }
    std::sort(order.begin(), order.end());
    for (const auto& [length, index] : order)
    {
      result.Loops.push_back(found[index]);
      result.LoopIds.push_back(owners[index]);
    }
  }

  const Mesh& Surface;
  ImprintNodes Numbered;
  std::map<int, Parted> Split;
  std::vector<NodeLoop> Loops;
};

/// Returns how often loops meet themselves or each other.
int CountTouches(const ImprintedCurves& inserted, std::size_t given)
{
  std::vector<char> isUsed(inserted.Surface.Points.rows(), 0);
  int touches = std::abs(static_cast<int>(inserted.Loops.size()) - static_cast<int>(given));
  for (const std::vector<int>& loop : inserted.Loops)
  {
    for (const int point : loop)
    {
      touches += isUsed[point];
      isUsed[point] = 1;
    }
  }
  return touches;
}

} // namespace

// 1. AddLoop: the loops' positions become nodes: points, positions on edges or inside triangles.
// 2. SplitTriangles: each triangle with a new point is split along the loops (SplitTriangle).
// 3. JoinTriangles: parts and other triangles in the original order.
// 4. FindLoops: the loops are followed along the new edges and split where they touch themselves.
ImprintedCurves ImprintCurves(const Mesh& surface, const std::vector<SurfaceLoop>& loops,
  const CurveImprintingOptions& options, const Progress& progress)
{
  RequireOption(options.SnapShare >= 0.0 && options.SnapShare < 0.5, "SnapShare", options.SnapShare,
    "at least 0 and less than 0.5");
  ImprintedCurves result =
    LoopInserter(surface, loops, options.SnapShare).Insert(progress.Part(0.0, 0.5));
  // Snapping may make loops touch; the result without it is taken if it has fewer touches.
  if (options.SnapShare > 0.0 && CountTouches(result, loops.size()) > 0)
  {
    ImprintedCurves unmoved = LoopInserter(surface, loops, 0.0).Insert(progress.Part(0.5, 1.0));
    if (CountTouches(unmoved, loops.size()) < CountTouches(result, loops.size()))
    {
      result = std::move(unmoved);
    }
  }
  for (int i = 0; i < static_cast<int>(loops.size()); ++i)
  {
    if (std::find(result.LoopIds.begin(), result.LoopIds.end(), i) == result.LoopIds.end())
    {
      throw InvalidInput("loop " + std::to_string(i) +
        " encloses no area, because it returns along the same path; draw a loop around an area");
    }
  }
  progress(1.0);
  return result;
}

} // namespace shape
