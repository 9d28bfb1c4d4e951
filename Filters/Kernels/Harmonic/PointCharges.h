#pragma once

#include "Harmonic/ChargeSet.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Evaluates the map of a charge set at one point at a time. The sum runs over several charges at
 * once, with the vector instructions of the processor. The values agree with the function Evaluate
 * (ChargeSet.h), which vectorizes over points, up to rounding. They are the same bits on the same
 * processor. Can be used from several threads.
 */
class PointCharges
{
public:
  explicit PointCharges(const ChargeSet& set);

  /// Returns f at `position`; infinite or NaN at the position of a charge.
  Eigen::Vector3d Evaluate(const Eigen::Vector3d& position) const;

  /// Returns f and computes its derivative: jacobian(r, c) = d f_r / d y_c.
  Eigen::Vector3d Evaluate(const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const;

private:
  Eigen::Matrix<double, 3, 4> Affine;
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double Size = 1.0; ///< longest side of the charges' box
  /// Arrays of length Stride: positions x, y, z of the charges in units of their box, then the
  /// three charges / (4 pi Size).
  std::vector<double> Packed;
  std::size_t Stride = 0;
};

} // namespace shape
