#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// The triangles that result when some edges are split in two.
struct CutTriangles
{
  Eigen::MatrixXi Triangles;                 ///< oriented like the original triangles
  std::vector<int> Original;                 ///< for each new triangle, the original one; ascending
  std::vector<std::array<int, 2>> Midpoints; ///< for each new point, the ends of its edge
};

/// Splits the given edges in all triangles that contain them. edges: without repeats, each with the
/// lower point first. points: the number of points; the new points follow, in the order of the
/// edges.
CutTriangles SplitEdges(
  const Eigen::MatrixXi& triangles, const std::vector<std::array<int, 2>>& edges, int points);

/// Returns the triangle edges that join two non-consecutive points of a loop. Each edge has its
/// lower point first, and the edges are sorted. loop: points without repeats.
std::vector<std::array<int, 2>> FindLoopChords(
  const Eigen::MatrixXi& triangles, const std::vector<int>& loop);

} // namespace shape
