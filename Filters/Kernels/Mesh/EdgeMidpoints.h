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
  std::vector<int> Original;                 ///< original triangle of each, ascending
  std::vector<std::array<int, 2>> Midpoints; ///< ends of the edge that each new point splits
};

/// Splits edges (the lower point first, without repeats) in all triangles that have them. points:
/// the number of points; the new points are numbered after them, in the order of the edges.
CutTriangles SplitEdges(
  const Eigen::MatrixXi& triangles, const std::vector<std::array<int, 2>>& edges, int points);

/// Returns the edges of triangles that join two points of a loop that are not consecutive in it, in
/// order, the lower point first. loop: points without repeats.
std::vector<std::array<int, 2>> FindLoopChords(
  const Eigen::MatrixXi& triangles, const std::vector<int>& loop);

} // namespace shape
