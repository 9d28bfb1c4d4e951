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

class Plan
{
public:
  Plan(const Mesh& surface, const SurfaceFeatures& features)
    : Features(features)
    , Rings(FindCornerRings(surface, features))
    , Angles(CornerAngles(surface, features))
    , GroupOf(features.Patches)
  {
    std::iota(this->GroupOf.begin(), this->GroupOf.end(), 0);
    this->UniteAtWideCreases();
    this->UniteAtWideCorners();
    while (this->UniteAtACorner())
    {
    }
  }

  std::vector<std::vector<int>> Layers(const PatchedBoundary& boundary) const
  {
    std::vector<PatchSet> sets;
    for (const auto& [own, beyond] : this->StraightCorners(boundary))
    {
      const bool isDone = std::any_of(sets.begin(), sets.end(),
        [own = own, beyond = beyond](const PatchSet& set)
        { return set.count(beyond) > 0 && set.count(own) == 0; });
      if (!isDone)
      {
        sets.push_back(this->MinimumAround({ beyond }, own));
      }
    }
    this->WidenCorners(boundary, sets);
    for (int group = 0; group < this->Features.Patches; ++group)
    {
      sets.push_back(this->Group(group));
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

private:
  void Unite(int one, int other)
  {
    std::replace(this->GroupOf.begin(), this->GroupOf.end(), int(this->GroupOf[one]),
      int(this->GroupOf[other]));
  }

  PatchSet Group(int group) const
  {
    PatchSet set;
    for (int patch = 0; patch < this->Features.Patches; ++patch)
    {
      if (this->GroupOf[patch] == group)
      {
        set.insert(patch);
      }
    }
    return set;
  }

  void UniteAtWideCreases()
  {
    for (const FeatureCurve& curve : this->Features.Curves)
    {
      if (curve.Angle > Wide)
      {
        this->Unite(curve.Patches[0], curve.Patches[1]);
      }
    }
  }

  void UniteAtWideCorners()
  {
    for (const std::map<int, double>& patches : this->Angles)
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
            this->Unite(other, first);
          }
        }
      }
    }
  }

  /// Returns the interior dihedral angle of the sharpest crease between two patches.
  double Angle(int one, int other) const
  {
    constexpr double round = 360.0;
    double minimum = round;
    for (const FeatureCurve& curve : this->Features.Curves)
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
  bool UniteAtACorner()
  {
    for (const PatchRing& ring : this->Rings)
    {
      std::pair<int, double> best = { 0, 0.0 };
      std::pair<int, int> pair = { -1, -1 };
      for (std::size_t i = 0; i < ring.size(); ++i)
      {
        const int one = ring[i], other = ring[(i + 1) % ring.size()];
        if (this->GroupOf[one] == this->GroupOf[other])
        {
          continue;
        }
        const int bad = !IsAdmissible(this->Group(this->GroupOf[one]), ring) +
          !IsAdmissible(this->Group(this->GroupOf[other]), ring);
        const std::pair<int, double> gain = { bad, this->Angle(one, other) };
        if (bad > 0 && gain > best)
        {
          best = gain;
          pair = { one, other };
        }
      }
      if (pair.first >= 0)
      {
        this->Unite(pair.first, pair.second);
        return true;
      }
    }
    return false;
  }

  /// Finds quads with two consecutive edges on a curve inside a group. Returns pairs of the quad's
  /// patch and the patch across these edges. The quad's corner between them cannot be good, because
  /// it is a straight angle on the surface.
  std::set<std::pair<int, int>> StraightCorners(const PatchedBoundary& boundary) const
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
          beyond[k] != own && this->GroupOf[beyond[k]] == this->GroupOf[own])
        {
          pairs.insert({ own, beyond[k] });
        }
      }
    }
    return pairs;
  }

  /// Returns the number of quads that each patch has at each corner.
  std::vector<std::map<int, int>> QuadsAtCorners(const PatchedBoundary& boundary) const
  {
    std::vector<std::map<int, int>> quads(this->Rings.size());
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

  /// After a layer, the patches outside its set have one quad at a corner, or two if only one patch
  /// is outside.
  void Pad(const PatchSet& set, std::vector<std::map<int, int>>& quads) const
  {
    for (std::size_t corner = 0; corner < this->Rings.size(); ++corner)
    {
      const PatchRing& ring = this->Rings[corner];
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

  /// Adds layers below the others for a patch with a wide angle that has only one quad at a corner
  /// and is in a group with the others there.
  void WidenCorners(const PatchedBoundary& boundary, std::vector<PatchSet>& sets) const
  {
    std::vector<std::map<int, int>> quads = this->QuadsAtCorners(boundary);
    for (const PatchSet& set : sets)
    {
      this->Pad(set, quads);
    }
    for (std::size_t corner = 0; corner < this->Rings.size(); ++corner)
    {
      for (const auto& [patch, angle] : this->Angles[corner])
      {
        PatchSet others(this->Rings[corner].begin(), this->Rings[corner].end());
        others.erase(patch);
        if (angle >= Wide && quads[corner][patch] < 2 &&
          this->GroupOf[patch] == this->GroupOf[*others.begin()])
        {
          sets.push_back(this->MinimumAround(others, patch));
          this->Pad(sets.back(), quads);
        }
      }
    }
  }

  /// Returns the smallest set with some patches, without another, that is admissible everywhere.
  PatchSet MinimumAround(const PatchSet& with, int without) const
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
      const auto ring = std::find_if(this->Rings.begin(), this->Rings.end(),
        [&](const PatchRing& some) { return !IsAdmissible(set, some); });
      if (ring == this->Rings.end())
      {
        return set;
      }
      for (const PatchSet& larger : Completions(set, *ring))
      {
        if (larger.count(without) == 0 && seen.insert(larger).second)
        {
          open.push(larger);
        }
      }
    }
    PatchSet all; // leaves out one patch at each corner
    for (int patch = 0; patch < this->Features.Patches; ++patch)
    {
      all.insert(patch);
    }
    all.erase(without);
    return all;
  }

  /// Adds to the set all patches of a ring, all but one, or all but two consecutive ones.
  static std::vector<PatchSet> Completions(const PatchSet& set, const PatchRing& ring)
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

  const SurfaceFeatures& Features;
  const std::vector<PatchRing> Rings;
  const std::vector<std::map<int, double>> Angles; ///< of the patches at each corner
  std::vector<int> GroupOf;
};

} // namespace

std::vector<std::vector<int>> PlanLayers(
  const Mesh& surface, const SurfaceFeatures& features, const PatchedBoundary& boundary)
{
  return Plan(surface, features).Layers(boundary);
}

} // namespace shape
