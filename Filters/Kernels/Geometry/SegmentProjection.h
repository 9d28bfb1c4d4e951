#pragma once

#include <Eigen/Core>

#include <algorithm>

namespace shape
{

/// Returns the t in [0, 1] for which begin + t (end - begin) is nearest to a position, in any
/// dimension; 0 if the segment has no length.
template <typename Position, typename Begin, typename End>
double ProjectOntoSegment(const Eigen::MatrixBase<Position>& position,
  const Eigen::MatrixBase<Begin>& begin, const Eigen::MatrixBase<End>& end)
{
  const double squared = (end - begin).squaredNorm();
  return squared > 0.0 ? std::clamp((position - begin).dot(end - begin) / squared, 0.0, 1.0) : 0.0;
}

} // namespace shape
