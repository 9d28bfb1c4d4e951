#include "Volume/Sampling.h"

#include "Core/Errors.h"
#include "Geometry/Decimate.h"

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <queue>
#include <random>
#include <string>
#include <vector>

namespace shape
{

namespace
{

/// A number in [0, 1): the standard's own distributions differ between libraries.
double Random(std::mt19937_64& generator)
{
  return static_cast<double>(generator() >> 11) * 0x1p-53;
}

Eigen::MatrixXd RandomPoints(const Mesh& surface, int count, unsigned int seed)
{
  const Eigen::VectorXd areas = AreaVectors(surface).rowwise().norm();
  std::vector<double> sums(areas.size());
  std::partial_sum(areas.begin(), areas.end(), sums.begin());
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd points(count, 3);
  for (int i = 0; i < count; ++i)
  {
    const double place = Random(generator) * sums.back();
    const auto t = std::min<Eigen::Index>(
      std::upper_bound(sums.begin(), sums.end(), place) - sums.begin(), areas.size() - 1);
    const double root = std::sqrt(Random(generator)), share = Random(generator);
    points.row(i) = (1.0 - root) * surface.Points.row(surface.Triangles(t, 0)) +
      root * (1.0 - share) * surface.Points.row(surface.Triangles(t, 1)) +
      root * share * surface.Points.row(surface.Triangles(t, 2));
  }
  return points;
}

Eigen::MatrixXd AdaptivePoints(const Mesh& surface, int count, const Progress& progress)
{
  // Dense enough for the metric to choose from: at least four points for each one that stays.
  Mesh dense = surface;
  while (dense.Points.rows() < 4.0 * count)
  {
    dense = Subdivide(dense);
  }
  const Mesh coarse = Decimate(dense, count, progress.Part(0.0, 0.9));
  std::vector<char> used(coarse.Points.rows(), 0);
  for (const int corner : coarse.Triangles.reshaped())
  {
    used[corner] = 1;
  }
  std::vector<int> kept;
  for (int i = 0; i < coarse.Points.rows(); ++i)
  {
    if (used[i])
    {
      kept.push_back(i);
    }
  }
  return coarse.Points(kept, Eigen::all);
}

} // namespace

Eigen::MatrixXd SampleSurface(
  const Mesh& surface, int count, SamplingMode mode, unsigned int seed, const Progress& progress)
{
  const double area = 0.5 * AreaVectors(surface).rowwise().norm().sum();
  if (count < 4 || !(area > 0.0))
  {
    throw InvalidInput(count < 4
        ? "cannot spread " + std::to_string(count) + " points over a surface; ask for at least 4"
        : "the surface to sample has no area");
  }
  const Eigen::MatrixXd candidates = mode == SamplingMode::Uniform
    ? RandomPoints(surface, 5 * count, seed)
    : AdaptivePoints(surface, count, progress.Part(0.0, 0.9));
  if (candidates.rows() <= count)
  {
    return candidates;
  }
  const Eigen::VectorXi kept = EliminateSamples(candidates, area, count, progress.Part(0.9, 1.0));
  return candidates(kept, Eigen::all);
}

Eigen::VectorXi EliminateSamples(
  const Eigen::MatrixXd& points, double area, int count, const Progress& progress)
{
  using Adaptor = nanoflann::KDTreeEigenMatrixAdaptor<Eigen::MatrixXd, 3>;
  const int n = static_cast<int>(points.rows());
  // Yuksel 2015, section 3: the radius of the densest packing and the weights of eq. 3.
  const double largest = std::sqrt(area / (2.0 * std::sqrt(3.0) * count));
  const double smallest = 0.65 * largest * (1.0 - std::pow(static_cast<double>(count) / n, 1.5));
  const Adaptor tree(3, std::cref(points), 10);
  std::vector<std::vector<std::pair<int, double>>> neighbours(n);
  std::vector<double> weights(n, 0.0);
  std::vector<std::pair<Eigen::Index, double>> found;
  for (int i = 0; i < n; ++i)
  {
    const Eigen::RowVector3d centre = points.row(i);
    found.clear();
    tree.index->radiusSearch(
      centre.data(), 4.0 * largest * largest, found, nanoflann::SearchParams());
    for (const auto& [j, distance2] : found)
    {
      if (j != i)
      {
        const double distance = std::max(std::sqrt(distance2), 2.0 * smallest);
        const double weight = std::pow(1.0 - std::min(1.0, distance / (2.0 * largest)), 8);
        neighbours[i].emplace_back(static_cast<int>(j), weight);
        weights[i] += weight;
      }
    }
    if (i % 1024 == 0)
    {
      progress(0.7 * i / n);
    }
  }
  // The heap keeps outdated weights; one that is not the current weight any more is put back.
  std::priority_queue<std::pair<double, int>> heap;
  for (int i = 0; i < n; ++i)
  {
    heap.emplace(weights[i], i);
  }
  std::vector<char> alive(n, 1);
  for (int left = n; left > count;)
  {
    const auto [weight, i] = heap.top();
    heap.pop();
    if (weight != weights[i])
    {
      heap.emplace(weights[i], i);
      continue;
    }
    alive[i] = 0;
    for (const auto& [j, share] : neighbours[i])
    {
      weights[j] -= share;
    }
    if (--left % 1024 == 0)
    {
      progress(0.7 + 0.3 * (n - left) / (n - count + 1.0));
    }
  }
  std::vector<int> kept;
  for (int i = 0; i < n; ++i)
  {
    if (alive[i])
    {
      kept.push_back(i);
    }
  }
  return Eigen::VectorXi::Map(kept.data(), kept.size());
}

Eigen::VectorXi SpatialOrder(const Eigen::MatrixXd& points)
{
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const double side = std::max(LongestSide(points), 1e-300);
  std::vector<std::pair<std::uint64_t, int>> keys(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    std::uint64_t key = 0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto cell = static_cast<std::uint64_t>((points(i, axis) - low(axis)) / side * 0xFFFFF);
      for (int bit = 0; bit < 20; ++bit)
      {
        key |= (cell >> bit & 1) << (3 * bit + axis);
      }
    }
    keys[i] = { key, static_cast<int>(i) };
  }
  std::sort(keys.begin(), keys.end());
  Eigen::VectorXi order(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    order(i) = keys[i].second;
  }
  return order;
}

} // namespace shape
