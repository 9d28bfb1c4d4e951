#include "Mesh/CoincidentPoints.h"

#include <algorithm>
#include <numeric>

namespace shape
{

std::vector<int> FindCoincidentPoints(const Eigen::MatrixXd& points)
{
  std::vector<int> order(points.rows()), first(points.rows());
  std::iota(order.begin(), order.end(), 0);
  const auto compare = [&](int a, int b)
  {
    for (int k = 0; k < static_cast<int>(points.cols()); ++k)
    {
      if (points(a, k) != points(b, k))
      {
        return points(a, k) < points(b, k) ? -1 : 1;
      }
    }
    return 0;
  };
  std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return compare(a, b) < 0; });
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    first[order[i]] =
      i > 0 && compare(order[i - 1], order[i]) == 0 ? first[order[i - 1]] : order[i];
  }
  return first;
}

} // namespace shape
