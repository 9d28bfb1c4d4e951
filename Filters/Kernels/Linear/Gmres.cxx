#include "Linear/Gmres.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <vector>

namespace shape
{

GmresResult SolveGmres(const LinearMap& a, const LinearMap& b, const Eigen::MatrixXd& rightSide,
  const Eigen::VectorXd& weights, const GmresOptions& options, const Progress& progress)
{
  // Outline (Saad and Schultz 1986, for the operator A B):
  // 1. Each iteration applies A B to the last basis vector of every column.
  // 2. Modified Gram-Schmidt makes the result orthogonal to the basis; the coefficients are a
  //    column of the Hessenberg matrix.
  // 3. A small least-squares problem gives the residual of every column.
  // 4. At the end the solution is B times a combination of the basis.
  const Eigen::Index columns = rightSide.cols();
  const Eigen::VectorXd shares = weights / weights.sum();
  // Mean products over the rows, so a norm is a root mean square.
  const auto inner = [&](const Eigen::MatrixXd& u, const Eigen::MatrixXd& v)
  {
    if (options.Inner)
    {
      return options.Inner(u, v);
    }
    Eigen::RowVectorXd products(columns);
    for (Eigen::Index c = 0; c < columns; ++c)
    {
      products(c) = (shares.array() * u.col(c).array() * v.col(c).array()).sum();
    }
    return products;
  };
  // Columns without a residual become zero and stay zero.
  const auto normalized = [](const Eigen::MatrixXd& v, const Eigen::RowVectorXd& norms)
  {
    return Eigen::MatrixXd(
      v * (norms.array() > 0.0).select(norms.cwiseInverse(), 0.0).matrix().asDiagonal());
  };

  const int maximum = options.MaximumIterations;
  const Eigen::RowVectorXd start = inner(rightSide, rightSide).cwiseSqrt();
  GmresResult result;
  result.Residuals = start;
  std::vector<Eigen::MatrixXd> basis{ normalized(rightSide, start) };
  std::vector<Eigen::MatrixXd> hessenbergs(columns, Eigen::MatrixXd::Zero(maximum + 1, maximum));
  std::vector<Eigen::VectorXd> factors(columns), rests(columns);
  for (Eigen::Index c = 0; c < columns; ++c)
  {
    rests[c] = start.segment(c, 1);
  }
  // Number of iterations in a row: far from the goal, a plateau often ends again.
  constexpr int patience = 3, patienceNear = 2;
  constexpr double nearGoal = 4.0;
  int idle = 0;
  // The share of the work: on a logarithmic scale, the residual decreases about evenly.
  double share = 0.0;
  const auto completed = [&](int iterations)
  {
    const double ratio = start.maxCoeff() / result.Residuals.maxCoeff(),
                 goal = start.maxCoeff() / options.Tolerance;
    const double decrease = goal > 1.0 ? std::log(ratio) / std::log(goal) : 0.0;
    return std::min(1.0, std::max({ share, decrease, double(iterations) / maximum }));
  };
  while (result.Iterations < maximum && result.Residuals.maxCoeff() > options.Tolerance)
  {
    const int k = result.Iterations;
    share = completed(k);
    const double end = completed(k + 1);
    progress(share);
    if (options.Relax)
    {
      options.Relax(result.Residuals.maxCoeff() / start.maxCoeff());
    }
    // Step 1: the operator.
    const double middle = 0.7 * share + 0.3 * end;
    Eigen::MatrixXd next = a(b(basis[k], progress.Part(share, middle)), progress.Part(middle, end));
    const Eigen::RowVectorXd before = inner(next, next).cwiseSqrt();
    // Step 2: orthogonalisation.
    for (int i = 0; i <= k; ++i)
    {
      const Eigen::RowVectorXd product = inner(basis[i], next);
      next -= basis[i] * product.asDiagonal();
      for (Eigen::Index c = 0; c < columns; ++c)
      {
        hessenbergs[c](i, k) = product(c);
      }
    }
    // A remainder of rounding error is not a direction.
    constexpr double rounding = 1e-14;
    Eigen::RowVectorXd norms = inner(next, next).cwiseSqrt();
    norms = (norms.array() > rounding * before.array()).select(norms, 0.0);
    basis.push_back(normalized(next, norms));
    // Step 3. The decomposition also solves columns whose basis has ended, where the matrix is
    // singular.
    const Eigen::RowVectorXd last = result.Residuals;
    for (Eigen::Index c = 0; c < columns; ++c)
    {
      hessenbergs[c](k + 1, k) = norms(c);
      const Eigen::MatrixXd h = hessenbergs[c].topLeftCorner(k + 2, k + 1);
      const Eigen::VectorXd wanted = start(c) * Eigen::VectorXd::Unit(k + 2, 0);
      factors[c] = h.completeOrthogonalDecomposition().solve(wanted);
      rests[c] = wanted - h * factors[c];
      result.Residuals(c) = rests[c].norm();
    }
    ++result.Iterations;
    idle =
      (result.Residuals.array() > (1.0 - options.LeastGain) * last.array()).all() ? idle + 1 : 0;
    if (idle >=
      (result.Residuals.maxCoeff() > nearGoal * options.Tolerance ? patience : patienceNear))
    {
      break;
    }
  }
  const auto combined = [&](const std::vector<Eigen::VectorXd>& weightsOfBasis)
  {
    Eigen::MatrixXd sum = Eigen::MatrixXd::Zero(rightSide.rows(), columns);
    for (Eigen::Index c = 0; c < columns; ++c)
    {
      for (Eigen::Index i = 0; i < weightsOfBasis[c].size(); ++i)
      {
        sum.col(c) += weightsOfBasis[c](i) * basis[i].col(c);
      }
    }
    return sum;
  };
  // Step 4: the solution.
  result.Solution = b(combined(factors), progress.Part(share, 1.0));
  result.Left = combined(rests);
  return result;
}

} // namespace shape
