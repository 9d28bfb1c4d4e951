#pragma once

#include "Base/Progress.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

namespace shape
{

/// Positions relative to a cage whose longest side is 1.
struct CagePositions
{
  Eigen::MatrixXd Points;     ///< n x 3
  Eigen::VectorXi IsOnCage;   ///< n: whether a point is on the cage, up to rounding
  SurfacePoints Closest;      ///< of the cage
  Eigen::MatrixXd GradientAt; ///< n x 3: off the cage, where gradients are computed; or empty
};

/// How the positions move.
struct CageMotion
{
  Eigen::MatrixXd Steps;     ///< n x 3: the displacement
  Eigen::MatrixXd Gradients; ///< n x 9: of the displacement; empty without GradientAt
};

/// A map that carries displacements of a cage to positions.
class CageMap
{
public:
  virtual ~CageMap() = default;
  /// Returns the motion of each position. Throws Aborted.
  virtual CageMotion Evaluate(const CagePositions& positions, const Progress& progress) const = 0;
};

} // namespace shape
