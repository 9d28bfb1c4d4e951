#include "Hex/Fit/Private/PillowingPlan.h"

#include "Hex/Features/PatchRings.h"
#include "Mesh/QuadSurface.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <queue>
#include <set>
#include <utility>

namespace shape
{
namespace
{

using PatchSet = std::set<int>;

/// A crease, or an angle of a patch, that is wider than this has two hexahedra; degrees.
constexpr double Wide = 145.0;

/// The angles of the patches at each corner, in degrees.
std::vector<std::map<int, double>> CornerAngles(
  const Mesh& surface, const SurfaceFeatures& features)
{
  std::map<int, std::size_t> cornerOf;
  for (std::size_t corner = 0; corner < features.Corners.size(); ++corner)
  {
    cornerOf[features.Corners[corner]] = corner;
  }
  std::vector<std::map<int, double>> angles(features.Corners.size());
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      const auto corner = cornerOf.find(surface.Triangles(t, k));
      if (corner != cornerOf.end())
      {
        const Eigen::Matrix3d corners = GetCorners(surface, t);
        const Eigen::RowVector3d a = corners.row((k + 1) % 3) - corners.row(k);
        const Eigen::RowVector3d b = corners.row((k + 2) % 3) - corners.row(k);
        angles[corner->second][features.PatchOf(t)] +=
          std::atan2(a.cross(b).norm(), a.dot(b)) * 180.0 / M_PI;
      }
    }
  }
  return angles;
}

/// Whether a layer under the set keeps all patches at a corner.
bool IsAdmissible(const PatchSet& set, const PatchRing& ring)
{
  std::size_t inside = 0, begins = 0;
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const bool now = set.count(ring[i]) > 0, next = set.count(ring[(i + 1) % ring.size()]) > 0;
    inside += now;
    begins += !now && next;
  }
  return inside == 0 || inside == ring.size() || (begins == 1 && inside + 2 >= ring.size());
}

/// The patches and angles at each corner of a surface.
struct SurfaceCorners
{
  std::vector<PatchRing> Rings;              ///< the patches around each corner
  std::vector<std::map<int, double>> Angles; ///< of each patch there, in degrees
};

/// The group of each patch: patches of one group get a layer together.
using PatchGroups = std::vector<int>;

PatchSet PatchesOfGroup(const PatchGroups& groupOf, int group)
{
  PatchSet set;
  for (int patch = 0; patch < static_cast<int>(groupOf.size()); ++patch)
  {
    if (groupOf[patch] == group)
    {
      set.insert(patch);
    }
  }
  return set;
}

void Unite(PatchGroups& groupOf, int one, int other)
{
  std::replace(groupOf.begin(), groupOf.end(), int(groupOf[one]), int(groupOf[other]));
}

/// Unites the patches on both sides of each crease that is not convex.
void UniteAtWideCreases(const SurfaceFeatures& features, PatchGroups& groupOf)
{
  for (const FeatureCurve& curve : features.Curves)
  {
    if (curve.Angle > Wide)
    {
      Unite(groupOf, curve.Patches[0], curve.Patches[1]);
    }
  }
}

/// Unites the other patches at a corner if the angle of one is so wide that it needs two quads.
void UniteAtWideCorners(const SurfaceCorners& corners, PatchGroups& groupOf)
{
  for (const std::map<int, double>& patches : corners.Angles)
  {
    for (const auto& [patch, angle] : patches)
    {
      if (angle < Wide)
      {
        continue;
      }
      int first = -1;
      for (const auto& [other, unused] : patches)
      {
        if (other != patch)
        {
          first = first < 0 ? other : first;
          Unite(groupOf, other, first);
        }
      }
    }
  }
}

/// Returns the interior dihedral angle of the sharpest crease between two patches.
double FindSharpestAngle(const SurfaceFeatures& features, int one, int other)
{
  constexpr double round = 360.0;
  double minimum = round;
  for (const FeatureCurve& curve : features.Curves)
  {
    if (curve.Patches[0] == std::min(one, other) && curve.Patches[1] == std::max(one, other))
    {
      minimum = std::min(minimum, curve.Angle);
    }
  }
  return minimum;
}

/// Unites two adjacent groups at a corner where one or, preferably, both are not admissible,
/// across the flattest crease. Returns false if there are none.
bool UniteAtACorner(
  const SurfaceFeatures& features, const SurfaceCorners& corners, PatchGroups& groupOf)
{
  for (const PatchRing& ring : corners.Rings)
  {
    std::pair<int, double> best = { 0, 0.0 };
    std::pair<int, int> pair = { -1, -1 };
    for (std::size_t i = 0; i < ring.size(); ++i)
    {
      const int one = ring[i], other = ring[(i + 1) % ring.size()];
      if (groupOf[one] == groupOf[other])
      {
        continue;
      }
      const int bad = !IsAdmissible(PatchesOfGroup(groupOf, groupOf[one]), ring) +
        !IsAdmissible(PatchesOfGroup(groupOf, groupOf[other]), ring);
      const std::pair<int, double> gain = { bad, FindSharpestAngle(features, one, other) };
      if (bad > 0 && gain > best)
      {
        best = gain;
        pair = { one, other };
      }
    }
    if (pair.first >= 0)
    {
      Unite(groupOf, pair.first, pair.second);
      return true;
    }
  }
  return false;
}

PatchGroups GroupPatches(const SurfaceFeatures& features, const SurfaceCorners& corners)
{
  PatchGroups groupOf(features.Patches);
  std::iota(groupOf.begin(), groupOf.end(), 0);
  UniteAtWideCreases(features, groupOf);
  UniteAtWideCorners(corners, groupOf);
  while (UniteAtACorner(features, corners, groupOf))
  {
  }
  return groupOf;
}

/// Finds quads with two consecutive edges on a curve inside a group. Returns pairs of the quad's
/// patch and the patch across these edges. The quad's corner between them cannot be good, because
/// it is a straight angle on the surface.
std::set<std::pair<int, int>> FindStraightCorners(
  const PatchedBoundary& boundary, const PatchGroups& groupOf)
{
  const QuadSurface quads(boundary.Quads);
  std::set<std::pair<int, int>> pairs;
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    const int own = boundary.PatchOf(q);
    std::array<int, 4> beyond{};
    for (int k = 0; k < 4; ++k)
    {
      beyond[k] = boundary.PatchOf(quads.Across(static_cast<int>(q), k));
    }
    for (int k = 0; k < 4; ++k)
    {
      const int next = (k + 1) % 4;
      if (boundary.CornerOf[boundary.Quads(q, next)] < 0 && beyond[k] == beyond[next] &&
        beyond[k] != own && groupOf[beyond[k]] == groupOf[own])
      {
        pairs.insert({ own, beyond[k] });
      }
    }
  }
  return pairs;
}

/// The number of quads that each patch has at each corner.
using QuadCounts = std::vector<std::map<int, int>>;

QuadCounts CountQuadsAtCorners(const PatchedBoundary& boundary, std::size_t corners)
{
  QuadCounts quads(corners);
  for (Eigen::Index q = 0; q < boundary.Quads.rows(); ++q)
  {
    for (const int point : boundary.Quads.row(q))
    {
      if (const int corner = boundary.CornerOf[point]; corner >= 0)
      {
        ++quads[corner][boundary.PatchOf(q)];
      }
    }
  }
  return quads;
}

/// Updates the counts: after a layer, the patches outside its set have one quad at a corner, or two
/// if only one patch is outside.
void CountAfterLayer(const PatchSet& set, const std::vector<PatchRing>& rings, QuadCounts& quads)
{
  for (std::size_t corner = 0; corner < rings.size(); ++corner)
  {
    const PatchRing& ring = rings[corner];
    PatchSet out;
    std::copy_if(ring.begin(), ring.end(), std::inserter(out, out.end()),
      [&](int patch) { return set.count(patch) == 0; });
    for (const int patch : out)
    {
      quads[corner][patch] =
        out.size() == ring.size() ? quads[corner][patch] : (out.size() == 1 ? 2 : 1);
    }
  }
}

/// Adds to the set all patches of a ring, all but one, or all but two consecutive ones.
std::vector<PatchSet> CompleteAtRing(const PatchSet& set, const PatchRing& ring)
{
  std::vector<PatchSet> larger;
  PatchSet all = set;
  all.insert(ring.begin(), ring.end());
  larger.push_back(all);
  for (std::size_t i = 0; i < ring.size(); ++i)
  {
    const int one = ring[i], next = ring[(i + 1) % ring.size()];
    if (set.count(one) > 0)
    {
      continue;
    }
    PatchSet few = all;
    few.erase(one);
    larger.push_back(few);
    if (set.count(next) == 0)
    {
      few.erase(next);
      larger.push_back(few);
    }
  }
  return larger;
}

/// Returns the smallest set with some patches, without another, that is admissible at all corners:
/// a search in ascending order of size.
PatchSet FindSmallestLayer(
  const PatchSet& with, int without, const std::vector<PatchRing>& rings, int patches)
{
  const auto isLarger = [](const PatchSet& a, const PatchSet& b)
  { return a.size() != b.size() ? a.size() > b.size() : a > b; };
  std::priority_queue<PatchSet, std::vector<PatchSet>, decltype(isLarger)> open(isLarger);
  std::set<PatchSet> seen;
  open.push(with);
  constexpr int tries = 2000;
  for (int i = 0; i < tries && !open.empty(); ++i)
  {
    const PatchSet set = open.top();
    open.pop();
    const auto ring = std::find_if(
      rings.begin(), rings.end(), [&](const PatchRing& some) { return !IsAdmissible(set, some); });
    if (ring == rings.end())
    {
      return set;
    }
    for (const PatchSet& larger : CompleteAtRing(set, *ring))
    {
      if (larger.count(without) == 0 && seen.insert(larger).second)
      {
        open.push(larger);
      }
    }
  }
  PatchSet all; // leaves out one patch at each corner
  for (int patch = 0; patch < patches; ++patch)
  {
    all.insert(patch);
  }
  all.erase(without);
  return all;
}

/// Returns layers after which no quad has two consecutive edges on a curve inside a group.
std::vector<PatchSet> LayersAtStraightCorners(const PatchedBoundary& boundary,
  const SurfaceFeatures& features, const SurfaceCorners& corners, const PatchGroups& groupOf)
{
  std::vector<PatchSet> sets;
  for (const auto& [own, beyond] : FindStraightCorners(boundary, groupOf))
  {
    const bool isDone = std::any_of(sets.begin(), sets.end(),
      [own = own, beyond = beyond](const PatchSet& set)
      { return set.count(beyond) > 0 && set.count(own) == 0; });
    if (!isDone)
    {
      sets.push_back(FindSmallestLayer({ beyond }, own, corners.Rings, features.Patches));
    }
  }
  return sets;
}

/// Adds layers below the others for a patch with a wide angle that has only one quad at a corner
/// and is in a group with the others there.
void AddLayersAtWideCorners(const PatchedBoundary& boundary, const SurfaceFeatures& features,
  const SurfaceCorners& corners, const PatchGroups& groupOf, std::vector<PatchSet>& sets)
{
  QuadCounts quads = CountQuadsAtCorners(boundary, corners.Rings.size());
  for (const PatchSet& set : sets)
  {
    CountAfterLayer(set, corners.Rings, quads);
  }
  for (std::size_t corner = 0; corner < corners.Rings.size(); ++corner)
  {
    for (const auto& [patch, angle] : corners.Angles[corner])
    {
      PatchSet others(corners.Rings[corner].begin(), corners.Rings[corner].end());
      others.erase(patch);
      if (angle >= Wide && quads[corner][patch] < 2 && groupOf[patch] == groupOf[*others.begin()])
      {
        sets.push_back(FindSmallestLayer(others, patch, corners.Rings, features.Patches));
        CountAfterLayer(sets.back(), corners.Rings, quads);
      }
    }
  }
}

} // namespace

std::vector<std::vector<int>> PlanLayers(
  const Mesh& surface, const SurfaceFeatures& features, const PatchedBoundary& boundary)
{
  const SurfaceCorners corners = { FindCornerRings(surface, features),
    CornerAngles(surface, features) };
  const PatchGroups groupOf = GroupPatches(features, corners);
  std::vector<PatchSet> sets = LayersAtStraightCorners(boundary, features, corners, groupOf);
  AddLayersAtWideCorners(boundary, features, corners, groupOf, sets);
  for (int group = 0; group < features.Patches; ++group)
  {
    sets.push_back(PatchesOfGroup(groupOf, group));
  }
  std::vector<std::vector<int>> layers;
  for (const PatchSet& set : sets)
  {
    if (!set.empty())
    {
      layers.emplace_back(set.begin(), set.end());
    }
  }
  return layers;
}

} // namespace shape
