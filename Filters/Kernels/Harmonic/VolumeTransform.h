#pragma once

#include "Harmonic/PiecewiseInverseMap.h"
#include "Harmonic/PointCharges.h"

#include <memory>
#include <vector>

namespace shape
{

/**
 * A volume map and its inverse at one point at a time, as a transformation of all space: outside
 * the domain, or the image, and where no preimage is found, points keep their place. Used from any
 * thread.
 */
class VolumeTransform
{
public:
  /// Without `withInverse` only Forward may be called; setting up the inverse takes a while.
  /// Throws as PiecewiseHarmonicMap and PiecewiseInverseMap do.
  VolumeTransform(const PiecewiseCharges& charges, bool withInverse);

  struct Result
  {
    Eigen::Vector3d Position;
    InverseMap::State State = InverseMap::State::Found; ///< else the place is the point's own
    /// Of the map, also where it was inverted: there at the place. The identity where the point
    /// keeps its place.
    Eigen::Matrix3d Jacobian = Eigen::Matrix3d::Identity();
  };

  /// f(y) at y; a point that is not finite is Outside.
  Result Forward(const Eigen::Vector3d& point) const;

  /// x with f(x) = y, see PiecewiseInverseMap: first by Newton's method from the nearest seed, with
  /// all its means where that fails.
  Result Backward(const Eigen::Vector3d& point) const;

  ///@{
  /// Many points (n x 3) by all threads: the same results.
  std::vector<Result> Forward(const Eigen::MatrixXd& points) const;
  std::vector<Result> Backward(const Eigen::MatrixXd& points) const;
  ///@}

private:
  Eigen::Vector3d Evaluate(const Eigen::Vector3d& position, Eigen::Matrix3d& jacobian) const;
  bool IsOutside(const Eigen::Vector3d& position) const;

  std::shared_ptr<const PiecewiseHarmonicMap> Map;
  std::unique_ptr<const PiecewiseInverseMap> Inverse;
  std::vector<PointCharges> Charges; ///< by region
};

} // namespace shape
