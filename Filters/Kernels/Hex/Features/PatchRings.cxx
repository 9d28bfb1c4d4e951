#include "Hex/Features/PatchRings.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace shape
{
namespace
{

/// The points at which patches touch themselves.
class Pinches
{
public:
  Pinches(const QuadSurface& surface, const std::vector<PatchRing>& corners)
    : Corners(corners.begin(), corners.end())
  {
    for (int quad = 0; quad < static_cast<int>(surface.Quads().rows()); ++quad)
    {
      for (const int point : surface.Quads().row(quad))
      {
        std::vector<int>& fan = this->Around[point];
        if (fan.empty())
        {
          fan = surface.QuadsAround(point, quad);
        }
      }
    }
  }

  void Open(const DistanceToPatch& distance, Eigen::VectorXi& patchOf) const
  {
    for (const auto& [point, fan] : this->Around)
    {
      const std::vector<int> labels = Labels(fan, patchOf);
      if (this->IsPinch(labels))
      {
        this->Open(fan, labels, distance, patchOf);
      }
    }
  }

private:
  static std::vector<int> Labels(const std::vector<int>& fan, const Eigen::VectorXi& patchOf)
  {
    std::vector<int> labels(fan.size());
    std::transform(fan.begin(), fan.end(), labels.begin(), [&](int q) { return patchOf(q); });
    return labels;
  }

  bool IsPinch(const std::vector<int>& labels) const
  {
    const PatchRing ring = BuildPatchRing(labels);
    return std::set<int>(ring.begin(), ring.end()).size() < ring.size() &&
      this->Corners.count(ring) == 0;
  }

  void Open(const std::vector<int>& fan, const std::vector<int>& labels,
    const DistanceToPatch& distance, Eigen::VectorXi& patchOf) const
  {
    const std::size_t count = labels.size();
    double minimum = std::numeric_limits<double>::infinity();
    std::vector<int> best;
    for (std::size_t begin = 0; begin < count; ++begin)
    {
      const int before = labels[(begin + count - 1) % count], own = labels[begin];
      if (before == own)
      {
        continue; // no arc begins here
      }
      std::size_t length = 1;
      while (length < count && labels[(begin + length) % count] == own)
      {
        ++length;
      }
      for (const int patch : { before, labels[(begin + length) % count] })
      {
        std::vector<int> changed = labels;
        double sum = 0.0;
        for (std::size_t i = begin; i < begin + length; ++i)
        {
          changed[i % count] = patch;
          sum += distance(fan[i % count], patch);
        }
        const PatchRing ring = BuildPatchRing(changed);
        if ((ring.size() <= 2 || this->Corners.count(ring) > 0) && sum < minimum)
        {
          minimum = sum;
          best = changed;
        }
      }
    }
    for (std::size_t i = 0; i < best.size(); ++i)
    {
      patchOf(fan[i]) = best[i];
    }
  }

  std::map<int, std::vector<int>> Around; ///< the quads around each point, counter-clockwise
  const std::set<PatchRing> Corners;
};

} // namespace

PatchRing BuildPatchRing(const std::vector<int>& patches)
{
  PatchRing ring;
  for (std::size_t i = 0; i < patches.size(); ++i)
  {
    if (patches[i] != patches[(i + 1) % patches.size()])
    {
      ring.push_back(patches[i]);
    }
  }
  // The canonical start: the lexicographically smallest rotation.
  PatchRing minimum = ring;
  for (std::size_t turn = 1; turn < ring.size(); ++turn)
  {
    std::rotate(ring.begin(), ring.begin() + 1, ring.end());
    minimum = std::min(minimum, ring);
  }
  return minimum;
}

std::vector<PatchRing> FindCornerRings(const Mesh& surface, const SurfaceFeatures& features)
{
  // For each corner: the next edge and the patch in between, by the edge that leaves it.
  std::map<int, std::map<int, std::pair<int, int>>> fans;
  for (const int corner : features.Corners)
  {
    fans[corner];
  }
  for (Eigen::Index t = 0; t < surface.Triangles.rows(); ++t)
  {
    for (int k = 0; k < 3; ++k)
    {
      if (const auto fan = fans.find(surface.Triangles(t, k)); fan != fans.end())
      {
        const int edge = surface.Triangles(t, (k + 1) % 3),
                  next = surface.Triangles(t, (k + 2) % 3);
        fan->second[edge] = { next, features.PatchOf(t) };
      }
    }
  }
  std::vector<PatchRing> rings;
  for (const int corner : features.Corners)
  {
    const auto& fan = fans.at(corner);
    std::vector<int> patches;
    auto edge = fan.begin();
    for (std::size_t i = 0; i < fan.size() && edge != fan.end(); ++i)
    {
      patches.push_back(edge->second.second);
      edge = fan.find(edge->second.first);
    }
    if (edge == fan.end())
    {
      patches.clear(); // on a boundary loop, as in a surface that crosses itself
    }
    rings.push_back(BuildPatchRing(patches));
  }
  return rings;
}

void SplitPinches(const QuadSurface& quads, const std::vector<PatchRing>& corners,
  const DistanceToPatch& distance, Eigen::VectorXi& patchOf)
{
  Pinches(quads, corners).Open(distance, patchOf);
}

} // namespace shape
