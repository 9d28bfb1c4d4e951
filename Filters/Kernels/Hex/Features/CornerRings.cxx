#include "Hex/Features/CornerRings.h"

#include <algorithm>
#include <map>
#include <utility>

namespace shape
{

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
  // Of each corner, by the side of a triangle that leaves it: the next side, and the patch between.
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
        const int side = surface.Triangles(t, (k + 1) % 3),
                  next = surface.Triangles(t, (k + 2) % 3);
        fan->second[side] = { next, features.PatchOf(t) };
      }
    }
  }
  std::vector<PatchRing> rings;
  for (const int corner : features.Corners)
  {
    const auto& fan = fans.at(corner);
    std::vector<int> patches;
    auto side = fan.begin();
    for (std::size_t i = 0; i < fan.size() && side != fan.end(); ++i)
    {
      patches.push_back(side->second.second);
      side = fan.find(side->second.first);
    }
    if (side == fan.end())
    {
      patches.clear(); // at a border, as where a surface crosses itself
    }
    rings.push_back(BuildPatchRing(patches));
  }
  return rings;
}

} // namespace shape
