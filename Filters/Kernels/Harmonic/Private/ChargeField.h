#pragma once

#include "Harmonic/Private/BoxInSolid.h"
#include "Harmonic/Private/TaylorExpansion.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shape
{

/// The field of charges in a cube: a polynomial for the far ones, and the others.
struct ChargeField
{
  TaylorExpansion Far;                                 ///< with the affine part
  Eigen::Vector3d Centre = Eigen::Vector3d::Zero();    ///< of Far
  Eigen::Matrix3d HighTerms = Eigen::Matrix3d::Zero(); ///< TaylorExpansion::BoundHighTerms
  /// For each component, a bound of the polynomial's error in the cube.
  Eigen::Vector3d ValueError = Eigen::Vector3d::Zero();
  std::vector<int> Near;
};

/// Returns the field for the children of a cube, from that for the cube: charges that are far from
/// the cube become part of the polynomial, if they are many.
std::shared_ptr<const ChargeField> Descend(const std::shared_ptr<const ChargeField>& field,
  const ChargeColumns& charges, const BoxCube& cube);

} // namespace shape
