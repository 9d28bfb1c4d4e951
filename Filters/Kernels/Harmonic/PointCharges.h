#pragma once

#include "Harmonic/ChargeSet.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Evaluates the map of a charge set at one point at a time. The sum runs over several charges at
 * once, with the vector instructions of the processor. The values agree with the function Evaluate
 * (ChargeSet.h), which vectorizes over points, up to rounding. On the same processor they always
 * have the same bits. Can be used from several threads.
 */
class PointCharges
{
public:
  explicit PointCharges(const ChargeSet& set);

  /// Returns f at `position`; infinite or NaN at the position of a charge.
  Eigen::Vector3d Evaluate(const Eigen::Vector3d& position) const;

  /// Returns f at `position` and sets `jacobian` to its derivative: jacobian(r, c) = d f_r / d y_c.
  Eigen::Vector3d Evaluate(const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const;

private:
  Eigen::Matrix<double, 3, 4> Affine;
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double Size = 1.0; ///< longest side of the charges' box
  /// Six arrays of length Stride: the coordinates x, y, z of the charges relative to Origin,
  /// divided by Size; then the three components of the charges / (4 pi Size).
  std::vector<double> Packed;
  std::size_t Stride = 0;
};

} // namespace shape
