#pragma once

#include "Cage/Private/TriangleSumMap.h"
#include "Mesh/Mesh.h"

namespace shape
{

/// Green coordinates (CageDeform.h).
class GreenMap : public TriangleSumMap
{
public:
  /// cage: its longest side is 1. moved: the new position of each point (n x 3). Throws
  /// InvalidInput if a triangle has no area.
  GreenMap(const Mesh& cage, const Eigen::MatrixXd& moved);

private:
  bool FollowsCage() const override { return false; }
  void FindSteps(const PositionBlock& block, StepBlock& result) const override;
  void FindSlopes(const PositionBlock& block, SlopeBlock& result) const override;

  Eigen::Matrix3Xd NormalSteps; ///< for each triangle, its moved and stretched normal - its normal
};

} // namespace shape
