#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Computes masses proportional to exp(likeness + f + g'), with f and g chosen to give the rows and
 * columns their prescribed sums. It uses Sinkhorn's iteration. Most steps multiply factors; some
 * work in logarithms, which stay in range. Over-relaxation near the end saves most of the steps
 * (Thibault, Chizat, Dossal and Papadakis, "Overrelaxed Sinkhorn-Knopp algorithm for regularized
 * optimal transport", 2017). Each call of Masses starts with the last f and g.
 */
class Sinkhorn
{
public:
  /// rows, columns: positive weights with the same sum.
  Sinkhorn(const Eigen::VectorXd& rows, const Eigen::VectorXd& columns);

  /// Returns the masses. The column sums are exact. The row sums differ from the prescribed ones by
  /// less than `tolerance` in total, unless `iterations` steps do not suffice. likeness: each entry
  /// is finite, or -infinity if the mass must be 0.
  Eigen::MatrixXd Masses(const Eigen::MatrixXd& likeness, int iterations, double tolerance,
    const Progress& progress = {});

  /// The sum of |row sum - weight| for the last masses.
  double Error() const { return this->RowError; }

  /// Call this before Masses if the likeness is `factor` times the last one.
  void Scale(double factor);

private:
  /// Returns masses with exact row sums. If a column sum is lost by underflow, returns masses with
  /// exact column sums instead.
  Eigen::MatrixXd Begin(const Eigen::MatrixXd& likeness);

  Eigen::VectorXd Rows, Columns;
  Eigen::VectorXd OfRows, OfColumns; ///< f and g
  double RowError = 0.0;
};

} // namespace shape
