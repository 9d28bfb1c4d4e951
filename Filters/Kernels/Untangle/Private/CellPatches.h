#pragma once

#include "Base/Progress.h"
#include "Untangle/MinimizeEnergy.h"
#include "Untangle/Private/SolidCells.h"

#include <Eigen/Core>

#include <functional>
#include <vector>

namespace shape
{

/// Returns the inverted cells, ascending. Throws Aborted.
std::vector<int> FindInverted(SolidCells& solid, const Progress& progress = {});

/// Returns some points, all different, and those of `rings` rings of cells around them, ascending.
/// Throws Aborted.
std::vector<int> FindPointsAround(
  const SolidCells& solid, std::vector<int> points, int rings, const Progress& progress = {});

/// Marks the points of inverted cells and of the `rings` - 1 rings of cells around these. Returns
/// one value for each point, 0 or 1. Throws Aborted.
std::vector<char> MarkAroundInverted(SolidCells& solid, int rings, const Progress& progress = {});

/// Returns the movable points among the marked ones (one value for each point). Each set of them
/// that cells connect is a separate patch (ascending), whose energy is minimised by itself.
/// movable: returns whether a point may move. Throws Aborted.
std::vector<std::vector<int>> FindMovablePatches(const SolidCells& solid,
  const std::vector<char>& marked, const std::function<bool(int point)>& movable,
  const Progress& progress = {});

/// Returns the corner tetrahedra at `points` (ascending), which are free. sizes: the logarithm of
/// the target size at each point (ComputeLogarithmicSizes). Throws Aborted.
SimplexPatch BuildPatch(SolidCells& solid, const std::vector<int>& points,
  const Eigen::VectorXd& sizes, const Progress& progress = {});

/// Returns the number of tetrahedra of a patch that are not positive, by exact predicates. x (n x
/// 3): the positions of all points.
int CountNegative(const SimplexPatch& patch, const Eigen::MatrixXd& x);

} // namespace shape
