#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A triangle around a node; Corner is the index of the node in the triangle. With Triangle -1, the
/// entry stands only for a neighbour that is Next in no triangle around the node.
struct FanTriangle
{
  int Next, Previous; ///< nodes
  int Triangle, Corner;
};

/// The triangles around each node: those of node i are Triangles[First[i]] ... Triangles[First[i +
/// 1] - 1]. If triangles are consistently oriented, each neighbour of a node is Next in exactly one
/// of them.
struct VertexFans
{
  /// triangles: m x 3 indices of nodes. A triangle with a repeated node occurs once in its fan.
  VertexFans(const Eigen::MatrixXi& triangles, int nodes);

  std::vector<int> First;
  std::vector<FanTriangle> Triangles;
  int Largest = 0; ///< the largest number of triangles in a fan
};

} // namespace shape
