#pragma once

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// A triangle around a node, which is its corner Corner; or, with Triangle -1, only a neighbour,
/// Next, that is this in no other triangle around the node.
struct FanTriangle
{
  int Next, Previous; ///< nodes
  int Triangle, Corner;
};

/// The triangles around each node: those of node i are Triangles[First[i]] ... Triangles[First[i +
/// 1] - 1]. Each neighbour of a node is Next in one of them, where triangles agree on their sense.
struct VertexFans
{
  /// triangles: m x 3, of nodes; one of which two corners are one node is once in its fan.
  VertexFans(const Eigen::MatrixXi& triangles, int nodes);

  std::vector<int> First;
  std::vector<FanTriangle> Triangles;
  int Largest = 0; ///< how many there are at most
};

} // namespace shape
