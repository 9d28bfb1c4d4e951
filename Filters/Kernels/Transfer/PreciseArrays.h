#pragma once

#include "Base/Errors.h"
#include "Mesh/Mesh.h"
#include "Mesh/SurfacePoints.h"
#include "Transfer/TransferFields.h"

#include <string>

namespace shape
{

/// A precise map as points carry it: what their arrays of these names hold (n rows).
struct PreciseArrays
{
  Eigen::VectorXd TargetCell;
  Eigen::MatrixXd TargetBarycentric; ///< n x 3
  Eigen::MatrixXd TargetPosition;    ///< n x 3
};

/// The arrays are sound, but were made for another target.
class MapOfAnotherSurface : public InvalidInput
{
public:
  using InvalidInput::InvalidInput;
};

/// A surface as TargetCell numbers it.
struct NumberedSurface
{
  Mesh Surface;
  int First = 0;         ///< the number of its first triangle: vertices and lines come before
  Eigen::VectorXi Cells; ///< m: the polygon that each triangle is cut from
};

/**
 * The map that the arrays hold, into the triangles of `target`. Between sheets that lie close
 * together it tells which one is meant, which the position closest to TargetPosition does not.
 *
 * tolerance: how far that position and TargetPosition may be apart, as a share of the longest side
 * of the target's box. names: what messages call the points and the target, "the Input". Throws
 * InvalidInput if a number is not finite, a barycentric coordinate is negative or three do not
 * sum to 1 (by more than single precision loses); MapOfAnotherSurface if a cell is no triangle
 * of the target, or the positions are farther apart.
 */
SurfacePoints RequirePreciseMap(const PreciseArrays& arrays, const NumberedSurface& target,
  double tolerance, const std::string& pointsName, const std::string& targetName);

/// Where points that go to positions on the giver's triangles take their values; none is outside.
TransferWeights LocateOnTriangles(const SurfacePoints& map, const NumberedSurface& giver);

} // namespace shape
