#include "Hex/Features/Private/PatchPinches.h"

#include "Hex/Features/PatchedBoundary.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <set>
#include <vector>

namespace shape
{
namespace
{

/// The quads around each point, counter-clockwise.
std::map<int, std::vector<int>> QuadsAround(const Eigen::MatrixXi& quads)
{
  const std::map<QuadEdge, int> quadOf = MapEdgesToQuads(quads);
  std::map<int, std::vector<int>> around;
  for (int q = 0; q < static_cast<int>(quads.rows()); ++q)
  {
    for (int k = 0; k < 4; ++k)
    {
      const int point = quads(q, k);
      std::vector<int>& fan = around[point];
      if (!fan.empty())
      {
        continue;
      }
      int quad = q;
      do
      {
        fan.push_back(quad);
        const auto corner = std::find(quads.row(quad).begin(), quads.row(quad).end(), point) -
          quads.row(quad).begin();
        quad = quadOf.at({ point, quads(quad, (corner + 3) % 4) });
      } while (quad != q);
    }
  }
  return around;
}

class Pinches
{
public:
  Pinches(const Eigen::MatrixXi& quads, const std::vector<PatchRing>& corners)
    : Around(QuadsAround(quads))
    , Corners(corners.begin(), corners.end())
  {
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
        continue; // not where an arc begins
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

  const std::map<int, std::vector<int>> Around;
  const std::set<PatchRing> Corners;
};

} // namespace

void SplitPinches(const Eigen::MatrixXi& quads, const std::vector<PatchRing>& corners,
  const DistanceToPatch& distance, Eigen::VectorXi& patchOf)
{
  Pinches(quads, corners).Open(distance, patchOf);
}

} // namespace shape
