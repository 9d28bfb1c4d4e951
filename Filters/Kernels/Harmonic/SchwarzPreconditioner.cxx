#include "Harmonic/SchwarzPreconditioner.h"

#include "Base/LibraryCall.h"
#include "Base/Parallel.h"
#include "Fmm/DirectSummation.h"
#include "Harmonic/ChargeSet.h"

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
using Means = Eigen::SparseMatrix<double, Eigen::RowMajor>;

/// Returns 1 / (4 pi r): one row for each source, one column for each point. Single-threaded.
/// Positions are taken relative to the first source, because in single precision nearby points
/// would lose digits.
template <typename Real>
Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> LocalPotentials(
  const Eigen::MatrixXd& sources, const Eigen::MatrixXd& points)
{
  const Eigen::RowVector3d origin = sources.row(0);
  const Eigen::Array<Real, Eigen::Dynamic, 3> from =
    (sources.rowwise() - origin).template cast<Real>().array();
  const Eigen::Array<Real, Eigen::Dynamic, 3> to =
    (points.rowwise() - origin).template cast<Real>().array();
  Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic> matrix(sources.rows(), points.rows());
  for (Eigen::Index i = 0; i < points.rows(); ++i)
  {
    matrix.col(i) = static_cast<Real>(0.25 / M_PI) *
      ((from.col(0) - to(i, 0)).square() + (from.col(1) - to(i, 1)).square() +
        (from.col(2) - to(i, 2)).square())
        .rsqrt();
  }
  return matrix;
}

/// Returns the rows with an entry in the tests of the given sites, ascending.
std::vector<int> TestedRows(const Means& tests, const std::vector<int>& sites)
{
  std::vector<int> rows;
  for (const int site : sites)
  {
    for (Means::InnerIterator entry(tests, site); entry; ++entry)
    {
      rows.push_back(static_cast<int>(entry.col()));
    }
  }
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
  return rows;
}

/// Returns the matrix of the means over each cluster: number of clusters x number of sites.
Means MeansOver(const Eigen::VectorXi& clusters, Eigen::Index count)
{
  Eigen::VectorXd sizes = Eigen::VectorXd::Zero(count);
  for (const int cluster : clusters)
  {
    sizes(cluster) += 1.0;
  }
  Means means(count, clusters.size());
  std::vector<Eigen::Triplet<double>> entries;
  for (Eigen::Index i = 0; i < clusters.size(); ++i)
  {
    entries.emplace_back(clusters(i), static_cast<int>(i), 1.0 / sizes(clusters(i)));
  }
  means.setFromTriplets(entries.begin(), entries.end());
  return means;
}

/// Returns the sites nearest to the centre of `own` that are not in `own`, nearest first.
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

std::vector<std::vector<int>> SplitAtMedians(const Eigen::MatrixXd& points, int maximum)
{
  std::vector<std::vector<int>> done, open(1, std::vector<int>(points.rows()));
  std::iota(open.front().begin(), open.front().end(), 0);
  while (!open.empty())
  {
    std::vector<int> part = std::move(open.back());
    open.pop_back();
    if (static_cast<int>(part.size()) <= maximum)
    {
      std::sort(part.begin(), part.end());
      done.push_back(std::move(part));
      continue;
    }
    const Eigen::MatrixXd positions = points(part, Eigen::all);
    Eigen::Index axis = 0;
    (positions.colwise().maxCoeff() - positions.colwise().minCoeff()).maxCoeff(&axis);
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
  const std::vector<int>& ownRows, const Eigen::MatrixXd& coarseSources,
  const Eigen::VectorXi& clusters, const SchwarzOptions& options, const Progress& progress)
  : Processes(options.Processes)
  , CoarseSources(coarseSources)
  , ClusterMeans(MeansOver(clusters, coarseSources.rows()))
{
  // Outline:
  // 1. Sites are split into blocks of neighbours.
  // 2. Each block's local system, with the sites around it, is inverted (MakeBlock).
  // 3. The positions where the blocks read the residual are collected.
  // 4. The coarse system is inverted (SetUpCoarse).
  const BlasThreads single(false); // the blocks are distributed over the threads
  // Step 1: blocks. Those of one process are neighbours.
  const std::vector<std::vector<int>> all = SplitAtMedians(system.Sites, options.Own);
  const auto mine = this->Processes.Own(static_cast<Eigen::Index>(all.size()));
  const std::vector<std::vector<int>> parts(all.begin() + mine.Begin, all.begin() + mine.End);
  const PointRows sites = system.Sites;
  const Tree tree(3, std::cref(sites), 16);
  // Step 2: local inverses.
  this->Blocks.resize(parts.size());
  ParallelFor(
    static_cast<int>(parts.size()), 1,
    [&](int begin, int end)
    {
      for (int p = begin; p < end; ++p)
      {
        this->Blocks[p] = MakeBlock(system, parts[p],
          SitesAround(tree, system.Sites, parts[p], options.Around), options.MaximumAmplification);
      }
    },
    progress.Part(0.0, 0.8));
  // Steps 3 and 4.
  const Eigen::MatrixXd averaged = system.Tests * system.Rows;
  this->GatherPositions(system, averaged, this->NumberRows(system, ownRows));
  this->SetUpCoarse(averaged, progress.Part(0.8, 1.0));
}

std::vector<int> SchwarzPreconditioner::NumberRows(
  const TestedSystem& system, const std::vector<int>& ownRows)
{
  // Outline:
  // 1. The rows that this process reads and may have to receive: those of its blocks, and those of
  //    its tests that belong to another process.
  // 2. The rows that any process reads are numbered, and sent by the process that has them.
  // 3. The tests of this process, whose sums therefore have the order of the system's.
  const Eigen::Index m = system.Rows.rows();
  std::vector<int> ownIndex(m, -1);
  for (std::size_t k = 0; k < ownRows.size(); ++k)
  {
    ownIndex[ownRows[k]] = static_cast<int>(k);
  }
  const auto isOwn = [&](Eigen::Index site)
  {
    const Means::InnerIterator first(system.Tests, site);
    return first && ownIndex[first.col()] >= 0;
  };
  // Step 1: what is read.
  Eigen::VectorXd read = Eigen::VectorXd::Zero(m);
  for (const Block& block : this->Blocks)
  {
    if (block.TakesRows)
    {
      read(block.Inputs).setOnes();
    }
  }
  for (Eigen::Index site = 0; site < system.Tests.rows(); ++site)
  {
    for (Means::InnerIterator entry(system.Tests, site); isOwn(site) && entry; ++entry)
    {
      read(entry.col()) = ownIndex[entry.col()] < 0 ? 1.0 : read(entry.col());
    }
  }
  // Step 2: numbers.
  this->Processes.Sum(read);
  std::vector<int> numbers(m, -1);
  for (Eigen::Index row = 0; row < m; ++row)
  {
    if (read(row) > 0.0)
    {
      if (ownIndex[row] >= 0)
      {
        this->SentRows.push_back(this->NumberedRows);
        this->SentIndices.push_back(ownIndex[row]);
      }
      numbers[row] = this->NumberedRows++;
    }
  }
  // Step 3: tests.
  const auto own = static_cast<int>(ownRows.size());
  this->Tests.resize(system.Tests.rows(), own + this->NumberedRows);
  for (Eigen::Index site = 0; site < system.Tests.rows(); ++site)
  {
    this->Tests.startVec(site);
    for (Means::InnerIterator entry(system.Tests, site); isOwn(site) && entry; ++entry)
    {
      const int index = ownIndex[entry.col()];
      this->Tests.insertBackByOuterInnerUnordered(
        site, index >= 0 ? index : own + numbers[entry.col()]) = entry.value();
    }
  }
  this->Tests.finalize();
  return numbers;
}

void SchwarzPreconditioner::GatherPositions(
  const TestedSystem& system, const Eigen::MatrixXd& averaged, const std::vector<int>& numbers)
{
  const Eigen::Index n = system.Sites.rows(), m = system.Rows.rows();
  // What the blocks of this process read; then its number among their inputs.
  std::vector<int> sites(n, -1), rows(m, -1), positions;
  for (const Block& block : this->Blocks)
  {
    for (const int input : block.Inputs)
    {
      (block.TakesRows ? rows : sites)[input] = 0;
    }
  }
  for (int site = 0; site < n; ++site)
  {
    if (sites[site] == 0)
    {
      sites[site] = static_cast<int>(this->ReadSites.size());
      this->ReadSites.push_back(site);
    }
  }
  for (int row = 0; row < m; ++row)
  {
    if (rows[row] == 0)
    {
      rows[row] = static_cast<int>(this->ReadSites.size() + positions.size());
      positions.push_back(row);
      this->ReadRows.push_back(numbers[row]);
    }
  }
  for (Block& block : this->Blocks)
  {
    for (int& input : block.Inputs)
    {
      input = (block.TakesRows ? rows : sites)[input];
    }
  }
  this->Positions.resize(static_cast<Eigen::Index>(this->ReadSites.size() + positions.size()), 3);
  this->Positions << averaged(this->ReadSites, Eigen::all), system.Rows(positions, Eigen::all);
}

void SchwarzPreconditioner::SetUpCoarse(const Eigen::MatrixXd& averaged, const Progress& progress)
{
  // The coarse charges reproduce the mean residual of each cluster, by regularized least squares.
  // The processes share the columns of the system, and each inverts it.
  const Eigen::Index count = this->CoarseSources.rows();
  Eigen::MatrixXd coarse = Eigen::MatrixXd::Zero(count, count); // transposed
  const auto mine = this->Processes.Own(count);
  for (Eigen::Index c = mine.Begin; c < mine.End; ++c)
  {
    progress(0.3 * static_cast<double>(c - mine.Begin) / static_cast<double>(mine.Size()));
    // A mean of potentials is the potential of a charge distributed over the positions.
    std::vector<int> sites;
    std::vector<double> shares;
    for (Means::InnerIterator entry(this->ClusterMeans, c); entry; ++entry)
    {
      sites.push_back(static_cast<int>(entry.col()));
      shares.push_back(entry.value());
    }
    coarse.col(c) = SumPotentialsDirectly(averaged(sites, Eigen::all),
      Eigen::Map<const Eigen::VectorXd>(shares.data(), static_cast<Eigen::Index>(shares.size())),
      this->CoarseSources);
  }
  this->Processes.Sum(coarse);
  // In narrow gaps coarse charges are nearly redundant; the regularization keeps them small.
  constexpr double ridge = 1e-4;
  this->CoarseInverse = coarse;
  const auto invert = [&]
  {
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(count, count);
    normal.selfadjointView<Eigen::Lower>().rankUpdate(coarse);
    normal.diagonal().array() += ridge * normal.diagonal().mean();
    normal.selfadjointView<Eigen::Lower>().llt().solveInPlace(this->CoarseInverse);
  };
  const BlasThreads threads(BlasThreads::WorthSharing(static_cast<int>(count)));
  const double n = static_cast<double>(count);
  RunInterruptibly(invert, (1.0 + 1.0 / 3.0 + 2.0) * n * n * n,
    { { this->CoarseInverse.data(), this->CoarseInverse.size() * sizeof(double) } },
    progress.Part(0.3, 1.0));
}

SchwarzPreconditioner::Block SchwarzPreconditioner::MakeBlock(const TestedSystem& system,
  const std::vector<int>& own, const std::vector<int>& around, double maximumAmplification)
{
  Block block;
  // The local system has the charges of the block and of the sites around it. Only the rows of the
  // block are kept: restricted additive Schwarz (Cai and Sarkis 1999).
  block.Own = own;
  std::vector<int> sites = own;
  sites.insert(sites.end(), around.begin(), around.end());
  const auto all = static_cast<Eigen::Index>(sites.size());
  const auto count = static_cast<Eigen::Index>(own.size());
  const std::vector<int> rows = TestedRows(system.Tests, sites);
  const Eigen::MatrixXd sources = system.Sources(sites, Eigen::all);
  const Eigen::MatrixXd positions = system.Rows(rows, Eigen::all);
  // The columns of `own` in the transposed inverse are its rows in the inverse.
  if (maximumAmplification > 0.0)
  {
    // First choice: as many averages as charges, solved directly. Single precision suffices for a
    // preconditioner.
    const Eigen::MatrixXf potentials = LocalPotentials<float>(sources, positions);
    Eigen::MatrixXf tested = Eigen::MatrixXf::Zero(all, all); // transposed
    for (Eigen::Index i = 0; i < all; ++i)
    {
      for (Means::InnerIterator entry(system.Tests, sites[i]); entry; ++entry)
      {
        const auto row = std::lower_bound(rows.begin(), rows.end(), static_cast<int>(entry.col()));
        tested.col(i) += static_cast<float>(entry.value()) * potentials.col(row - rows.begin());
      }
    }
    const Eigen::MatrixXf inverse =
      tested.partialPivLu().solve(Eigen::MatrixXf::Identity(all, count));
    // A bound of the charges that the block computes from the potentials of a unit charge.
    if (inverse.colwise().norm().maxCoeff() * tested.rowwise().norm().maxCoeff() <
      maximumAmplification)
    {
      block.Inputs = sites;
      block.Inverse = inverse.transpose();
      return block;
    }
  }
  // Second choice: least squares over the rows themselves, regularized by a ridge. RMSE inside
  // triangles for ridges 1e-2, 1e-3, 1e-4, 1e-6 (data A of Testing/Benchmarks): turbine 9.7e-4,
  // 4.6e-4, 5.0e-4, 7.8e-4; cheese 1.5e-3, 2.9e-3, 3.4e-3, 7.6e-2.
  constexpr double ridge = 3e-3;
  const Eigen::MatrixXd potentials = LocalPotentials<double>(sources, positions);
  const Eigen::MatrixXd weighted = potentials * system.Weights(rows).asDiagonal();
  Eigen::MatrixXd normal = weighted * potentials.transpose();
  normal.diagonal() *= 1.0 + ridge;
  block.TakesRows = true;
  block.Inputs = rows;
  block.Inverse =
    (normal.ldlt().solve(Eigen::MatrixXd::Identity(all, count)).transpose() * weighted)
      .cast<float>();
  return block;
}

Eigen::MatrixXd SchwarzPreconditioner::Apply(
  const Eigen::MatrixXd& residual, const Progress& progress) const
{
  // The averages of the residual around all sites, and the rows that blocks read: the processes
  // send numbered rows and averages.
  const Eigen::Index columns = residual.cols();
  Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(this->NumberedRows, columns);
  rows(this->SentRows, Eigen::all) = residual(this->SentIndices, Eigen::all);
  this->Processes.Sum(rows);
  Eigen::MatrixXd averages;
  if (this->NumberedRows > 0)
  {
    Eigen::MatrixXd read(residual.rows() + this->NumberedRows, columns);
    read << residual, rows;
    averages = this->Tests * read;
  }
  else
  {
    averages = this->Tests * residual;
  }
  this->Processes.Sum(averages);
  return this->FindCharges(averages, rows(this->ReadRows, Eigen::all), progress);
}

Eigen::MatrixXd SchwarzPreconditioner::ApplyToAverages(
  const Eigen::MatrixXd& averages, const Progress& progress) const
{
  return this->FindCharges(averages, Eigen::MatrixXd(0, averages.cols()), progress);
}

Eigen::MatrixXd SchwarzPreconditioner::ApplyTransposed(
  const Eigen::MatrixXd& charges, const Progress& progress) const
{
  // The steps of FindCharges, transposed, in reverse order.
  const BlasThreads single(false);
  const Eigen::Index n = this->Tests.rows(), c = this->CoarseSources.rows();
  // Blocks read the same residuals, so their shares of these are added in the order of the blocks.
  std::vector<Eigen::MatrixXd> shares(this->Blocks.size());
  ParallelFor(
    static_cast<int>(this->Blocks.size()), 16,
    [&](int begin, int end)
    {
      for (int b = begin; b < end; ++b)
      {
        const Block& block = this->Blocks[b];
        const Eigen::MatrixXd own = charges(block.Own, Eigen::all);
        shares[b] = block.Inverse.cast<double>().transpose() * own;
      }
    },
    progress.Part(0.0, 0.5));
  Eigen::MatrixXd left = Eigen::MatrixXd::Zero(n, charges.cols());
  for (std::size_t b = 0; b < shares.size(); ++b)
  {
    left(this->Blocks[b].Inputs, Eigen::all) += shares[b];
  }
  const Eigen::MatrixXd coarse = charges.bottomRows(c) -
    SumPotentialsDirectly(
      this->Positions, left, this->CoarseSources, RootError::Small, progress.Part(0.5, 1.0));
  return left + this->ClusterMeans.transpose() * (this->CoarseInverse.transpose() * coarse);
}

Eigen::MatrixXd SchwarzPreconditioner::FindCharges(
  const Eigen::MatrixXd& averages, const Eigen::MatrixXd& rows, const Progress& progress) const
{
  const BlasThreads single(false);
  // Outline:
  // 1. The coarse charges, from the mean residual of each cluster.
  // 2. The blocks reduce the remaining residual, independently of each other.
  const Eigen::Index n = this->Tests.rows(), c = this->CoarseSources.rows();
  // Step 1: coarse charges.
  const Eigen::MatrixXd coarse = this->CoarseInverse * (this->ClusterMeans * averages);
  Eigen::MatrixXd left(this->Positions.rows(), averages.cols());
  left << averages(this->ReadSites, Eigen::all), rows;
  // The potential of a coarse charge hardly varies over one average, so it is evaluated at its
  // centre.
  left -= SumPotentialsDirectly(
    this->CoarseSources, coarse, this->Positions, RootError::Small, progress.Part(0.0, 0.5));
  // Step 2. Every site belongs to one block, so the blocks write different rows.
  Eigen::MatrixXd charges = Eigen::MatrixXd::Zero(n + c, averages.cols());
  ParallelFor(
    static_cast<int>(this->Blocks.size()), 16,
    [&](int begin, int end)
    {
      for (int b = begin; b < end; ++b)
      {
        const Block& block = this->Blocks[b];
        // In double precision: rounding the inputs to float would make the operator slightly
        // nonlinear.
        const Eigen::MatrixXd inputs = left(block.Inputs, Eigen::all);
        charges(block.Own, Eigen::all) = block.Inverse.cast<double>() * inputs;
      }
    },
    progress.Part(0.5, 1.0));
  this->Processes.Sum(charges);
  charges.bottomRows(c) = coarse;
  return charges;
}

} // namespace shape
