#include "Geometry/Sampling.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"
#include "Geometry/Private/QuadricSampling.h"

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

/// The density of adaptive samples in flat parts, and its maximum in curved parts, relative to the
/// mean. A stronger contrast leaves too few points in flat parts: on TwoTorus, its polycube and a
/// scanned bear, 0.3 increased the boundary error of the harmonic map by up to a tenth over 0.5.
constexpr double MinimumDensity = 0.5, MaximumDensity = 4.0;

/// Points spread at random over a surface, with the normals of their triangles.
struct RandomPoints
{
  Eigen::MatrixXd Points;  ///< n x 3
  Eigen::MatrixXd Normals; ///< n x 3
};

RandomPoints SpreadAtRandom(const Mesh& surface, int count, unsigned int seed)
{
  const Eigen::MatrixXd vectors = ComputeAreaVectors(surface);
  const Eigen::VectorXd areas = vectors.rowwise().norm();
  std::vector<double> sums(areas.size());
  std::partial_sum(areas.begin(), areas.end(), sums.begin());
  std::mt19937_64 generator(seed);
  RandomPoints spread{ Eigen::MatrixXd(count, 3), Eigen::MatrixXd(count, 3) };
  for (int i = 0; i < count; ++i)
  {
    const double position = Random(generator) * sums.back();
    const auto t = std::min<Eigen::Index>(
      std::upper_bound(sums.begin(), sums.end(), position) - sums.begin(), areas.size() - 1);
    // The square root makes positions uniform in the triangle.
    const double root = std::sqrt(Random(generator)), share = Random(generator);
    spread.Points.row(i) = (1.0 - root) * surface.Points.row(surface.Triangles(t, 0)) +
      root * (1.0 - share) * surface.Points.row(surface.Triangles(t, 1)) +
      root * share * surface.Points.row(surface.Triangles(t, 2));
    spread.Normals.row(i) = vectors.row(t) / areas(t);
  }
  return spread;
}

/// The coordinates of points in the contiguous order in which the search visits them.
using PointRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Tree = nanoflann::KDTreeEigenMatrixAdaptor<PointRows, 3>;
using Neighbours = std::vector<std::pair<Eigen::Index, double>>; // row, squared distance

void FindWithin(
  const Tree& tree, const Eigen::RowVector3d& centre, double radius, Neighbours& found)
{
  found.clear();
  tree.index->radiusSearch(
    centre.data(), radius * radius, found, nanoflann::SearchParams(32, 0.0f, false));
}

/// Returns the curvature within `radius` of each point: the root mean square difference of the
/// normals there, 0 where the surface is flat.
Eigen::VectorXd Bending(const RandomPoints& spread, double radius, const Progress& progress)
{
  const int n = static_cast<int>(spread.Points.rows());
  const PointRows rows = spread.Points;
  const Tree tree(3, std::cref(rows), 10);
  Eigen::VectorXd bending(n);
  ParallelFor(
    n, 1024,
    [&](int begin, int end)
    {
      Neighbours found;
      for (int i = begin; i < end; ++i)
      {
        FindWithin(tree, spread.Points.row(i), radius, found);
        double sum = 0.0;
        for (const auto& [j, distance2] : found)
        {
          sum += (spread.Normals.row(i) - spread.Normals.row(j)).squaredNorm();
        }
        bending(i) = std::sqrt(sum / found.size()); // includes the point itself
      }
    },
    progress);
  return bending;
}

} // namespace

Eigen::MatrixXd SampleSurface(
  const Mesh& surface, int count, SamplingMode mode, unsigned int seed, const Progress& progress)
{
  const double area = ComputeArea(surface);
  if (count < 4 || !(area > 0.0))
  {
    throw InvalidInput(count < 4
        ? "cannot spread " + std::to_string(count) + " points over a surface; ask for at least 4"
        : "the surface to sample has no area; check its coordinates");
  }
  const double radius = ComputePackingRadius(area, count);
  if (mode == SamplingMode::Quadric)
  {
    const Eigen::MatrixXd points = SimplifyByQuadrics(surface, count, progress.Part(0.0, 0.9));
    if (points.rows() <= count)
    {
      return points;
    }
    const Eigen::VectorXd equal = Eigen::VectorXd::Constant(points.rows(), radius);
    return points(EliminateSamples(points, equal, count, progress.Part(0.9, 1.0)), Eigen::all);
  }
  // Adaptive samples are up to four times as dense as the mean: they need more candidates to choose
  // from.
  const int candidates = (mode == SamplingMode::Uniform ? 5 : 10) * count;
  const RandomPoints spread = SpreadAtRandom(surface, candidates, seed);
  Eigen::VectorXd radii = Eigen::VectorXd::Constant(candidates, radius);
  if (mode == SamplingMode::GeometryAdaptive)
  {
    // Facets of size h deviate from a surface of curvature k by k h^2 / 8. This is uniform if their
    // density is proportional to k, measured as the bending within a fixed radius.
    const Eigen::VectorXd bending = Bending(spread, 2.0 * radius, progress.Part(0.0, 0.3));
    Eigen::ArrayXd density = bending.array().max(1e-6) / std::max(bending.mean(), 1e-6);
    density = density.max(MinimumDensity).min(MaximumDensity);
    radii = radius * (density / density.mean()).rsqrt();
  }
  const Eigen::VectorXi kept =
    EliminateSamples(spread.Points, radii, count, progress.Part(0.3, 1.0));
  return spread.Points(kept, Eigen::all);
}

std::vector<Eigen::MatrixXd> SampleSurfaces(const std::vector<Mesh>& surfaces, int count,
  int minimum, SamplingMode mode, unsigned int seed, const Progress& progress)
{
  Eigen::VectorXd areas(surfaces.size());
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    areas(s) = ComputeAreaVectors(surfaces[s]).rowwise().norm().sum();
  }
  std::vector<Eigen::MatrixXd> points;
  double done = 0.0;
  for (std::size_t s = 0; s < surfaces.size(); ++s)
  {
    const double share = areas(s) / areas.sum();
    const int asked = std::max(minimum, static_cast<int>(std::round(share * count)));
    points.push_back(
      SampleSurface(surfaces[s], asked, mode, seed, progress.Part(done, done + share)));
    done += share;
  }
  return points;
}

double ComputePackingRadius(double area, int count)
{
  return std::sqrt(area / (2.0 * std::sqrt(3.0) * count));
}

// Yuksel 2015:
// 1. Each pair of samples closer than the sum of their radii has the weight (1 - d)^8, with their
//    distance d relative to that sum. A sample's weight is the sum over its pairs.
// 2. The sample of the largest weight is removed, and its neighbours' weights fall.
// 3. This repeats until the wanted number is left.
Eigen::VectorXi EliminateSamples(
  const Eigen::MatrixXd& points, const Eigen::VectorXd& radii, int count, const Progress& progress)
{
  const int n = static_cast<int>(points.rows());
  // Yuksel 2015, section 3: a lower bound of distances, as a fraction of the sum of the radii.
  const double closest = 0.65 * (1.0 - std::pow(static_cast<double>(count) / n, 1.5));
  const PointRows rows = points;
  const Tree tree(3, std::cref(rows), 10);
  std::vector<std::vector<std::pair<int, double>>> neighbours(n);
  std::vector<double> weights(n, 0.0);
  Neighbours found;
  for (int i = 0; i < n; ++i)
  {
    // Each pair is found once, from the one with the larger radius.
    FindWithin(tree, points.row(i), 2.0 * radii(i), found);
    for (const auto& [j, distance2] : found)
    {
      if (std::pair(radii(j), j) < std::pair(radii(i), static_cast<Eigen::Index>(i)))
      {
        const double distance = std::sqrt(distance2) / (radii(i) + radii(j));
        const double near2 = std::pow(1.0 - std::min(1.0, std::max(distance, closest)), 2);
        const double weight = near2 * near2 * near2 * near2;
        neighbours[i].emplace_back(static_cast<int>(j), weight);
        neighbours[j].emplace_back(i, weight);
        weights[i] += weight;
        weights[j] += weight;
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

Eigen::VectorXd ComputeSampledAreas(const Eigen::MatrixXd& points)
{
  const Eigen::Index n = points.rows();
  // The nearest found is the point itself.
  const std::size_t count = static_cast<std::size_t>(std::min<Eigen::Index>(7, n));
  const PointRows rows = points;
  const Tree tree(3, std::cref(rows), 10);
  std::vector<Eigen::Index> found(count);
  std::vector<double> squares(count);
  Eigen::VectorXd areas(n);
  for (Eigen::Index i = 0; i < n; ++i)
  {
    const Eigen::RowVector3d point = points.row(i);
    tree.query(point.data(), count, found.data(), squares.data());
    double sum = 0.0;
    for (const double square : squares)
    {
      sum += std::sqrt(square);
    }
    areas(i) = sum * sum;
  }
  const double mean = areas.mean();
  if (!(mean > 0.0)) // all points coincide
  {
    return Eigen::VectorXd::Ones(n);
  }
  return (areas / mean).cwiseMax(0.1).cwiseMin(10.0);
}

Eigen::VectorXi FindSpatialOrder(const Eigen::MatrixXd& points)
{
  const Eigen::RowVector3d low = points.colwise().minCoeff();
  const double side = std::max(ComputeLongestBoxEdge(points), 1e-300);
  std::vector<std::pair<std::uint64_t, int>> keys(points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    // Interleaves the bits of the three coordinates, 20 of each.
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
