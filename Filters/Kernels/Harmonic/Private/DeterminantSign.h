#pragma once

#include "Harmonic/Private/TaylorExpansion.h"

#include <Eigen/Core>

#include <limits>

namespace shape
{

/// What is proven about the Jacobian determinant det J in a box.
struct DeterminantSign
{
  int Sign = 0;       ///< 0: nothing
  double Bound = 0.0; ///< with a sign: |det J| is at least this
  /// Without a sign: the corner where the linear terms have the lowest determinant, relative to the
  /// centre, and this determinant.
  Eigen::Vector3d Lowest = Eigen::Vector3d::Zero();
  double Estimate = std::numeric_limits<double>::infinity();
};

/// Bounds the determinant in the box around the centre of an expansion, whose terms up to `degree`
/// are used. half: half its edges, and 0 for the centre alone. leftOut: bounds for the entries of
/// the Jacobian of what the expansion leaves out, besides its own. The method: CertifyMap.
DeterminantSign BoundDeterminant(const TaylorExpansion& expansion, const Eigen::Vector3d& half,
  int degree, const Eigen::Matrix3d& leftOut = Eigen::Matrix3d::Zero());

} // namespace shape
