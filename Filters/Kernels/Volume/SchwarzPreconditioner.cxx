#include "Volume/SchwarzPreconditioner.h"

#include "Core/Parallel.h"
#include "Volume/ChargeSet.h"
#include "Volume/DirectSummation.h"

#include <Eigen/Cholesky>
#include <nanoflann.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <cstdio>
#include <cstdlib>
namespace shape
{

namespace
{

constexpr int Own = 64;     ///< most sites of a block
constexpr int Around = 100; ///< sites around them that its local system includes

using PointRows = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Tree = nanoflann::KDTreeEigenMatrixAdaptor<PointRows, 3>;

/// 1 / (4 pi r), points' count x sources' count, by one thread.
Eigen::MatrixXd Potentials(const Eigen::MatrixXd& points, const Eigen::MatrixXd& sources)
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
  const Eigen::MatrixXd& coarseSources, const Eigen::VectorXi& clusters, const Progress& progress)
  : Tests(system.Tests)
  , Sites(system.Sites), Rows(system.Rows)
  , CoarseSources(coarseSources)
  , Clusters(clusters)
  , ClusterSizes(Eigen::VectorXd::Zero(coarseSources.rows()))
{
  const BlasThreads single(1);
  const int n = static_cast<int>(this->Sites.rows());
  for (const int cluster : clusters)
  {
    this->ClusterSizes(cluster) += 1.0;
  }
  const std::vector<std::vector<int>> parts = MedianClusters(this->Sites, Own);
  const PointRows rows = this->Sites;
  const Tree tree(3, std::cref(rows), 16);
  this->Blocks.resize(parts.size());
  ParallelFor(
    static_cast<int>(parts.size()), 4,
    [&](int begin, int end)
    {
      for (int p = begin; p < end; ++p)
      {
        const Eigen::RowVector3d centre = this->Sites(parts[p], Eigen::all).colwise().mean();
        const int wanted = std::min<int>(n, static_cast<int>(parts[p].size()) + Around);
        std::vector<Eigen::Index> found(wanted);
        std::vector<double> squares(wanted);
        nanoflann::KNNResultSet<double, Eigen::Index> nearest(wanted);
        nearest.init(found.data(), squares.data());
        tree.index->findNeighbors(nearest, centre.data(), nanoflann::SearchParams());
        std::vector<int> around;
        for (const Eigen::Index site : found)
        {
          if (!std::binary_search(parts[p].begin(), parts[p].end(), static_cast<int>(site)))
          {
            around.push_back(static_cast<int>(site));
          }
        }
        this->Blocks[p] = this->MakeBlock(system, parts[p], std::move(around));
      }
    },
    progress.Part(0.0, 0.8));

  Eigen::MatrixXd coarse(coarseSources.rows(), coarseSources.rows());
  constexpr int panel = 64;
  for (int first = 0; first < coarseSources.rows(); first += panel)
  {
    progress(0.8 + 0.2 * first / static_cast<double>(coarseSources.rows()));
    const int width = std::min<int>(panel, static_cast<int>(coarseSources.rows()) - first);
    coarse.middleCols(first, width) =
      this->ClusterMeans(PotentialMatrix(this->Sites, coarseSources.middleRows(first, width)));
  }
  static const double cr = getenv("CR") ? atof(getenv("CR")) : 1e-6;
  Eigen::MatrixXd normal=coarse.transpose()*coarse; normal.diagonal().array()+=cr*normal.diagonal().mean();
  Eigen::MatrixXd ct=coarse.transpose();
  this->CoarseInverse = normal.ldlt().solve(ct);
}

SchwarzPreconditioner::Block SchwarzPreconditioner::MakeBlock(
  const TestedSystem& system, std::vector<int> own, std::vector<int> around) const
{
  Block block;
  const Eigen::Index count = static_cast<Eigen::Index>(own.size());
  block.Sites = std::move(own);
  block.Sites.insert(block.Sites.end(), around.begin(), around.end());
  const Eigen::Index all = static_cast<Eigen::Index>(block.Sites.size());

  std::vector<int> rows;
  for (const int site : block.Sites)
  {
    for (decltype(this->Tests)::InnerIterator entry(this->Tests, site); entry; ++entry)
    {
      rows.push_back(static_cast<int>(entry.col()));
    }
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  const Eigen::MatrixXd potentials =
    Potentials(system.Rows(rows, Eigen::all), system.Sources(block.Sites, Eigen::all));
  Eigen::MatrixXd local = Eigen::MatrixXd::Zero(all, all);
  for (Eigen::Index i = 0; i < all; ++i)
  {
    for (decltype(this->Tests)::InnerIterator entry(this->Tests, block.Sites[i]); entry; ++entry)
    {
      const auto row = std::lower_bound(rows.begin(), rows.end(), static_cast<int>(entry.col()));
      local.row(i) += entry.value() * potentials.row(row - rows.begin());
    }
  }
  const Eigen::MatrixXd unit = Eigen::MatrixXd::Identity(all, count);
  static const double ridge = getenv("RIDGE") ? atof(getenv("RIDGE")) : 1e-6;
  static const double worst = getenv("WORST") ? atof(getenv("WORST")) : 0;
  Eigen::MatrixXd inverse;
  if (worst > 0) inverse = local.transpose().partialPivLu().solve(unit).transpose();
  if (!(worst > 0 && inverse.rowwise().norm().maxCoeff() * local.colwise().norm().maxCoeff() < worst))
  {
    const Eigen::VectorXd weights = system.Weights(rows);
    const Eigen::MatrixXd weighted = potentials.transpose() * weights.asDiagonal();
    Eigen::MatrixXd normal = weighted * potentials;
    normal.diagonal() *= 1.0 + ridge; 
    inverse = normal.ldlt().solve(unit).transpose() * weighted;
    block.Rows = rows;
  }
  block.Inverse = inverse.cast<float>();
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
  const Eigen::Index n = this->Sites.rows(), c = this->CoarseSources.rows();
  Eigen::MatrixXd left = this->Tests * residual;
  Eigen::MatrixXd charges(n + c, residual.cols());
  charges.bottomRows(c) = this->CoarseInverse * this->ClusterMeans(left);
  if(getenv("NOCOARSE")) charges.bottomRows(c).setZero();
  if(getenv("VC")) printf("coarse %g left %g ",charges.bottomRows(c).norm(), left.norm());
  Eigen::MatrixXd rowLeft = residual - DirectPotentials(this->CoarseSources, charges.bottomRows(c), this->Rows);
  left = this->Tests * rowLeft;
  ParallelFor(static_cast<int>(this->Blocks.size()), 16,
    [&](int begin, int end)
    {
      for (int b = begin; b < end; ++b)
      {
        const Block& block = this->Blocks[b];
        const Eigen::MatrixXf values = block.Rows.empty() ? left(block.Sites, Eigen::all).cast<float>().eval() : rowLeft(block.Rows, Eigen::all).cast<float>().eval();
        const Eigen::MatrixXf own = block.Inverse.lazyProduct(values);
        for (Eigen::Index i = 0; i < own.rows(); ++i)
        {
          charges.row(block.Sites[i]) = own.row(i).cast<double>();
        }
      }
    });
  return charges;
}

} // namespace shape
