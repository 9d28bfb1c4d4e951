#pragma once

#include "Cage/Private/CageMap.h"
#include "Cage/Private/CageTriangle.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// A map that is a sum over the triangles of a cage at each position.
class TriangleSumMap : public CageMap
{
public:
  CageMotion Evaluate(const CagePositions& positions, const Progress& progress) const final;

protected:
  /// cage: its longest side is 1. steps: the displacement of each point (n x 3). Throws
  /// InvalidInput if a triangle has no area.
  TriangleSumMap(const Mesh& cage, const Eigen::MatrixXd& steps);

  /// Returns the displacement of the point of the cage that is closest to position i.
  Eigen::Vector3d FindNearStep(const CagePositions& positions, Eigen::Index i) const;

  std::vector<CageTriangle> Triangles;
  Eigen::Matrix3Xd Steps; ///< a column for each point

private:
  /// Returns the displacement of position i.
  virtual Eigen::RowVector3d FindStep(const CagePositions& positions, Eigen::Index i) const = 0;
  /// Returns the gradient of the displacement. near: FindNearStep.
  virtual Eigen::Matrix3d FindGradient(
    const Eigen::Vector3d& position, const Eigen::Vector3d& near) const = 0;
};

} // namespace shape
