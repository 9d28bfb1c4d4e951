#pragma once

#include "Mesh/Mesh.h"
#include "Remesh/SurfaceFeatures.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A curve of a surface as a polyline that is parameterised by arc length. If it is closed, it is
/// periodic: arc lengths may exceed its range.
class ArcLength
{
public:
  ArcLength(const Mesh& surface, const FeatureCurve& curve);

  double Length() const { return this->Lengths.back(); }

  /// Returns the arc lengths at bends of more than an angle, the sharpest first.
  std::vector<double> Turns(double degrees) const;

  /// Returns the part between two arc lengths.
  Eigen::MatrixXd Part(double begin, double end) const;

  /// Returns the arc lengths of the bends strictly between two arc lengths, nearly straight ones
  /// left out.
  std::vector<double> BendsBetween(double begin, double end) const;

  /// Returns the largest distance of the part between two arc lengths from its chord.
  double Deviation(double begin, double end) const;

  /// Returns the arc length at the point closest to a position.
  double Nearest(const Eigen::RowVector3d& position) const;

  /// Returns the position at an arc length.
  Eigen::RowVector3d At(double length) const;

private:
  /// Returns those of ascending arc lengths on the line that are strictly between two others.
  std::vector<double> Between(const std::vector<double>& lengths, double begin, double end) const;

  Eigen::MatrixXd Points;
  bool Closed;
  std::vector<double> Lengths; ///< arc length at each point; if closed, also back at the first
  std::vector<double> Bends;   ///< arc lengths at bends, ascending
};

} // namespace shape
