#include "Remesh/SurfaceFeatures.h"

#include "Base/DisjointSets.h"
#include "Mesh/HalfEdges.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// An edge between two triangles.
struct Hinge
{
  int Low, High;
  std::array<int, 2> Triangles;
  double Length;
  bool Sharp;
  double Angle; ///< inside, in degrees
  bool IsCrease = Sharp;
};

/// Creases fade out: where one ends, it goes on along the shortest way over edges whose normals are
/// at least this share of the angle apart, to another crease. Without such a way it stays as it is.
constexpr double FadingShare = 0.375;
/// Patches of a smaller share of the area are as noise makes them; where the borders of others are
/// less than such a share of what is sharp, all of that is noise.
constexpr double NoiseArea = 1e-3, MinimumCurves = 2.0 / 3.0;
/// A way that meets a crease at a smaller angle, in degrees, would bound too sharp a tip.
constexpr double MinimumTip = 50.0;

std::vector<Hinge> FindHinges(const Surface& surface, double angle)
{
  const Mesh& mesh = surface;
  const Eigen::MatrixXd normals = surface.AreaVectors().rowwise().normalized();
  const double minimum = std::cos(angle * M_PI / 180.0);
  const std::vector<HalfEdge>& halves = surface.HalfEdges();
  std::vector<Hinge> hinges;
  for (std::size_t i = 0; i + 1 < halves.size(); ++i)
  {
    const HalfEdge &a = halves[i], &b = halves[i + 1];
    if (a.Low() != b.Low() || a.High() != b.High())
    {
      continue; // on the boundary
    }
    const double length = (mesh.Points.row(a.Begin) - mesh.Points.row(a.End)).norm();
    const double cosine = normals.row(a.Triangle).dot(normals.row(b.Triangle));
    const Eigen::RowVector3d across =
      mesh.Points.row(mesh.Triangles(b.Triangle, (b.Corner + 2) % 3)) - mesh.Points.row(a.Begin);
    const double turn = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180.0 / M_PI;
    const double inside = across.dot(normals.row(a.Triangle)) > 0.0 ? 180.0 + turn : 180.0 - turn;
    hinges.push_back(
      { a.Low(), a.High(), { a.Triangle, b.Triangle }, length, cosine < minimum, inside });
  }
  return hinges;
}

/// Ways from the ends of creases over edges that are less sharp, to other creases.
class FadingCreases
{
public:
  FadingCreases(const Mesh& mesh, std::vector<Hinge>& hinges, double angle)
    : Points(mesh.Points)
    , Hinges(hinges)
  {
    for (int i = 0; i < static_cast<int>(hinges.size()); ++i)
    {
      constexpr double straight = 180.0;
      if (hinges[i].Sharp || std::abs(hinges[i].Angle - straight) > FadingShare * angle)
      {
        this->At[hinges[i].Low].push_back(i);
        this->At[hinges[i].High].push_back(i);
      }
    }
  }

  void Extend()
  {
    for (const auto& [point, edges] : this->At)
    {
      if (this->Creases(point) == 1)
      {
        this->ExtendFrom(point);
      }
    }
  }

private:
  int Creases(int point) const
  {
    const std::vector<int>& edges = this->At.at(point);
    return static_cast<int>(std::count_if(
      edges.begin(), edges.end(), [&](int edge) { return this->Hinges[edge].IsCrease; }));
  }

  /// Dijkstra's algorithm to the closest point on a crease.
  void ExtendFrom(int end)
  {
    std::map<int, std::pair<double, int>> reached = { { end, { 0.0, -1 } } }; // length, last edge
    std::set<std::pair<double, int>> open = { { 0.0, end } };
    while (!open.empty())
    {
      const auto [length, point] = *open.begin();
      open.erase(open.begin());
      if (point != end && this->Creases(point) > 0)
      {
        if (!this->IsTip(point, end))
        {
          this->MarkWay(end, point, reached);
        }
        return;
      }
      for (const int edge : this->At.at(point))
      {
        const Hinge& hinge = this->Hinges[edge];
        const int next = hinge.Low == point ? hinge.High : hinge.Low;
        const double sum = length + hinge.Length;
        if (const auto before = reached.find(next);
            !hinge.IsCrease && (before == reached.end() || sum < before->second.first))
        {
          reached[next] = { sum, edge };
          open.insert({ sum, next });
        }
      }
    }
  }

  int Beyond(int point, int edge) const
  {
    const Hinge& hinge = this->Hinges[edge];
    return hinge.Low == point ? hinge.High : hinge.Low;
  }

  /// From a point along a crease to where it is some way off, or forks.
  Eigen::RowVector3d Chord(int point, int edge, double length) const
  {
    const Eigen::RowVector3d begin = this->Points.row(point);
    point = this->Beyond(point, edge);
    constexpr int maximum = 1000; // of a closed crease that stays near, some
    for (int i = 0; i < maximum && (this->Points.row(point) - begin).norm() < length &&
         this->Creases(point) == 2;
         ++i)
    {
      const std::vector<int>& edges = this->At.at(point);
      edge = *std::find_if(edges.begin(), edges.end(),
        [&](int other) { return other != edge && this->Hinges[other].IsCrease; });
      point = this->Beyond(point, edge);
    }
    return this->Points.row(point) - begin;
  }

  bool IsTip(int point, int end) const
  {
    const Eigen::RowVector3d way = this->Points.row(end) - this->Points.row(point);
    const std::vector<int>& edges = this->At.at(point);
    return std::any_of(edges.begin(), edges.end(),
      [&](int edge)
      {
        return this->Hinges[edge].IsCrease &&
          this->Chord(point, edge, way.norm()).normalized().dot(way.normalized()) >
          std::cos(MinimumTip * M_PI / 180.0);
      });
  }

  void MarkWay(int end, int point, const std::map<int, std::pair<double, int>>& reached)
  {
    while (point != end)
    {
      const int edge = reached.at(point).second;
      this->Hinges[edge].IsCrease = true;
      point = this->Beyond(point, edge);
    }
  }

  const Eigen::MatrixXd& Points;
  std::vector<Hinge>& Hinges;
  std::map<int, std::vector<int>> At; ///< of each point the edges that are sharp, or nearly so
};

/// Unites the smallest patch with the one it has the longest border with until none is too small.
void UniteSmall(DisjointSets& sets, const std::vector<Hinge>& hinges, const Eigen::VectorXd& areas,
  double minimum)
{
  std::map<int, double> sizes;
  for (int t = 0; t < static_cast<int>(areas.size()); ++t)
  {
    sizes[sets.Find(t)] += areas(t);
  }
  std::map<int, std::map<int, double>> boundaries;
  for (const Hinge& hinge : hinges)
  {
    const int a = sets.Find(hinge.Triangles[0]), b = sets.Find(hinge.Triangles[1]);
    if (a != b)
    {
      boundaries[a][b] += hinge.Length;
      boundaries[b][a] += hinge.Length;
    }
  }
  const auto bySecond = [](const auto& a, const auto& b) { return a.second < b.second; };
  std::set<std::pair<double, int>> order;
  for (const auto& [patch, size] : sizes)
  {
    order.emplace(size, patch);
  }
  while (!order.empty() && order.begin()->first < minimum)
  {
    const auto [size, gone] = *order.begin();
    order.erase(order.begin());
    if (boundaries.count(gone) == 0)
    {
      continue; // a component of its own
    }
    const auto around = boundaries[gone];
    const int into = std::max_element(around.begin(), around.end(), bySecond)->first;
    sets.Merge(gone, into);
    for (const auto& [other, length] : around)
    {
      boundaries[other].erase(gone);
      if (other != into)
      {
        boundaries[other][into] += length;
        boundaries[into][other] += length;
      }
      if (boundaries[other].empty())
      {
        boundaries.erase(other);
      }
    }
    boundaries.erase(gone);
    order.erase({ sizes[into], into });
    sizes[into] += size;
    order.emplace(sizes[into], into);
  }
}

bool IsNoise(DisjointSets sets, const std::vector<Hinge>& hinges, const Eigen::VectorXd& areas)
{
  UniteSmall(sets, hinges, areas, NoiseArea * areas.sum());
  double sharp = 0.0, curves = 0.0;
  for (const Hinge& hinge : hinges)
  {
    const bool isCurve = sets.Find(hinge.Triangles[0]) != sets.Find(hinge.Triangles[1]);
    sharp += hinge.Sharp ? hinge.Length : 0.0;
    curves += hinge.Sharp && isCurve ? hinge.Length : 0.0;
  }
  return curves < MinimumCurves * sharp;
}

/// The borders between patches, walked from corner to corner.
class CurveWalk
{
public:
  CurveWalk(const std::vector<Hinge>& hinges, const Eigen::VectorXi& patchOf)
  {
    for (const Hinge& hinge : hinges)
    {
      std::array<int, 2> patches = { patchOf(hinge.Triangles[0]), patchOf(hinge.Triangles[1]) };
      if (patches[0] != patches[1])
      {
        std::sort(patches.begin(), patches.end());
        this->Edges.push_back(
          { { hinge.Low, hinge.High }, patches, hinge.Length, hinge.Angle, false });
        this->At[hinge.Low].push_back(static_cast<int>(this->Edges.size()) - 1);
        this->At[hinge.High].push_back(static_cast<int>(this->Edges.size()) - 1);
      }
    }
  }

  void Run(SurfaceFeatures& features)
  {
    for (const auto& [point, edges] : this->At)
    {
      if (this->IsCorner(point))
      {
        features.Corners.push_back(point);
        for (const int edge : edges)
        {
          this->Follow(point, edge, features.Curves);
        }
      }
    }
    for (std::size_t edge = 0; edge < this->Edges.size(); ++edge)
    {
      this->Follow(this->Edges[edge].Ends[0], static_cast<int>(edge), features.Curves);
    }
  }

private:
  struct Edge
  {
    std::array<int, 2> Ends, Patches;
    double Length, Angle;
    bool Taken;
  };

  bool IsCorner(int point) const
  {
    const std::vector<int>& edges = this->At.at(point);
    return edges.size() != 2 || this->Edges[edges[0]].Patches != this->Edges[edges[1]].Patches;
  }

  void Follow(int first, int edge, std::vector<FeatureCurve>& curves)
  {
    if (this->Edges[edge].Taken)
    {
      return;
    }
    FeatureCurve curve;
    curve.Patches = this->Edges[edge].Patches;
    curve.Points = { first };
    double length = 0.0;
    for (int point = first;;)
    {
      this->Edges[edge].Taken = true;
      length += this->Edges[edge].Length;
      curve.Angle += this->Edges[edge].Length * this->Edges[edge].Angle;
      const std::array<int, 2>& ends = this->Edges[edge].Ends;
      point = ends[0] == point ? ends[1] : ends[0];
      if (point == first && !this->IsCorner(point))
      {
        curve.Closed = true;
        break;
      }
      curve.Points.push_back(point);
      if (this->IsCorner(point))
      {
        break;
      }
      const std::vector<int>& edges = this->At.at(point);
      edge = edges[0] == edge ? edges[1] : edges[0];
    }
    curve.Angle /= length;
    curves.push_back(std::move(curve));
  }

  std::vector<Edge> Edges;
  std::map<int, std::vector<int>> At; ///< the edges at each point
};

} // namespace

SurfaceFeatures FindFeatures(const Surface& surface, double angle, double minimumArea)
{
  const auto triangles = static_cast<int>(surface.Triangles().rows());
  std::vector<Hinge> hinges = FindHinges(surface, angle);
  FadingCreases(surface, hinges, angle).Extend();
  DisjointSets sets(triangles);
  for (const Hinge& hinge : hinges)
  {
    if (!hinge.IsCrease)
    {
      sets.Merge(hinge.Triangles[0], hinge.Triangles[1]);
    }
  }
  const Eigen::VectorXd areas = 0.5 * surface.AreaVectors().rowwise().norm();
  if (IsNoise(sets, hinges, areas))
  {
    minimumArea = std::numeric_limits<double>::infinity();
  }
  UniteSmall(sets, hinges, areas, minimumArea);
  SurfaceFeatures features;
  features.PatchOf.resize(triangles);
  std::map<int, int> numbers;
  for (int t = 0; t < triangles; ++t)
  {
    features.PatchOf(t) =
      numbers.emplace(sets.Find(t), static_cast<int>(numbers.size())).first->second;
  }
  features.Patches = static_cast<int>(numbers.size());
  for (const Hinge& hinge : hinges)
  {
    features.CreaseLength += hinge.Sharp ? hinge.Length : 0.0;
    const bool isCurve =
      features.PatchOf(hinge.Triangles[0]) != features.PatchOf(hinge.Triangles[1]);
    features.CurveLength += hinge.Sharp && isCurve ? hinge.Length : 0.0;
  }
  CurveWalk(hinges, features.PatchOf).Run(features);
  return features;
}

SurfaceFeatures RemoveCurves(const SurfaceFeatures& features)
{
  SurfaceFeatures none;
  none.PatchOf = Eigen::VectorXi::Zero(features.PatchOf.size());
  none.Patches = 1;
  none.CreaseLength = features.CreaseLength;
  return none;
}

std::vector<Mesh> SplitIntoPatches(const Mesh& mesh, const SurfaceFeatures& features)
{
  std::vector<std::vector<int>> own(features.Patches);
  for (int t = 0; t < static_cast<int>(features.PatchOf.size()); ++t)
  {
    own[features.PatchOf(t)].push_back(t);
  }
  std::vector<Mesh> patches;
  for (const std::vector<int>& triangles : own)
  {
    Mesh patch;
    patch.Triangles = mesh.Triangles(triangles, Eigen::all);
    std::vector<int> used(patch.Triangles.data(), patch.Triangles.data() + patch.Triangles.size());
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    patch.Points = mesh.Points(used, Eigen::all);
    for (int& point : patch.Triangles.reshaped())
    {
      point = static_cast<int>(std::lower_bound(used.begin(), used.end(), point) - used.begin());
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

} // namespace shape
