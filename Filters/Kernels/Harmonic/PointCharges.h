#pragma once

#include "Harmonic/ChargeSet.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * A charge set's map at one place at a time: its sum goes over several charges at once, with the
 * vector instructions that the processor at hand has, while Evaluate goes over several places. The
 * values agree with Evaluate's to rounding, and are the same bits on the same processor. Used from
 * any thread.
 */
class PointCharges
{
public:
  explicit PointCharges(const ChargeSet& set);

  /// f at y; infinite or NaN at a charge's own place.
  Eigen::Vector3d Evaluate(const Eigen::Vector3d& position) const;

  /// The same, and its derivative: jacobian(r, c) = d f_r / d y_c.
  Eigen::Vector3d Evaluate(const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const;

private:
  Eigen::Matrix<double, 3, 4> Affine;
  Eigen::RowVector3d Origin = Eigen::RowVector3d::Zero();
  double Size = 1.0; ///< of the charges' box
  /// The places of the charges in it, x y z, then their weights / (4 pi Size); each as long as
  /// Stride.
  std::vector<double> Packed;
  std::size_t Stride = 0;
};

} // namespace shape
