#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The persistent maxima of a function (n) on a surface: the persistence of a maximum is its height
 * above the highest saddle to a higher one (Edelsbrunner, Letscher and
 * Zomorodian, "Topological persistence and simplification", 2002); the highest one is as high as
 * the whole function. Those of at least `minimum` are returned, the most persistent first, at most
 * `count`. Of equal values the first point's is higher.
 */
std::vector<int> FindPersistentMaxima(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& function, double minimum, int count);

} // namespace shape
