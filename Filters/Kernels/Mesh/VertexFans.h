#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A triangle around a node; Corner is the index of the node in the triangle. If Triangle is -1,
/// the entry only records a neighbour of the node that is Next in none of the triangles.
struct FanTriangle
{
  int Next, Previous; ///< nodes
  int Triangle, Corner;
};

/// The triangles around each node; node i has Triangles[First[i]] ... Triangles[First[i + 1] - 1].
/// If the triangles are consistently oriented, each neighbour of a node is Next in exactly one
/// entry.
struct VertexFans
{
  /// triangles: m x 3 indices of nodes. A triangle with a repeated node occurs once in its fan.
  VertexFans(const Eigen::MatrixXi& triangles, int nodes);

  std::vector<int> First;
  std::vector<FanTriangle> Triangles;
  int Largest = 0; ///< the largest number of triangles in a fan
};

} // namespace shape
