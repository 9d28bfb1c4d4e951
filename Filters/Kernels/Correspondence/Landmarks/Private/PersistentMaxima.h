#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Finds the persistent maxima of a function (n values) on a surface. The persistence of a maximum
 * is its height above the highest saddle that connects it to a higher maximum (Edelsbrunner,
 * Letscher and Zomorodian, "Topological persistence and simplification", 2002). The persistence of
 * the highest maximum is the range of the function. Returns at most `count` maxima, the most
 * persistent first, with a persistence of at least `minimum`. If the values at two points are
 * equal, the point with the lower index counts as higher.
 */
std::vector<int> FindPersistentMaxima(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& function, double minimum, int count);

} // namespace shape
