#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// Returns the points used by elements (m x k indices less than `points`), ascending.
std::vector<int> FindUsedPoints(const Eigen::MatrixXi& elements, Eigen::Index points);

/// Returns, for each of n = `points` points, its position in `kept`, or -1 if it is not in it.
/// kept: indices less than n, without repeats.
std::vector<int> InvertIndices(const std::vector<int>& kept, Eigen::Index points);

/// Returns the elements with each index (less than `points`) replaced by its position in `kept`,
/// which must contain all points that they use.
Eigen::MatrixXi RenumberPoints(
  const Eigen::MatrixXi& elements, const std::vector<int>& kept, Eigen::Index points);

/// Returns some triangles of a mesh with the points that they use; both keep their order.
Mesh ExtractTriangles(const Mesh& mesh, const std::vector<int>& triangles);

/// Joins meshes: all points and all triangles, those of the first mesh first.
Mesh JoinMeshes(const std::vector<Mesh>& meshes);

} // namespace shape
