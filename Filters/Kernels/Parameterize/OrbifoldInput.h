#pragma once

#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Throws InvalidInput unless the surface is closed, of one component and genus 0, and uses all of
/// its points, and the cones are different points of it.
void RequireOrbifoldInput(const Surface& surface, const std::vector<int>& cones);

/// Throws SolveFailure if a triangle of the cut surface is not counter-clockwise in its image
/// (n x 2), by exact predicates.
void RequireUnflippedTile(const Mesh& cut, const Eigen::MatrixXd& image);

} // namespace shape
