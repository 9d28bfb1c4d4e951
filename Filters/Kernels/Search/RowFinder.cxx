#include "Search/RowFinder.h"

#include <algorithm>
#include <numeric>

namespace shape
{
namespace
{

/// Returns -1, 0 or 1 if a row is before, equal to or after another in lexicographic order.
int CompareRows(const Eigen::MatrixXd& a, Eigen::Index i, const Eigen::MatrixXd& b, Eigen::Index j)
{
  for (Eigen::Index column = 0; column < a.cols(); ++column)
  {
    if (a(i, column) != b(j, column))
    {
      return a(i, column) < b(j, column) ? -1 : 1;
    }
  }
  return 0;
}

} // namespace

RowFinder::RowFinder(const Eigen::MatrixXd& rows)
  : Rows(rows)
  , Order(static_cast<std::size_t>(rows.rows()))
{
  std::iota(this->Order.begin(), this->Order.end(), 0);
  std::sort(this->Order.begin(), this->Order.end(),
    [&](int i, int j)
    {
      const int order = CompareRows(rows, i, rows, j);
      return order < 0 || (order == 0 && i < j);
    });
}

std::vector<int> RowFinder::Find(const Eigen::MatrixXd& wanted) const
{
  std::vector<int> found(static_cast<std::size_t>(wanted.rows()), -1);
  for (std::size_t i = 0; i < found.size(); ++i)
  {
    const auto row = static_cast<Eigen::Index>(i);
    const auto first = std::lower_bound(this->Order.begin(), this->Order.end(), row,
      [&](int own, Eigen::Index other) { return CompareRows(this->Rows, own, wanted, other) < 0; });
    if (first != this->Order.end() && CompareRows(this->Rows, *first, wanted, row) == 0)
    {
      found[i] = *first;
    }
  }
  return found;
}

} // namespace shape
