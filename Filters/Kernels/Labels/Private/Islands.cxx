#include "Labels/Private/Islands.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <map>
#include <vector>

namespace shape
{
namespace
{

/// Calls visit(voxel, neighbour) once for each face between two voxels.
template <typename Visit>
void ForEachFace(const LabelImage& image, const Visit& visit)
{
  const auto& size = image.Size;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        const int voxel = static_cast<int>(image.IndexOf(i, j, k));
        if (i > 0)
        {
          visit(voxel, voxel - 1);
        }
        if (j > 0)
        {
          visit(voxel, voxel - size[0]);
        }
        if (k > 0)
        {
          visit(voxel, voxel - size[0] * size[1]);
        }
      }
    }
  }
}

/// Dissolves the parts that are small now. Their neighbours may be small, too.
DissolvedIslands DissolveOnce(LabelImage& image, int smallest)
{
  const int voxels = static_cast<int>(image.Labels.size());
  DisjointSets parts(voxels);
  ForEachFace(image,
    [&](int a, int b)
    {
      if (image.Labels[a] == image.Labels[b])
      {
        parts.Merge(a, b);
      }
    });
  std::vector<int> root(voxels), count(voxels, 0);
  for (int i = 0; i < voxels; ++i)
  {
    root[i] = parts.Find(i);
    ++count[root[i]];
  }
  // Beyond the image lies the outside.
  const auto& size = image.Size;
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      const bool isOnSide = k == 0 || j == 0 || k == size[2] - 1 || j == size[1] - 1;
      for (int i = 0; i < size[0]; i += isOnSide ? 1 : std::max(size[0] - 1, 1))
      {
        const std::size_t voxel = image.IndexOf(i, j, k);
        if (image.Labels[voxel] == 0)
        {
          count[root[voxel]] = smallest;
        }
      }
    }
  }
  // For each small part, the number of faces to each label around it.
  std::map<int, std::map<int, int>> contacts;
  ForEachFace(image,
    [&](int a, int b)
    {
      if (root[a] == root[b])
      {
        return;
      }
      if (count[root[a]] < smallest)
      {
        ++contacts[root[a]][image.Labels[b]];
      }
      if (count[root[b]] < smallest)
      {
        ++contacts[root[b]][image.Labels[a]];
      }
    });
  std::map<int, int> labels;
  DissolvedIslands dissolved;
  for (const auto& [part, faces] : contacts)
  {
    labels[part] = std::max_element(faces.begin(), faces.end(),
      [](const auto& a, const auto& b) {
        return a.second < b.second;
      })->first;
    ++dissolved.Count;
    dissolved.Voxels += count[part];
  }
  for (int i = 0; i < voxels && !labels.empty(); ++i)
  {
    if (count[root[i]] < smallest)
    {
      const auto found = labels.find(root[i]);
      if (found != labels.end())
      {
        image.Labels[i] = found->second;
      }
    }
  }
  return dissolved;
}

} // namespace

DissolvedIslands DissolveIslands(LabelImage& image, int smallest, const Progress& progress)
{
  DissolvedIslands all;
  // Two small neighbours may exchange their labels once; each round joins some parts.
  constexpr int rounds = 8;
  for (int round = 0; smallest > 1 && round < rounds; ++round)
  {
    progress(static_cast<double>(round) / rounds);
    const DissolvedIslands now = DissolveOnce(image, smallest);
    if (now.Count == 0)
    {
      break;
    }
    all.Count += now.Count;
    all.Voxels += now.Voxels;
  }
  return all;
}

} // namespace shape
