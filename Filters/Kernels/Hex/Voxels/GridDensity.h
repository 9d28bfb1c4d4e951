#pragma once

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// Space grows around a place: by exp(Strength) there, less and less up to some Radii away.
struct RefinementSeed
{
  Eigen::RowVector3d Centre;
  double Radius = 1.0;
  double Strength = 0.0;
};

/**
 * A smooth one-to-one map of space that magnifies it around some places, so that a uniform grid in
 * its image is a finer one there: the flow, for a time of 1, of the velocity
 *
 *   v(x) = sum over magnifiers of Strength (x - Centre) exp(-|x - Centre|^2 / (2 Radius^2)).
 *
 * A flow cannot fold, whatever the magnifiers are.
 */
class GridDensity
{
public:
  explicit GridDensity(std::vector<RefinementSeed> magnifiers = {})
    : Seeds(std::move(magnifiers))
  {
  }

  bool IsIdentity() const { return this->Seeds.empty(); }

  /// points: n x 3.
  Eigen::MatrixXd Forward(const Eigen::MatrixXd& points) const { return this->Flow(points, 1.0); }
  Eigen::MatrixXd Backward(const Eigen::MatrixXd& points) const { return this->Flow(points, -1.0); }

private:
  Eigen::RowVector3d Velocity(const Eigen::RowVector3d& position) const;
  Eigen::MatrixXd Flow(const Eigen::MatrixXd& points, double time) const;

  std::vector<RefinementSeed> Seeds;
};

} // namespace shape
