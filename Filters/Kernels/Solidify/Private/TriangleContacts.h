#pragma once

#include "Base/Progress.h"
#include "Geometry/SelfIntersections.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <array>
#include <map>
#include <vector>

namespace shape
{

/// The positions at which triangles of a surface meet others, and the segments in which they do.
/// Exact orientations decide which edge meets which triangle or edge; only positions are rounded.
struct TriangleContacts
{
  /// The points of the surface, then those at which an edge meets an edge or the inside of a
  /// triangle.
  std::vector<Eigen::RowVector3d> Points;
  /// For each edge (its points, ascending) with contacts: their points, without the edge's ends.
  std::map<std::array<int, 2>, std::vector<int>> OnEdge;
  /// For each triangle with contacts inside it: their points. One point may occur several times.
  std::map<int, std::vector<int>> Inside;
  /// For each triangle, the segments (two points) along which it meets others.
  std::map<int, std::vector<std::array<int, 2>>> Segments;
};

/// Finds the contacts of the pairs of triangles (FindSelfIntersections). surface: without
/// degenerate triangles. Throws Aborted.
TriangleContacts FindTriangleContacts(
  const Mesh& surface, const std::vector<Crossing>& pairs, const Progress& progress);

} // namespace shape
