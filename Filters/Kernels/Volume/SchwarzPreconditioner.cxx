#include "Volume/SchwarzPreconditioner.h"

#include "Core/Parallel.h"
#include "Volume/ChargeSet.h"
#include "Volume/DirectSummation.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <utility>

namespace shape
{

namespace
{

using PointRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Tree = nanoflann::KDTreeEigenMatrixAdaptor<PointRows, 3>;
using Tests = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// 1 / (4 pi r), points' count x sources' count, by one thread.
Eigen::MatrixXd LocalPotentials(const Eigen::MatrixXd& points, const Eigen::MatrixXd& sources)
{
  Eigen::MatrixXd matrix(points.rows(), sources.rows());
  for (Eigen::Index j = 0; j < sources.rows(); ++j)
  {
    matrix.col(j) = 0.25 / M_PI *
      ((points.col(0).array() - sources(j, 0)).square() +
        (points.col(1).array() - sources(j, 1)).square() +
        (points.col(2).array() - sources(j, 2)).square())
        .rsqrt();
  }
  return matrix;
}

/// The rows that the tests of some sites look at, ascending.
std::vector<int> TestedRows(const Tests& tests, const std::vector<int>& sites)
{
  std::vector<int> rows;
  for (const int site : sites)
  {
    for (Tests::InnerIterator entry(tests, site); entry; ++entry)
    {
      rows.push_back(static_cast<int>(entry.col()));
    }
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// Sites near the centre of `own` that are not among them, nearest first.
std::vector<int> SitesAround(
  const Tree& tree, const Eigen::MatrixXd& sites, const std::vector<int>& own, int count)
{
  const Eigen::RowVector3d centre = sites(own, Eigen::all).colwise().mean();
  const auto wanted = std::min<Eigen::Index>(sites.rows(), own.size() + count);
  std::vector<Eigen::Index> found(wanted);
  std::vector<double> squares(wanted);
  nanoflann::KNNResultSet<double, Eigen::Index> nearest(wanted);
  nearest.init(found.data(), squares.data());
  tree.index->findNeighbors(nearest, centre.data(), nanoflann::SearchParams());
  std::vector<int> around;
  for (const Eigen::Index site : found)
  {
    if (!std::binary_search(own.begin(), own.end(), static_cast<int>(site)))
    {
      around.push_back(static_cast<int>(site));
    }
  }
  return around;
}

} // namespace

std::vector<std::vector<int>> MedianClusters(const Eigen::MatrixXd& points, int most)
{
  std::vector<std::vector<int>> done, open(1, std::vector<int>(points.rows()));
  std::iota(open.front().begin(), open.front().end(), 0);
  while (!open.empty())
  {
    std::vector<int> part = std::move(open.back());
    open.pop_back();
    if (static_cast<int>(part.size()) <= most)
    {
      std::sort(part.begin(), part.end());
      done.push_back(std::move(part));
      continue;
    }
    const Eigen::MatrixXd places = points(part, Eigen::all);
    Eigen::Index axis = 0;
    (places.colwise().maxCoeff() - places.colwise().minCoeff()).maxCoeff(&axis);
    const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
    std::nth_element(part.begin(), middle, part.end(),
      [&](int a, int b)
      { return std::make_pair(points(a, axis), a) < std::make_pair(points(b, axis), b); });
    open.emplace_back(middle, part.end());
    open.emplace_back(part.begin(), middle);
  }
  return done;
}

SchwarzPreconditioner::SchwarzPreconditioner(const TestedSystem& system,
  const Eigen::MatrixXd& coarseSources, const Eigen::VectorXi& clusters,
  const SchwarzOptions& options, const Progress& progress)
  : Tests(system.Tests)
  , Rows(system.Rows)
  , CoarseSources(coarseSources)
  , Clusters(clusters)
  , ClusterSizes(Eigen::VectorXd::Zero(coarseSources.rows()))
{
  const BlasThreads single(1); // the blocks are shared out among the threads
  for (const int cluster : clusters)
  {
    this->ClusterSizes(cluster) += 1.0;
  }
  const std::vector<std::vector<int>> parts = MedianClusters(system.Sites, options.Own);
  const PointRows places = system.Sites;
  const Tree tree(3, std::cref(places), 16);
  this->Blocks.resize(parts.size());
  ParallelFor(
    static_cast<int>(parts.size()), 1,
    [&](int begin, int end)
    {
      for (int p = begin; p < end; ++p)
      {
        this->Blocks[p] = MakeBlock(system, parts[p],
          SitesAround(tree, system.Sites, parts[p], options.Around), options.MostAmplified);
      }
    },
    progress.Part(0.0, 0.8));

  const Eigen::Index count = coarseSources.rows();
  Eigen::MatrixXd coarse(count, count);
  constexpr Eigen::Index panel = 64;
  for (Eigen::Index first = 0; first < count; first += panel)
  {
    progress(0.8 + 0.2 * static_cast<double>(first) / static_cast<double>(count));
    const Eigen::Index width = std::min(panel, count - first);
    coarse.middleCols(first, width) =
      this->ClusterMeans(PotentialMatrix(system.Sites, coarseSources.middleRows(first, width)));
  }
  // In narrow gaps coarse charges are nearly redundant: the ridge keeps them small.
  constexpr double ridge = 1e-4;
  Eigen::MatrixXd normal = coarse.transpose() * coarse;
  normal.diagonal().array() += ridge * normal.diagonal().mean();
  this->CoarseInverse = normal.llt().solve(coarse.transpose());
}

SchwarzPreconditioner::Block SchwarzPreconditioner::MakeBlock(const TestedSystem& system,
  const std::vector<int>& own, const std::vector<int>& around, double mostAmplified)
{
  Block block;
  block.Own = own;
  std::vector<int> sites = own;
  sites.insert(sites.end(), around.begin(), around.end());
  const auto all = static_cast<Eigen::Index>(sites.size());
  // Own columns of a transposed inverse are own rows of the inverse.
  const Eigen::MatrixXd unit =
    Eigen::MatrixXd::Identity(all, static_cast<Eigen::Index>(own.size()));
  const std::vector<int> rows = TestedRows(system.Tests, sites);
  const Eigen::MatrixXd potentials =
    LocalPotentials(system.Rows(rows, Eigen::all), system.Sources(sites, Eigen::all));
  if (mostAmplified > 0.0)
  {
    Eigen::MatrixXd tested = Eigen::MatrixXd::Zero(all, all);
    for (Eigen::Index i = 0; i < all; ++i)
    {
      for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(
             system.Tests, sites[i]);
           entry; ++entry)
      {
        const auto row = std::lower_bound(rows.begin(), rows.end(), static_cast<int>(entry.col()));
        tested.row(i) += entry.value() * potentials.row(row - rows.begin());
      }
    }
    const Eigen::MatrixXd inverse = tested.transpose().partialPivLu().solve(unit).transpose();
    if (inverse.rowwise().norm().maxCoeff() * tested.colwise().norm().maxCoeff() < mostAmplified)
    {
      block.Inputs = sites;
      block.Inverse = inverse.cast<float>();
      return block;
    }
  }
  constexpr double ridge = 1e-8;
  const Eigen::MatrixXd weighted = potentials.transpose() * system.Weights(rows).asDiagonal();
  Eigen::MatrixXd normal = weighted * potentials;
  normal.diagonal() *= 1.0 + ridge;
  block.TakesRows = true;
  block.Inputs = rows;
  block.Inverse = (normal.ldlt().solve(unit).transpose() * weighted).cast<float>();
  return block;
}

Eigen::MatrixXd SchwarzPreconditioner::ClusterMeans(const Eigen::MatrixXd& values) const
{
  Eigen::MatrixXd means = Eigen::MatrixXd::Zero(this->ClusterSizes.size(), values.cols());
  for (Eigen::Index i = 0; i < values.rows(); ++i)
  {
    means.row(this->Clusters(i)) += values.row(i);
  }
  return this->ClusterSizes.cwiseInverse().asDiagonal() * means;
}

Eigen::MatrixXd SchwarzPreconditioner::Apply(const Eigen::MatrixXd& residual) const
{
  const Eigen::Index n = this->Tests.rows(), c = this->CoarseSources.rows();
  Eigen::MatrixXd charges(n + c, residual.cols());
  charges.bottomRows(c) = this->CoarseInverse * this->ClusterMeans(this->Tests * residual);
  const Eigen::MatrixXd left =
    residual - DirectPotentials(this->CoarseSources, charges.bottomRows(c), this->Rows);
  const Eigen::MatrixXd tested = this->Tests * left;
  const BlasThreads single(1);
  ParallelFor(static_cast<int>(this->Blocks.size()), 16,
    [&](int begin, int end)
    {
      for (int b = begin; b < end; ++b)
      {
        const Block& block = this->Blocks[b];
        // Double again: rounding of the inputs to float would make it a little less than linear.
        const Eigen::MatrixXd inputs = (block.TakesRows ? left : tested)(block.Inputs, Eigen::all);
        charges(block.Own, Eigen::all) = block.Inverse.cast<double>() * inputs;
      }
    });
  return charges;
}

} // namespace shape
