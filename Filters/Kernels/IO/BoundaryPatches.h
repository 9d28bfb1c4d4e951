#pragma once

#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Faces of solid cells (Mesh/CellFaces.h).
struct SolidFaces
{
  /// f x 4 points, counter-clockwise seen from outside the cell; the last is -1 in triangles.
  Eigen::MatrixXi Corners;
  Eigen::VectorXi Cell; ///< f: the cell of each face
  Eigen::VectorXi Face; ///< f: the index of the face in its cell
};

/// Returns the faces that belong to exactly one solid cell, in the order of the cells. Where a
/// quadrilateral meets two triangles, all three belong to the boundary.
SolidFaces FindBoundaryFaces(const Cells& cells);

/// The faces between two regions, oriented out of the lower region, in the order of its cells.
struct RegionInterface
{
  int Lower, Upper; ///< regions
  SolidFaces Faces;
};

/// Finds the faces shared by solid cells of different regions (m), in the order of the regions.
std::vector<RegionInterface> FindRegionInterfaces(
  const Cells& cells, const Eigen::VectorXi& regions);

/**
 * Returns the patch of each face (f), numbered 0, 1, ... by first face. Two faces belong to one
 * patch if only they share an edge and the angle between their normals is at most `featureAngle`.
 * The patches of a cube are its six faces.
 *
 * points: n x 3. faces: f x 4, consistently oriented; the last is -1 in triangles. The normal of a
 * quadrilateral is the cross product of its diagonals. A face without area joins all its
 * neighbours. featureAngle: degrees, 0 to 180. Throws InvalidInput if the angle is out of range.
 */
Eigen::VectorXi FindBoundaryPatches(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& faces, double featureAngle);

} // namespace shape
