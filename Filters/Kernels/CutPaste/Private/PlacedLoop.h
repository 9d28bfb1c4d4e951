#pragma once

#include "ExponentialMap/ExponentialMap.h"

#include <Eigen/Core>

#include <string>

namespace shape
{

/// A loop on a sampled surface.
struct PlacedLoop
{
  Eigen::MatrixXd Positions, Normals; ///< n x 3 each
};

/// Places a loop in the plane of an exponential patch of samples on them. points, normals: of the
/// samples in the patch, in its order. loop: n x 2. elements: the polygons or points of the target,
/// in the error message. Throws InvalidInput if a point of the loop is on no triangle of the patch.
PlacedLoop PlaceLoop(const ExponentialPatch& patch, const Eigen::MatrixXd& points,
  const Eigen::MatrixXd& normals, const Eigen::MatrixXd& loop, const std::string& elements);

/// Whether a polygon (n x 2) contains a position (even-odd rule).
bool Contains(const Eigen::MatrixXd& polygon, const Eigen::RowVector2d& position);

/// The mean length of the edges of a closed polygon.
double MeanEdgeOf(const Eigen::MatrixXd& loop);

} // namespace shape
