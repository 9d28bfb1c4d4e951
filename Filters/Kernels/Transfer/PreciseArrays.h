#pragma once

#include "Base/Errors.h"
#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"
#include "Transfer/TransferFields.h"

#include <string>

namespace shape
{

/// A precise map in the form of point arrays of these names (n rows).
struct PreciseArrays
{
  Eigen::VectorXd TargetCell;
  Eigen::MatrixXd TargetBarycentric; ///< n x 3
  Eigen::MatrixXd TargetPosition;    ///< n x 3
};

/// Thrown if the arrays are valid but were made for another target.
class MapOfAnotherSurface : public InvalidInput
{
public:
  using InvalidInput::InvalidInput;
};

/// A surface with the cell numbers that TargetCell refers to.
struct NumberedSurface
{
  Mesh Surface;
  int First = 0;         ///< the cell number of its first triangle, after vertices and lines
  Eigen::VectorXi Cells; ///< m: the polygon that contains each triangle
};

/**
 * Returns the map given by the arrays, into the triangles of `target`. Where sheets lie close
 * together it determines the correct one, unlike the point closest to TargetPosition.
 *
 * tolerance: the maximum distance between the mapped position and TargetPosition, relative to the
 * longest edge of the target's bounding box. pointsName, targetName: used in messages for the
 * points and the target, for example "the Input".
 *
 * Throws InvalidInput if a number is not finite, a barycentric coordinate is negative, or the three
 * do not sum to 1 up to single precision. Throws MapOfAnotherSurface if a cell is no triangle of
 * the target, or if the positions are farther apart than the tolerance.
 */
SurfacePoints RequirePreciseMap(const PreciseArrays& arrays, const NumberedSurface& target,
  double tolerance, const std::string& pointsName, const std::string& targetName);

/// Returns the weights that take values from the giver's points to points mapped onto its
/// triangles. No point is outside.
TransferWeights LocateOnTriangles(const SurfacePoints& map, const NumberedSurface& giver);

} // namespace shape
