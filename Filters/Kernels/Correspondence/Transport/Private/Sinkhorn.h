#pragma once

#include <Eigen/Core>

namespace shape
{

/**
 * Masses in proportion to exp(likeness + f + g') for an f and a g for which rows and columns add up
 * to given weights, by Sinkhorn's iteration in logarithms now and then and by factors between,
 * over-relaxed near the end, which takes it there in far fewer steps (Thibault, Chizat, Dossal and
 * Papadakis, "Overrelaxed Sinkhorn-Knopp algorithm for regularized optimal transport", 2017). For
 * one likeness after another it begins with the f and g at which it ended.
 */
class Sinkhorn
{
public:
  /// rows, columns: positive weights of the same sum.
  Sinkhorn(const Eigen::VectorXd& rows, const Eigen::VectorXd& columns);

  /// The columns' sums are exact, the rows' within `tolerance` of the whole or as far as
  /// `iterations` lead. likeness: finite, or -infinity where nothing may go.
  Eigen::MatrixXd Masses(const Eigen::MatrixXd& likeness, int iterations, double tolerance);

  /// How far the last masses' rows are from their weights, summed up.
  double Error() const { return this->RowError; }

  /// Before likeness that is that many times the last one.
  void Scale(double factor);

private:
  /// The masses whose rows fit; and then the columns, where sums of these are not lost in rounding.
  Eigen::MatrixXd Begin(const Eigen::MatrixXd& likeness);

  Eigen::VectorXd Rows, Columns;
  Eigen::VectorXd OfRows, OfColumns; ///< f and g
  double RowError = 0.0;
};

} // namespace shape
