#pragma once

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// Triangles of which some edges are cut in two.
struct CutTriangles
{
  Eigen::MatrixXi Triangles;                 ///< facing as those that they are parts of
  std::vector<int> Original;                 ///< of each: the one that it is a part of; rising
  std::vector<std::array<int, 2>> Midpoints; ///< of each new point: the two that it is between
};

/// Cuts edges (their lower point first, none twice) of all triangles that have them. points: how
/// many there are; the new ones are numbered after them, in the order of the edges.
CutTriangles SplitEdges(
  const Eigen::MatrixXi& triangles, const std::vector<std::array<int, 2>>& edges, int points);

/// The edges of triangles that join two points of a loop which are no neighbours there, in order,
/// the lower point first. loop: points, none twice.
std::vector<std::array<int, 2>> FindLoopChords(
  const Eigen::MatrixXi& triangles, const std::vector<int>& loop);

} // namespace shape
