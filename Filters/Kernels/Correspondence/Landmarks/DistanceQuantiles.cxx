#include "Correspondence/Landmarks/DistanceQuantiles.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <vector>

namespace shape
{

Eigen::MatrixXd ComputeDistanceQuantiles(
  const Eigen::MatrixXd& distances, const Eigen::VectorXd& weights, int levels)
{
  const double whole = std::max(weights.sum(), std::numeric_limits<double>::min());
  Eigen::MatrixXd quantiles(distances.cols(), levels);
  std::vector<int> order(distances.rows());
  for (Eigen::Index k = 0; k < distances.cols(); ++k)
  {
    const auto own = distances.col(k);
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return own(i) < own(j); });
    double below = 0.0;
    int level = 0;
    for (const int point : order)
    {
      below += weights(point);
      for (; level < levels && below >= (level + 0.5) / levels * whole; ++level)
      {
        quantiles(k, level) = own(point);
      }
    }
    quantiles.row(k).tail(levels - level).setConstant(own.maxCoeff());
  }
  return quantiles;
}

} // namespace shape
