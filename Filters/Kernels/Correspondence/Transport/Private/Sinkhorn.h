#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * Computes masses proportional to exp(likeness + f + g'), with f and g chosen to give the rows and
 * columns their prescribed sums. It uses Sinkhorn's iteration, with factors in most steps and in
 * logarithms in some. Over-relaxation near the end saves most of the steps (Thibault, Chizat,
 * Dossal and Papadakis, "Overrelaxed Sinkhorn-Knopp algorithm for regularized optimal transport",
 * 2017). For the next likeness it starts with the last f and g.
 */
class Sinkhorn
{
public:
  /// rows, columns: positive weights with the same sum.
  Sinkhorn(const Eigen::VectorXd& rows, const Eigen::VectorXd& columns);

  /// Returns the masses. The columns' sums are exact. The rows' sums are exact up to `tolerance`
  /// times the total, or what `iterations` steps achieve. likeness: finite, or -infinity for masses
  /// that must be 0.
  Eigen::MatrixXd Masses(const Eigen::MatrixXd& likeness, int iterations, double tolerance);

  /// The sum of the differences between the last masses' row sums and the weights.
  double Error() const { return this->RowError; }

  /// Call this before a likeness that is `factor` times the last one.
  void Scale(double factor);

private:
  /// Returns masses whose row sums are exact. If a column sum is lost in rounding, the column sums
  /// are then made exact as well.
  Eigen::MatrixXd Begin(const Eigen::MatrixXd& likeness);

  Eigen::VectorXd Rows, Columns;
  Eigen::VectorXd OfRows, OfColumns; ///< f and g
  double RowError = 0.0;
};

} // namespace shape
