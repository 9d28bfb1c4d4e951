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
  Eigen::VectorXi Cell; ///< f: whose face it is
  Eigen::VectorXi Face; ///< f: which of its faces
};

/// The faces that one solid cell has alone, in the order of the cells. Where a quadrilateral meets
/// two triangles, all three are of the boundary.
SolidFaces FindBoundaryFaces(const Cells& cells);

/// The faces between two regions, seen from the lower one, in the order of its cells.
struct RegionInterface
{
  int Lower, Upper; ///< regions
  SolidFaces Faces;
};

/// Where solid cells of different regions (m) share faces, in the order of the regions.
std::vector<RegionInterface> FindRegionInterfaces(
  const Cells& cells, const Eigen::VectorXi& regions);

/**
 * The patch of each face (f: 0, 1, ... in the order of their first faces): faces hang together
 * across an edge that two of them share where the angle between their normals is at most
 * `featureAngle`. Of a cube, patches are its six sides.
 *
 * points: n x 3. faces: f x 4, consistently oriented; the last is -1 in triangles. A
 * quadrilateral's normal is that of its diagonals; a face without area goes with every neighbour.
 * featureAngle: in degrees, 0 to 180; else throws InvalidInput.
 */
Eigen::VectorXi FindBoundaryPatches(
  const Eigen::MatrixXd& points, const Eigen::MatrixXi& faces, double featureAngle);

} // namespace shape
