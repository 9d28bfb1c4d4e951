#pragma once

#include <Eigen/Core>

#include <deque>
#include <functional>

namespace shape
{

/// Returns the sum of the products of all entries: the inner product of two matrices.
double InnerProduct(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b);

/**
 * The approximate inverse Hessian of the limited-memory BFGS method (Nocedal and Wright, "Numerical
 * optimization", 2006, algorithm 7.4). The unknowns are the entries of a matrix. The last 10 steps
 * are kept.
 */
class LimitedMemoryBfgs
{
public:
  /// smooth: applies a fixed symmetric positive definite operator, the first approximation of the
  /// inverse Hessian up to a factor.
  explicit LimitedMemoryBfgs(
    std::function<Eigen::MatrixXd(const Eigen::MatrixXd& gradient)> smooth);

  /// Adds a step of the unknowns and the change of the gradient. Without positive curvature it is
  /// left out, so that the approximation stays positive definite.
  void Add(Eigen::MatrixXd step, Eigen::MatrixXd change);
  bool IsEmpty() const { return this->Entries.empty(); } ///< whether there is no step
  void Clear() { this->Entries.clear(); }                ///< forgets all steps

  /// Returns the product with a gradient. The negative product is a direction of descent.
  Eigen::MatrixXd Apply(Eigen::MatrixXd gradient) const;

private:
  struct Entry
  {
    Eigen::MatrixXd Step, Change;
    double Inverse; ///< 1 / (Step . Change)
  };
  std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)> Smooth;
  std::deque<Entry> Entries;
};

} // namespace shape
