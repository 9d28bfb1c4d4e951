#include "Atlas/Private/ShapeModes.h"

#include "Base/Parallel.h"
#include "Linear/SymmetricEigen.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

namespace shape
{
namespace
{

/// Variances below this share of the largest are rounding.
constexpr double VarianceRounding = 1e-12;

/// The products after the mean of the shapes `others` is subtracted from each shape.
Eigen::MatrixXd CentreOn(const std::vector<Eigen::Index>& others, const Eigen::MatrixXd& products)
{
  const auto count = static_cast<double>(others.size());
  const Eigen::VectorXd withMean = products(Eigen::all, others).rowwise().sum() / count;
  const double ofMean = withMean(others).sum() / count;
  return ((products.colwise() - withMean).rowwise() - withMean.transpose()).array() + ofMean;
}

/// The eigenpairs of the products of some shapes, descending, without rounding.
struct InnerModes
{
  explicit InnerModes(const Eigen::MatrixXd& products)
  {
    const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(products);
    const Eigen::VectorXd values = solver.eigenvalues().reverse();
    const double largest = std::max(values(0), 0.0);
    const auto rank = std::min<Eigen::Index>(
      (values.array() > VarianceRounding * largest).count(), values.size() - 1);
    this->Values = values.head(rank);
    this->Vectors = solver.eigenvectors().rowwise().reverse().leftCols(rank);
  }
  Eigen::VectorXd Values; ///< sums of squares
  Eigen::MatrixXd Vectors;
};

} // namespace

DeviationProducts ComputeDeviationProducts(const Eigen::MatrixXd& deviations,
  const Eigen::VectorXd& weights, int seed, const Progress& progress)
{
  const Eigen::Index points = weights.size(), shapes = deviations.cols();
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::vector<Eigen::Index> halves[2];
  for (Eigen::Index i = 0; i < points; ++i)
  {
    halves[random() % 2].push_back(i);
  }
  DeviationProducts result;
  double done = 0.0;
  for (Eigen::MatrixXd* product : { &result.First, &result.Second })
  {
    const std::vector<Eigen::Index>& half = halves[product == &result.First ? 0 : 1];
    const Eigen::VectorXd roots = weights(half).cwiseSqrt();
    *product = Eigen::MatrixXd::Zero(shapes, shapes);
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      progress(done / 6.0);
      done += 1.0;
      const Eigen::MatrixXd rows =
        roots.asDiagonal() * deviations.middleRows(k * points, points)(half, Eigen::all);
      *product += rows.transpose() * rows;
    }
  }
  result.All = result.First + result.Second;
  return result;
}

PrincipalScores ComputePrincipalScores(const Eigen::MatrixXd& products, const Progress& progress)
{
  const Eigen::Index shapes = products.rows();
  const double degrees = std::max(static_cast<double>(shapes) - 1.0, 1.0);
  Eigenpairs pairs =
    FindLargestEigenpairs(products, std::max(static_cast<int>(shapes) - 1, 1), progress);
  const Eigen::Index rank =
    (pairs.Values.array() > std::max(VarianceRounding * pairs.Values(0), 1e-300)).count();
  PrincipalScores result;
  result.Variances = pairs.Values.head(rank) / degrees;
  result.Scores = std::sqrt(degrees) * pairs.Vectors.leftCols(rank);
  FixSigns(result.Scores);
  return result;
}

// With A the deviations left out in both ways, B in the points, C in the shapes and D kept, and
// D ~ U S V^T with k modes, A is predicted by B V S^-1 U^T C (Owen and Perry, equation 3.5).
Eigen::VectorXd ComputePredictionErrors(
  const DeviationProducts& products, int seed, const Progress& progress)
{
  const Eigen::Index shapes = products.All.rows();
  std::vector<Eigen::Index> order(shapes);
  std::iota(order.begin(), order.end(), 0);
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  for (Eigen::Index i = shapes - 1; i > 0; --i)
  {
    std::swap(order[i], order[static_cast<std::size_t>(random() % (i + 1))]);
  }
  const Eigen::Index parts = std::min<Eigen::Index>(shapes, 10);
  Eigen::VectorXd errors = Eigen::VectorXd::Zero(shapes);
  Eigen::Index most = shapes;
  for (Eigen::Index part = 0; part < parts; ++part)
  {
    progress(static_cast<double>(part) / static_cast<double>(parts));
    std::vector<Eigen::Index> left, kept;
    for (Eigen::Index i = 0; i < shapes; ++i)
    {
      (i % parts == part ? left : kept).push_back(order[i]);
    }
    const Eigen::MatrixXd halves[2] = { CentreOn(kept, products.First),
      CentreOn(kept, products.Second) };
    for (int h = 0; h < 2; ++h)
    {
      const Eigen::MatrixXd &known = halves[h], &unknown = halves[1 - h];
      const InnerModes modes(known(kept, kept));
      // The scores of what is left out, and the products of what they predict.
      const Eigen::MatrixXd scores =
        known(left, kept) * modes.Vectors * modes.Values.cwiseInverse().asDiagonal();
      const Eigen::MatrixXd with = unknown(left, kept) * modes.Vectors,
                            between =
                              modes.Vectors.transpose() * unknown(kept, kept) * modes.Vectors;
      Eigen::VectorXd error(left.size());
      for (std::size_t i = 0; i < left.size(); ++i)
      {
        error(static_cast<Eigen::Index>(i)) = unknown(left[i], left[i]);
      }
      errors(0) += error.sum();
      most = std::min(most, modes.Values.size());
      for (Eigen::Index k = 0; k < modes.Values.size(); ++k)
      {
        // |a - sum_{j <= k} s_j c_j|^2 from that of k - 1.
        const Eigen::ArrayXd cross =
          with.col(k).array() - (scores.leftCols(k) * between.col(k).head(k)).array();
        const Eigen::ArrayXd own = scores.col(k).array();
        error.array() += own * (own * between(k, k) - 2.0 * cross);
        errors(k + 1) += error.sum();
      }
    }
  }
  const Eigen::VectorXd result = errors.head(most + 1);
  return result(0) > 0.0 ? Eigen::VectorXd(result / result(0)) : Eigen::VectorXd::Zero(1);
}

int ChooseNumberOfModes(const Eigen::VectorXd& predictionErrors)
{
  constexpr double worthless = 0.001;
  const double enough = predictionErrors.minCoeff() + worthless;
  int modes = 0;
  while (predictionErrors(modes) > enough)
  {
    ++modes;
  }
  return std::max(modes, 1);
}

LeaveOneOut ComputeLeaveOneOut(
  const Eigen::MatrixXd& products, int modes, int chosen, const Progress& progress)
{
  const Eigen::Index shapes = products.rows();
  Eigen::MatrixXd distances(modes, shapes);
  LeaveOneOut result;
  result.OutlierDistances.resize(shapes);
  ParallelFor(
    static_cast<int>(shapes), 1,
    [&](int begin, int end)
    {
      for (Eigen::Index left = begin; left < end; ++left)
      {
        std::vector<Eigen::Index> others(shapes - 1);
        std::iota(others.begin(), others.begin() + left, 0);
        std::iota(others.begin() + left, others.end(), left + 1);
        const Eigen::MatrixXd centred = CentreOn(others, products);
        const InnerModes inner(centred(others, others));
        const Eigen::VectorXd along = (inner.Vectors.transpose() * centred(others, left))
                                        .cwiseQuotient(inner.Values.cwiseSqrt());
        double squared = centred(left, left), beyond = 0.0;
        result.OutlierDistances(left) = std::sqrt(std::max(squared, 0.0));
        for (Eigen::Index k = 0; k < modes; ++k)
        {
          if (k < along.size())
          {
            squared -= along(k) * along(k);
            const double deviation =
              std::sqrt(inner.Values(k) / static_cast<double>(others.size() - 1));
            const double excess = std::max(std::abs(along(k)) - 3.0 * deviation, 0.0);
            beyond += k < chosen ? excess * excess : 0.0;
          }
          distances(k, left) = std::sqrt(std::max(squared, 0.0));
          if (k + 1 == chosen)
          {
            result.OutlierDistances(left) = std::sqrt(std::max(squared, 0.0) + beyond);
          }
        }
      }
    },
    progress);
  result.Generalisation = distances.rowwise().mean();
  return result;
}

// In coordinates along the modes, the squared distance of a sample b from shape j is
// sum_{k <= M} (b_k - s_jk)^2 v_k + sum_{k > M} s_jk^2 v_k.
Eigen::VectorXd ComputeSpecificity(
  const PrincipalScores& model, int samples, int seed, const Progress& progress)
{
  const Eigen::Index modes = model.Variances.size(), shapes = model.Scores.rows();
  const Eigen::MatrixXd given = model.Scores * model.Variances.cwiseSqrt().asDiagonal();
  std::mt19937_64 random(static_cast<std::uint64_t>(seed));
  std::normal_distribution<double> normal;
  Eigen::MatrixXd squares = given.rowwise().squaredNorm().transpose().replicate(samples, 1);
  Eigen::VectorXd result(modes);
  for (Eigen::Index k = 0; k < modes; ++k)
  {
    progress(static_cast<double>(k) / static_cast<double>(modes));
    const double deviation = std::sqrt(model.Variances(k));
    Eigen::VectorXd weights(samples);
    std::generate(weights.begin(), weights.end(), [&] { return deviation * normal(random); });
    for (Eigen::Index j = 0; j < shapes; ++j)
    {
      // (b - s)^2 - s^2
      squares.col(j).array() += weights.array() * (weights.array() - 2.0 * given(j, k));
    }
    result(k) = squares.rowwise().minCoeff().cwiseMax(0.0).cwiseSqrt().mean();
  }
  return result;
}

} // namespace shape
