#pragma once

#include "Cage/Private/CageMap.h"
#include "Cage/Private/CageTriangle.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// Green coordinates (CageDeform.h).
class GreenMap : public CageMap
{
public:
  /// cage: its longest side is 1. moved: the new position of each point (n x 3). Throws
  /// InvalidInput if a triangle has no area.
  GreenMap(const Mesh& cage, const Eigen::MatrixXd& moved);
  CageMotion Evaluate(const CagePositions& positions, const Progress& progress) const override;

private:
  Eigen::RowVector3d FindStep(const CagePositions& positions, Eigen::Index i) const;
  Eigen::Matrix3d FindGradient(const Eigen::Vector3d& position, const Eigen::Vector3d& near) const;

  std::vector<CageTriangle> Triangles;
  Eigen::Matrix3Xd Steps;       ///< the displacement of each point
  Eigen::Matrix3Xd NormalSteps; ///< for each triangle, its moved and stretched normal - its normal
};

} // namespace shape
