#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Returns the points used by elements (m x k indices less than `points`), ascending.
std::vector<int> FindUsedPoints(const Eigen::MatrixXi& elements, Eigen::Index points);

/// Returns, for each of `points` points, its position in `kept`, or -1 if it is not in `kept`.
/// kept: indices less than `points`, without repeats.
std::vector<int> InvertIndices(const std::vector<int>& kept, Eigen::Index points);

/// Returns the elements with each index replaced by its position in `kept`. kept: must contain all
/// points that the elements use. points: the number of points; all indices are less.
Eigen::MatrixXi RenumberPoints(
  const Eigen::MatrixXi& elements, const std::vector<int>& kept, Eigen::Index points);

/// Returns the given triangles of a mesh with the points that they use. Points and triangles keep
/// their order.
Mesh ExtractTriangles(const Mesh& mesh, const std::vector<int>& triangles);

/// Joins meshes. The points and triangles of the first mesh come first.
Mesh JoinMeshes(const std::vector<Mesh>& meshes);

} // namespace shape
