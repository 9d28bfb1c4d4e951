#pragma once

#include "Cage/Private/CageMap.h"
#include "Cage/Private/CageTriangle.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// Mean value coordinates (CageDeform.h).
class MeanValueMap : public CageMap
{
public:
  /// cage: its longest side is 1. steps: the displacement of each point (n x 3). Throws
  /// InvalidInput if a triangle has no area.
  MeanValueMap(const Mesh& cage, const Eigen::MatrixXd& steps);
  CageMotion Evaluate(const CagePositions& positions, const Progress& progress) const override;

private:
  Eigen::RowVector3d FindStep(const CagePositions& positions, Eigen::Index i) const;
  Eigen::Matrix3d FindGradient(const Eigen::Vector3d& position, const Eigen::Vector3d& near) const;

  std::vector<CageTriangle> Triangles;
  Eigen::Matrix3Xd Steps; ///< a column for each point
};

} // namespace shape
