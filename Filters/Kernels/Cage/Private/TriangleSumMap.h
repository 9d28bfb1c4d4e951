#pragma once

#include "Cage/Private/CageMap.h"
#include "Cage/Private/CageTriangle.h"
#include "Cage/Private/PositionBlock.h"
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

  std::vector<CageTriangle> Triangles;
  Eigen::Matrix3Xd Steps; ///< a column for each point

private:
  /// Returns the displacement of the point of the cage that is closest to position i.
  Eigen::Vector3d FindNearStep(const CagePositions& positions, Eigen::Index i) const;
  /// Returns positions `begin` up to `end` of `points`, at most a block. The last one fills it.
  PositionBlock MakeBlock(
    const CagePositions& positions, const Eigen::MatrixXd& points, int begin, int end) const;

  /// Whether positions on the cage have the displacement of the cage, and the sums do not apply.
  virtual bool FollowsCage() const = 0;
  virtual void FindSteps(const PositionBlock& block, StepBlock& result) const = 0;
  virtual void FindSlopes(const PositionBlock& block, SlopeBlock& result) const = 0;
};

} // namespace shape
