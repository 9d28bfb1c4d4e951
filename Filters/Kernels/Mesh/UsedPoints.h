#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The points that elements (m x k, indices less than `points`) use, ascending.
std::vector<int> FindUsedPoints(const Eigen::MatrixXi& elements, Eigen::Index points);

/// Of each of n = `points` points, its position in `kept` (indices less than n, each once); -1 if
/// it is not there.
std::vector<int> InvertIndices(const std::vector<int>& kept, Eigen::Index points);

/// The elements with each index (less than `points`) replaced by its position in `kept`, which has
/// all that they use.
Eigen::MatrixXi RenumberPoints(
  const Eigen::MatrixXi& elements, const std::vector<int>& kept, Eigen::Index points);

/// Some triangles of a mesh over the points that they use, both in the order given.
Mesh ExtractTriangles(const Mesh& mesh, const std::vector<int>& triangles);

/// All triangles over all points, those of the first mesh first.
Mesh JoinMeshes(const std::vector<Mesh>& meshes);

} // namespace shape
