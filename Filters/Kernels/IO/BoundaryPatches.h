#pragma once

#include "Mesh/Cells.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Faces of solid cells (Mesh/CellFaces.h).
struct SolidFaces
{
  /// f x 4 point indices, counter-clockwise seen from outside the cell; the last is -1 in
  /// triangles.
  Eigen::MatrixXi Corners;
  Eigen::VectorXi Cell; ///< f: the cell of each face
  Eigen::VectorXi Face; ///< f: the index of the face in its cell
};

/// Returns the faces that belong to exactly one solid cell, in the order of the cells. If a
/// quadrilateral of one cell lies on two triangles of other cells, all three faces belong to the
/// boundary.
SolidFaces FindBoundaryFaces(const Cells& cells);

/// The faces between two regions. They face out of the region with the lower number, and are in the
/// order of that region's cells.
struct RegionInterface
{
  int Lower, Upper; ///< regions
  SolidFaces Faces;
};

/// Finds the faces between solid cells of different regions. Returns one interface for each pair of
/// regions, in ascending order. regions: m, the region of each cell.
std::vector<RegionInterface> FindRegionInterfaces(
  const Cells& cells, const Eigen::VectorXi& regions);

/**
 * Returns the patch of each face (f values). Patches are numbered 0, 1, ... in the order of their
 * first faces. Two faces belong to the same patch if they share an edge that belongs to no other
 * face, and the angle between their normals is at most `featureAngle`. The patches of a cube are
 * its six faces.
 *
 * points: n x 3. faces: f x 4 point indices, consistently oriented; the last is -1 in triangles.
 * The normal of a quadrilateral is the cross product of its diagonals. A face without area belongs
 * to the same patch as all its neighbours. featureAngle: degrees, 0 to 180. Throws InvalidInput if
 * the angle is out of range.
 */
Eigen::VectorXi FindBoundaryPatches(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& faces, double featureAngle);

} // namespace shape
