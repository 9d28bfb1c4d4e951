#pragma once

#include "Harmonic/PiecewiseInverseMap.h"
#include "Harmonic/PointCharges.h"

#include <memory>
#include <vector>

namespace shape
{

/**
 * Evaluates a volume map and its inverse at one point at a time, as a transformation of all space.
 * Points outside the domain or the image, and points without a preimage, are not moved. Can be used
 * from several threads.
 */
class VolumeTransform
{
public:
  /// Without `withInverse`, only Forward may be called; constructing the inverse takes a while.
  /// Throws the exceptions of PiecewiseHarmonicMap and PiecewiseInverseMap.
  VolumeTransform(const PiecewiseCharges& charges, bool withInverse);

  struct Result
  {
    Eigen::Vector3d Position;
    /// if not Found, Position is the given point
    InverseMap::State State = InverseMap::State::Found;
    /// The derivative of the forward map: Forward takes it at the given point, Backward at the
    /// preimage. It is the identity if the point is not moved.
    Eigen::Matrix3d Jacobian = Eigen::Matrix3d::Identity();
  };

  /// Returns f at the point; a point that is not finite is Outside.
  Result Forward(const Eigen::Vector3d& point) const;

  /// Returns x with f(x) = y. Newton's method from the nearest seed is tried first, then the
  /// complete search of PiecewiseInverseMap.
  Result Backward(const Eigen::Vector3d& point) const;

  ///@{
  /// The same for many points (n x 3), in parallel.
  std::vector<Result> Forward(const Eigen::MatrixXd& points) const;
  std::vector<Result> Backward(const Eigen::MatrixXd& points) const;
  ///@}

private:
  Eigen::Vector3d Evaluate(const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const;
  Eigen::Vector3d EvaluateRepaired(
    const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const;
  bool IsOutside(const Eigen::Vector3d& position) const;

  std::shared_ptr<const PiecewiseHarmonicMap> Map;
  std::unique_ptr<const PiecewiseInverseMap> Inverse;
  std::vector<PointCharges> Charges; ///< one for each region
};

} // namespace shape
