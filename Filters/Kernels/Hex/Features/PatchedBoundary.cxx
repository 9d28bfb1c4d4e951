#include "Hex/Features/PatchedBoundary.h"

#include "Hex/Features/Private/CurveResampling.h"
#include "Hex/Features/Private/QuadPatches.h"
#include "Mesh/QuadSurface.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// The patches around each point of a boundary.
std::vector<std::set<int>> PatchesAround(const PatchedBoundary& boundary, std::size_t points)
{
  std::vector<std::set<int>> around(points);
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    for (const int point : boundary.Quads.row(q))
    {
      around[point].insert(boundary.PatchOf(q));
    }
  }
  return around;
}

/// The patches around each corner of a surface.
std::vector<std::set<int>> PatchesAroundCorners(
  const Surface& surface, const SurfaceFeatures& features)
{
  std::vector<int> cornerOf(surface.Points().rows(), -1);
  for (std::size_t i = 0; i < features.Corners.size(); ++i)
  {
    cornerOf[features.Corners[i]] = static_cast<int>(i);
  }
  std::vector<std::set<int>> around(features.Corners.size());
  for (Eigen::Index t = 0; t < surface.Triangles().rows(); ++t)
  {
    for (const int point : surface.Triangles().row(t))
    {
      if (cornerOf[point] >= 0)
      {
        around[cornerOf[point]].insert(features.PatchOf(t));
      }
    }
  }
  return around;
}

/// Returns the patches of a surface. A single patch is the surface itself, so that its search tree
/// is reused.
std::vector<Surface> PatchesOf(const Surface& surface, const SurfaceFeatures& features)
{
  if (features.Patches == 1)
  {
    return { surface };
  }
  std::vector<Mesh> patches = SplitIntoPatches(surface, features);
  return { std::make_move_iterator(patches.begin()), std::make_move_iterator(patches.end()) };
}

/// A chain of edges between two patches of the quads.
struct Chain
{
  std::vector<int> Points;
  std::array<int, 2> Patches;
  std::array<int, 2> Corners; ///< its end corners, ascending; -1 if it is closed
};

class Matcher
{
public:
  Matcher(const HexMesh& mesh, const shape::Surface& surface, const SurfaceFeatures& features,
    PatchedBoundary& boundary)
    : Points(mesh.Points)
    , Surface(surface)
    , Features(features)
    , Boundary(boundary)
    , Around(PatchesAround(boundary, mesh.Points.rows()))
  {
    boundary.CurveOf.assign(mesh.Points.rows(), -1);
    boundary.CornerOf.assign(mesh.Points.rows(), -1);
  }

  bool Run() { return this->MatchCorners() && this->FindChains() && this->MatchCurves(); }

private:
  /// Pairs corners with points of the quads between the same patches, the nearest first. Their
  /// numbers must agree.
  bool MatchCorners()
  {
    const auto corners = PatchesAroundCorners(this->Surface, this->Features);
    std::vector<std::pair<double, std::pair<int, int>>> pairs;
    std::size_t junctions = 0;
    for (int point = 0; point < static_cast<int>(this->Around.size()); ++point)
    {
      if (this->Around[point].size() < 3)
      {
        continue;
      }
      ++junctions;
      for (int corner = 0; corner < static_cast<int>(corners.size()); ++corner)
      {
        if (corners[corner] == this->Around[point])
        {
          const double distance =
            (this->Points.row(point) - this->Surface.Points().row(this->Features.Corners[corner]))
              .norm();
          pairs.push_back({ distance, { point, corner } });
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<char> taken(corners.size(), 0);
    std::size_t matched = 0;
    for (const auto& [distance, pair] : pairs)
    {
      if (this->Boundary.CornerOf[pair.first] < 0 && !taken[pair.second])
      {
        this->Boundary.CornerOf[pair.first] = pair.second;
        taken[pair.second] = 1;
        ++matched;
      }
    }
    return matched == corners.size() && matched == junctions;
  }

  bool FindChains()
  {
    const QuadSurface quads(this->Boundary.Quads);
    std::map<QuadEdge, int> patches;
    for (const auto& [edge, quad] : quads.Edges())
    {
      patches[edge] = this->Boundary.PatchOf(quad);
    }
    std::map<int, std::vector<int>> neighbours;
    for (const auto& [edge, patch] : patches)
    {
      const auto other = patches.find({ edge.second, edge.first });
      if (other->second != patch)
      {
        neighbours[edge.first].push_back(edge.second);
      }
    }
    std::set<QuadEdge> taken;
    const auto isCorner = [&](int point) { return this->Boundary.CornerOf[point] >= 0; };
    const auto follow = [&](int first, int second)
    {
      if (taken.count({ first, second }) > 0)
      {
        return;
      }
      const int a = patches.at({ first, second }), b = patches.at({ second, first });
      Chain chain{ { first }, { std::min(a, b), std::max(a, b) }, { -1, -1 } };
      for (int before = first, point = second;;)
      {
        taken.insert({ before, point });
        taken.insert({ point, before });
        if (point == first && !isCorner(point))
        {
          break;
        }
        chain.Points.push_back(point);
        if (isCorner(point))
        {
          chain.Corners = { this->Boundary.CornerOf[first], this->Boundary.CornerOf[point] };
          std::sort(chain.Corners.begin(), chain.Corners.end());
          break;
        }
        const std::vector<int>& next = neighbours.at(point);
        const int after = next[0] == before ? next[1] : next[0];
        before = point;
        point = after;
      }
      this->Chains.push_back(std::move(chain));
    };
    for (const bool corners : { true, false })
    {
      for (const auto& [point, next] : neighbours)
      {
        if (isCorner(point) == corners)
        {
          for (const int end : next)
          {
            follow(point, end);
          }
        }
      }
    }
    return true;
  }

  /// Returns the mean distance of the chain's points from a curve.
  double Distance(const Chain& chain, const FeatureCurve& curve) const
  {
    double sum = 0.0;
    for (const int point : chain.Points)
    {
      sum += (this->Surface.Points()(curve.Points, Eigen::all).rowwise() - this->Points.row(point))
               .rowwise()
               .norm()
               .minCoeff();
    }
    return sum / static_cast<double>(chain.Points.size());
  }

  void PutOnCurve(const Chain& chain, int id)
  {
    const FeatureCurve& curve = this->Features.Curves[id];
    const CurvePositions positions =
      DistributeAlongCurve(this->Points(chain.Points, Eigen::all), this->Surface, curve);
    for (std::size_t i = 0; i < chain.Points.size(); ++i)
    {
      const int point = chain.Points[i];
      const int corner = this->Boundary.CornerOf[point];
      if (corner < 0)
      {
        this->Boundary.CurveOf[point] = id;
        this->Boundary.Starts.emplace_back(
          point, positions.Positions.row(static_cast<Eigen::Index>(i)));
        this->Boundary.Spans[point] = positions.Spans[i];
      }
      else
      {
        this->Boundary.Starts.emplace_back(
          point, this->Surface.Points().row(this->Features.Corners[corner]));
      }
    }
  }

  bool MatchCurves()
  {
    this->Boundary.Starts.clear();
    this->Boundary.Spans.clear();
    if (this->Chains.size() != this->Features.Curves.size())
    {
      return false;
    }
    std::map<int, int> cornerOf;
    for (std::size_t i = 0; i < this->Features.Corners.size(); ++i)
    {
      cornerOf[this->Features.Corners[i]] = static_cast<int>(i);
    }
    std::vector<std::pair<double, std::pair<int, int>>> pairs;
    for (int j = 0; j < static_cast<int>(this->Features.Curves.size()); ++j)
    {
      const FeatureCurve& curve = this->Features.Curves[j];
      std::array<int, 2> ends = { -1, -1 };
      if (!curve.Closed)
      {
        ends = { cornerOf.at(curve.Points.front()), cornerOf.at(curve.Points.back()) };
        std::sort(ends.begin(), ends.end());
      }
      for (int i = 0; i < static_cast<int>(this->Chains.size()); ++i)
      {
        if (this->Chains[i].Patches == curve.Patches && this->Chains[i].Corners == ends)
        {
          pairs.push_back({ this->Distance(this->Chains[i], curve), { i, j } });
        }
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::vector<char> chainTaken(this->Chains.size(), 0), curveTaken(this->Chains.size(), 0);
    std::size_t matched = 0;
    for (const auto& [distance, pair] : pairs)
    {
      if (!chainTaken[pair.first] && !curveTaken[pair.second])
      {
        chainTaken[pair.first] = curveTaken[pair.second] = 1;
        ++matched;
        this->PutOnCurve(this->Chains[pair.first], pair.second);
      }
    }
    return matched == this->Chains.size();
  }

  const Eigen::MatrixXd& Points;
  const shape::Surface& Surface;
  const SurfaceFeatures& Features;
  PatchedBoundary& Boundary;
  const std::vector<std::set<int>> Around;
  std::vector<Chain> Chains;
};

} // namespace

std::optional<PatchedBoundary> MatchFeatures(
  const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features)
{
  PatchedBoundary boundary;
  boundary.Quads = FindBoundaryQuads(mesh);
  boundary.Patches = PatchesOf(surface, features);
  boundary.PatchOf = AssignQuadsToPatches(
    mesh.Points, QuadSurface(boundary.Quads), surface, features, boundary.Patches);
  if (boundary.PatchOf.size() == 0 || !Matcher(mesh, surface, features, boundary).Run())
  {
    return std::nullopt;
  }
  return boundary;
}

bool MatchCurves(const HexMesh& mesh, const Surface& surface, const SurfaceFeatures& features,
  PatchedBoundary& boundary)
{
  return Matcher(mesh, surface, features, boundary).Run();
}

} // namespace shape
