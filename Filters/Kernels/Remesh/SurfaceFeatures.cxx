#include "Remesh/SurfaceFeatures.h"

#include "Base/DisjointSets.h"
#include "Mesh/HalfEdges.h"
#include "Remesh/Private/FadingCreases.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// Patches below this fraction of the area are like noise. If the boundaries of the others are less
/// than this fraction of the sharp edges, all of that is noise.
constexpr double NoiseArea = 1e-3, MinimumCurves = 2.0 / 3.0;

/// Edges at the boundary of the surface are no hinges. isSharp: whether an edge between two
/// triangles is sharp, by these and by the cosine of the angle between their normals.
std::vector<Hinge> FindHinges(
  const Surface& surface, const std::function<bool(int, int, double)>& isSharp)
{
  const Mesh& mesh = surface;
  const Eigen::MatrixXd normals = surface.AreaVectors().rowwise().normalized();
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
    // The third corner of b lies above the plane of a at a concave edge.
    const double inside = across.dot(normals.row(a.Triangle)) > 0.0 ? 180.0 + turn : 180.0 - turn;
    hinges.push_back({ a.Low(), a.High(), { a.Triangle, b.Triangle }, length,
      isSharp(a.Triangle, b.Triangle, cosine), inside });
  }
  return hinges;
}

/// Merges the smallest patch into the one with the longest common boundary until none is too small.
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
      continue; // a patch without neighbours
    }
    // The patch that takes it in gets its boundaries with the other neighbours.
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

/// Scattered sharp edges, as in scans, are lost on every grid after a second fit each: they are
/// dropped at once.
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
    // The edges that no corner reaches form closed curves.
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
    // A point where curves end or fork, or where the patches at a curve change.
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
      // Back at the start of a closed curve without a corner.
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

/// Connects the triangles between which there is no crease.
DisjointSets ConnectPatches(const Surface& surface, const std::vector<Hinge>& hinges)
{
  DisjointSets sets(static_cast<int>(surface.Triangles().rows()));
  for (const Hinge& hinge : hinges)
  {
    if (!hinge.IsCrease)
    {
      sets.Merge(hinge.Triangles[0], hinge.Triangles[1]);
    }
  }
  return sets;
}

/// Merges patches below the minimum area and walks the borders between the others.
SurfaceFeatures FeaturesBetween(DisjointSets sets, const std::vector<Hinge>& hinges,
  const Eigen::VectorXd& areas, double minimumArea)
{
  UniteSmall(sets, hinges, areas, minimumArea);
  const auto triangles = static_cast<int>(areas.size());
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

Eigen::VectorXd AreasOf(const Surface& surface)
{
  return 0.5 * surface.AreaVectors().rowwise().norm();
}

/// What the features of all minimum areas have in common.
struct Creases
{
  double Angle;
  std::vector<Hinge> Hinges;
  DisjointSets Patches;  ///< of triangles between which there is no crease
  Eigen::VectorXd Areas; ///< of the triangles
  bool AreNoise;
};

Creases FindCreases(const Surface& surface, double angle)
{
  const double minimum = std::cos(angle * M_PI / 180.0);
  std::vector<Hinge> hinges =
    FindHinges(surface, [&](int, int, double cosine) { return cosine < minimum; });
  ExtendFadingCreases(surface, angle, hinges);
  const DisjointSets patches = ConnectPatches(surface, hinges);
  Eigen::VectorXd areas = AreasOf(surface);
  const bool areNoise = IsNoise(patches, hinges, areas);
  return { angle, std::move(hinges), patches, std::move(areas), areNoise };
}

} // namespace

// 1. FindHinges: edges between two triangles, and which are sharp.
// 2. ExtendFadingCreases: creases that end inside a patch are extended to another one.
// 3. ConnectPatches: triangles connected without a crease form a patch.
// 4. IsNoise, UniteSmall: patches that are too small are merged; all of them if creases are noise.
// 5. CurveWalk: the borders between patches, from corner to corner.
SurfaceFeatures FindFeatures(const Surface& surface, double angle, double minimumArea)
{
  // A surface is mostly asked for one angle and several minimum areas: those of the first angle are
  // kept.
  std::shared_ptr<const Creases> creases =
    surface.Cached<Creases>([&]() { return FindCreases(surface, angle); });
  if (creases->Angle != angle)
  {
    creases = std::make_shared<const Creases>(FindCreases(surface, angle));
  }
  return FeaturesBetween(creases->Patches, creases->Hinges, creases->Areas,
    creases->AreNoise ? std::numeric_limits<double>::infinity() : minimumArea);
}

SurfaceFeatures FindFeatures(
  const Surface& surface, const Eigen::VectorXi& patchOf, double minimumArea)
{
  const std::vector<Hinge> hinges =
    FindHinges(surface, [&](int a, int b, double) { return patchOf(a) != patchOf(b); });
  return FeaturesBetween(ConnectPatches(surface, hinges), hinges, AreasOf(surface), minimumArea);
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
