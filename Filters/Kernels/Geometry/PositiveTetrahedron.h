#pragma once

#include "Geometry/Orientation.h"

namespace shape
{

/// Whether a tetrahedron (four rows of points, n x 3) is positive, by exact predicates: its volume
/// is not 0, and its corners are in the order of VTK.
template <typename FourIndices>
bool IsPositive(const Eigen::MatrixXd& points, const FourIndices& corners)
{
  return EvaluateOrientation(points.row(corners[0]), points.row(corners[1]), points.row(corners[2]),
           points.row(corners[3])) > 0;
}

} // namespace shape
