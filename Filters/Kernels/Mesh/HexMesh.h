#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A solid of hexahedra. Points: n x 3. Hexahedra: m x 8 indices in VTK's order. The four corners
/// of the bottom come first, counter-clockwise seen from the top; then the corners above them.
struct HexMesh
{
  Eigen::MatrixXd Points;
  Eigen::MatrixXi Hexahedra;
};

/// For each corner of a hexahedron, the other ends of its three edges, in right-handed order.
inline constexpr int HexNeighbours[8][3] = { { 1, 3, 4 }, { 2, 0, 5 }, { 3, 1, 6 }, { 0, 2, 7 },
  { 7, 5, 0 }, { 4, 6, 1 }, { 5, 7, 2 }, { 6, 4, 3 } };

/// The corners of the six faces of a hexahedron, counter-clockwise seen from outside.
inline constexpr int HexFaces[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 },
  { 3, 7, 6, 2 }, { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };

/// Returns the boundary quads (q x 4), in the order of their hexahedra: the faces that belong to
/// only one hexahedron. Their corners are counter-clockwise seen from outside.
Eigen::MatrixXi FindBoundaryQuads(const HexMesh& mesh);

/// Splits each quad (q x 4) into two triangles (2q x 3).
Eigen::MatrixXi SplitQuads(const Eigen::MatrixXi& quads);

/// Returns the mean of the corners of each quad (q x 3).
Eigen::MatrixXd ComputeQuadCentres(const Eigen::MatrixXd& points, const Eigen::MatrixXi& quads);

/// Returns the mean length of the edges of a hexahedron.
double ComputeMeanEdgeLength(const HexMesh& mesh, Eigen::Index hex);

/// Marks all points of each hexahedron that has a marked point. This is done `rings` times. marked:
/// one flag for each point, non-zero if it is marked.
void GrowRings(const Eigen::MatrixXi& hexahedra, int rings, std::vector<char>& marked);

} // namespace shape
