#pragma once

#include "Base/Progress.h"
#include "Untangle/Private/SolidCells.h"

#include <Eigen/Core>

namespace shape
{

/// Why cells stay inverted in a fixed boundary: the members of the same names of UntangleResult.
struct BoundaryFaults
{
  int BoundaryCrossings = 0;
  Eigen::RowVector3d FirstCrossing = Eigen::RowVector3d::Zero();
  int FoldedEdges = 0;
  Eigen::RowVector3d FirstFolded = Eigen::RowVector3d::Zero();
  int HiddenTriangles = 0;
  Eigen::RowVector3d FirstHidden = Eigen::RowVector3d::Zero();
  double StarClearance = 0.0;
};

/// Finds out whether the boundary crosses itself or folds back on itself, and which triangles are
/// hidden from the best position inside. Triangles without an area do not count. Throws Aborted.
BoundaryFaults FindBoundaryFaults(const SolidCells& solid, const Progress& progress);

} // namespace shape
