#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Finds rows of a matrix by their exact values, such as points by their positions.
class RowFinder
{
public:
  /// rows: n x d, finite; it must exist as long as the finder.
  explicit RowFinder(const Eigen::MatrixXd& rows);

  /// Returns, for each row of `wanted` (m x d), the first row with the same values; -1 if there is
  /// none.
  std::vector<int> Find(const Eigen::MatrixXd& wanted) const;

private:
  const Eigen::MatrixXd& Rows;
  std::vector<int> Order; ///< the rows, sorted by their values, then by their numbers
};

} // namespace shape
