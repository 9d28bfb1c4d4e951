#include "Correspondence/Consistent/Private/ShapeGraph.h"

#include "Base/DisjointSets.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace shape
{

Eigen::MatrixXd CompareSpectra(const std::vector<Eigen::VectorXd>& spectra)
{
  const auto count = static_cast<Eigen::Index>(spectra.size());
  Eigen::MatrixXd distances = Eigen::MatrixXd::Zero(count, count);
  for (Eigen::Index i = 0; i < count; ++i)
  {
    for (Eigen::Index j = 0; j < i; ++j)
    {
      const Eigen::Index size =
        std::min<Eigen::Index>({ SpectrumSize, spectra[i].size(), spectra[j].size() });
      const Eigen::ArrayXd ratios = spectra[i].segment(1, size - 1).array().log() -
        spectra[j].segment(1, size - 1).array().log();
      distances(i, j) = distances(j, i) = std::sqrt(ratios.square().mean());
    }
  }
  return distances;
}

std::vector<std::array<int, 2>> FindShapeGraph(const Eigen::MatrixXd& distances, int neighbours)
{
  const auto count = static_cast<int>(distances.rows());
  std::set<std::array<int, 2>> pairs;
  std::vector<std::array<int, 2>> all;
  for (int i = 0; i < count; ++i)
  {
    std::vector<int> others;
    for (int j = 0; j < count; ++j)
    {
      if (j != i)
      {
        others.push_back(j);
      }
      if (j > i)
      {
        all.push_back({ i, j });
      }
    }
    std::stable_sort(others.begin(), others.end(),
      [&](int a, int b) { return distances(i, a) < distances(i, b); });
    others.resize(std::min<std::size_t>(others.size(), neighbours));
    for (const int j : others)
    {
      pairs.insert({ std::min(i, j), std::max(i, j) });
    }
  }
  std::stable_sort(all.begin(), all.end(),
    [&](const auto& a, const auto& b) { return distances(a[0], a[1]) < distances(b[0], b[1]); });
  DisjointSets sets(count);
  for (const std::array<int, 2>& pair : all)
  {
    if (sets.Find(pair[0]) != sets.Find(pair[1]))
    {
      sets.Merge(pair[0], pair[1]);
      pairs.insert(pair);
    }
  }
  return { pairs.begin(), pairs.end() };
}

} // namespace shape
