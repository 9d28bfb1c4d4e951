#pragma once

#include "Base/Errors.h"
#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"
#include "Transfer/TransferFields.h"

#include <string>

namespace shape
{

/// A precise map, stored in point arrays (n rows each) that have the names of these members.
struct PreciseArrays
{
  Eigen::VectorXd TargetCell;
  Eigen::MatrixXd TargetBarycentric; ///< n x 3
  Eigen::MatrixXd TargetPosition;    ///< n x 3
};

/// Thrown if the arrays are valid, but were made for another target.
class MapOfAnotherSurface : public InvalidInput
{
public:
  using InvalidInput::InvalidInput;
};

/// A surface with the cell numbers that TargetCell contains.
struct NumberedSurface
{
  Mesh Surface;
  int First = 0;         ///< the cell number of its first polygon; vertices and lines come before
  Eigen::VectorXi Cells; ///< m: the polygon that contains each triangle
};

/**
 * Returns the map given by the arrays, into the triangles of `target`. Where two sheets of the
 * target lie close together, the arrays determine the correct sheet. The point closest to
 * TargetPosition may lie on the wrong sheet.
 *
 * tolerance: the maximum distance between the mapped position and TargetPosition, relative to the
 * longest edge of the target's bounding box. pointsName, targetName: denote the points and the
 * target in messages, for example "the Input".
 *
 * Throws InvalidInput if a number is not finite, or if the barycentric coordinates of a point
 * include a negative one or do not sum to 1, up to single precision. Throws MapOfAnotherSurface if
 * a cell is no triangle of the target, or if the positions are farther apart than the tolerance.
 */
SurfacePoints RequirePreciseMap(const PreciseArrays& arrays, const NumberedSurface& target,
  double tolerance, const std::string& pointsName, const std::string& targetName);

/// Returns the weights that interpolate values from the giver's points to the positions in `map`,
/// which lie on the giver's triangles. Outside is 0 for all points.
TransferWeights LocateOnTriangles(const SurfacePoints& map, const NumberedSurface& giver);

} // namespace shape
