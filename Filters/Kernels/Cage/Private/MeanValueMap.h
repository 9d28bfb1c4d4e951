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
  Eigen::RowVector3d FindStep(const CagePositions& positions, Eigen::Index i) const override;
  Eigen::Matrix3d FindGradient(
    const Eigen::Vector3d& position, const Eigen::Vector3d& near) const override;
};

} // namespace shape
