#pragma once

#include "Cage/Private/TriangleSumMap.h"
#include "Mesh/Mesh.h"

namespace shape
{

/// Mean value coordinates (CageDeform.h).
class MeanValueMap : public TriangleSumMap
{
public:
  /// cage: its longest side is 1. steps: the displacement of each point (n x 3). Throws
  /// InvalidInput if a triangle has no area.
  MeanValueMap(const Mesh& cage, const Eigen::MatrixXd& steps);

private:
  bool FollowsCage() const override { return true; }
  void FindSteps(const PositionBlock& block, StepBlock& result) const override;
  void FindSlopes(const PositionBlock& block, SlopeBlock& result) const override;
};

} // namespace shape
