#include "Atlas/PermutationTest.h"

#include "Base/Errors.h"
#include "Base/Parallel.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>
#include <vector>

namespace shape
{
namespace
{

/// Statistics that differ by less are the same: they lie in [0, 1].
constexpr double Tied = 1e-9;

/// The permutations of a variable, all different ones or random ones.
class Permutations
{
public:
  Permutations(const Eigen::VectorXd& variable, const PermutationTestOptions& options)
    : Values(variable)
    , Order(variable.size())
    , Random(static_cast<std::uint64_t>(options.Seed))
  {
    // The number of different ones is N! / prod k!, where k values each are equal.
    std::map<double, int> ranks;
    for (const double value : variable)
    {
      ranks.emplace(value, 0);
    }
    int rank = 0;
    for (auto& [value, number] : ranks)
    {
      number = rank++;
      this->Different.push_back(value);
    }
    std::vector<int> seen(ranks.size(), 0);
    double all = 1.0;
    for (Eigen::Index i = 0; i < variable.size(); ++i)
    {
      this->Order[i] = ranks.at(variable(i));
      all *= static_cast<double>(i + 1) / ++seen[this->Order[i]];
    }
    this->Exact = all < options.Permutations + 0.5;
    this->Count = this->Exact ? static_cast<int>(std::lround(all)) : options.Permutations;
    if (this->Exact)
    {
      std::sort(this->Order.begin(), this->Order.end());
    }
  }

  /// Returns the next `count` ones as columns.
  Eigen::MatrixXd Next(int count)
  {
    Eigen::MatrixXd columns(this->Values.size(), count);
    for (auto column : columns.colwise())
    {
      if (this->Exact)
      {
        std::transform(this->Order.begin(), this->Order.end(), column.begin(),
          [&](int rank) { return this->Different[rank]; });
        std::next_permutation(this->Order.begin(), this->Order.end());
        continue;
      }
      column = this->Values;
      for (Eigen::Index i = column.size() - 1; i > 0; --i)
      {
        std::swap(column(i), column(static_cast<Eigen::Index>(this->Random() % (i + 1))));
      }
    }
    return columns;
  }

  int Count = 0;
  bool Exact = false;

private:
  Eigen::VectorXd Values;
  std::vector<double> Different; ///< ascending
  std::vector<int> Order;        ///< the rank of each value
  std::mt19937_64 Random;
};

/// The deviations of a point (3 x N), in coordinates in which their scatter is the identity.
/// Directions in which the point does not move are left out.
Eigen::MatrixXd MakeIsotropic(const Eigen::MatrixXd& deviations, double smallest)
{
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> scatter(deviations * deviations.transpose());
  const Eigen::Array3d values = scatter.eigenvalues().array();
  const Eigen::Vector3d factors = (values > smallest).select(values.max(smallest).rsqrt(), 0.0);
  return factors.asDiagonal() * scatter.eigenvectors().transpose() * deviations;
}

/// Returns the q-values of Benjamini and Hochberg: min over j >= i of p_(j) n / j, p ascending.
Eigen::VectorXd ControlFalseDiscoveries(const Eigen::VectorXd& pValues)
{
  const Eigen::Index count = pValues.size();
  std::vector<Eigen::Index> order(count);
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
    [&](Eigen::Index a, Eigen::Index b) { return pValues(a) < pValues(b); });
  Eigen::VectorXd result(count);
  double least = 1.0;
  for (Eigen::Index rank = count; rank > 0; --rank)
  {
    const Eigen::Index point = order[rank - 1];
    least =
      std::min(least, pValues(point) * static_cast<double>(count) / static_cast<double>(rank));
    result(point) = least;
  }
  return result;
}

} // namespace

// 1. The statistics of the given order.
// 2. Those of the permutations, in batches, and how many are not smaller.
PermutationTestResult TestByPermutation(const Eigen::MatrixXd& deviations,
  const Eigen::VectorXd& weights, const Eigen::VectorXd& variable,
  const PermutationTestOptions& options, const Progress& progress)
{
  RequireOption(options.Permutations >= 1, "Permutations", options.Permutations, "at least 1");
  const Eigen::VectorXd centred = variable.array() - variable.mean();
  const double squares = centred.squaredNorm();
  if (centred.cwiseAbs().maxCoeff() <= 1e-12 * variable.cwiseAbs().maxCoeff())
  {
    throw InvalidInput("the variable has the same value for every shape; choose another column");
  }
  const Eigen::Index points = weights.size(), shapes = variable.size();
  PermutationTestResult result;
  result.Slope = (deviations * (centred / squares)).reshaped(points, 3);
  const Eigen::VectorXd roots = weights.cwiseSqrt().replicate(3, 1);
  const Eigen::MatrixXd weighted = roots.asDiagonal() * deviations;
  const Eigen::MatrixXd gram = weighted.transpose() * weighted;
  const double total = gram.trace();
  const auto explain = [&](const Eigen::MatrixXd& columns) -> Eigen::VectorXd
  {
    const Eigen::MatrixXd products = gram * columns;
    return total > 0.0
      ? Eigen::VectorXd(
          columns.cwiseProduct(products).colwise().sum().transpose() / (squares * total))
      : Eigen::VectorXd::Zero(columns.cols());
  };
  result.RSquared = explain(centred)(0);

  // Of a point that only rounding moves, the statistic is 0 in any order.
  const double smallest =
    std::max(1e-12 * deviations.squaredNorm() / static_cast<double>(points), 1e-300);
  Eigen::MatrixXd isotropic(3 * points, shapes);
  Eigen::VectorXd statistics(points);
  for (Eigen::Index i = 0; i < points; ++i)
  {
    Eigen::MatrixXd own(3, shapes);
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      own.row(k) = deviations.row(k * points + i);
    }
    isotropic.middleRows(3 * i, 3) = MakeIsotropic(own, smallest);
    statistics(i) = (isotropic.middleRows(3 * i, 3) * centred).squaredNorm() / squares;
  }

  Permutations permutations(centred, options);
  result.Permutations = permutations.Count;
  result.Exact = permutations.Exact;
  Eigen::VectorXd notSmaller = Eigen::VectorXd::Zero(points);
  double wholeNotSmaller = 0.0;
  constexpr int batch = 250, grain = 256;
  const BlasThreads one(false);
  for (int done = 0; done < permutations.Count; done += batch)
  {
    const double share = 1.0 / permutations.Count;
    const int size = std::min(batch, permutations.Count - done);
    const Eigen::MatrixXd columns = permutations.Next(size);
    wholeNotSmaller +=
      static_cast<double>((explain(columns).array() >= result.RSquared - Tied).count());
    ParallelFor(
      static_cast<int>(points), grain,
      [&](int begin, int end)
      {
        const Eigen::MatrixXd products =
          isotropic.middleRows(3 * begin, 3 * (end - begin)) * columns;
        for (int i = begin; i < end; ++i)
        {
          const double least = (statistics(i) - Tied) * squares;
          notSmaller(i) += static_cast<double>(
            (products.middleRows(3 * (i - begin), 3).colwise().squaredNorm().array() >= least)
              .count());
        }
      },
      progress.Part(done * share, (done + size) * share));
  }
  // The given order is one of all permutations, and is added to random ones.
  const double given = result.Exact ? 0.0 : 1.0, count = permutations.Count + given;
  result.PValue = (wholeNotSmaller + given) / count;
  result.PValues = (notSmaller.array() + given) / count;
  result.QValues = ControlFalseDiscoveries(result.PValues);
  return result;
}

} // namespace shape
