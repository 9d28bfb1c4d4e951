#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * Finds the persistent maxima of a function (n) on a surface. The persistence of a maximum is its
 * height above the highest saddle that connects it to a higher maximum (Edelsbrunner, Letscher and
 * Zomorodian, "Topological persistence and simplification", 2002). That of the highest one is the
 * range of the function. Returns the maxima with a persistence of at least `minimum`, the most
 * persistent first, at most `count`. Of equal values, that of the point with the lowest index is
 * the higher one.
 */
std::vector<int> FindPersistentMaxima(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& function, double minimum, int count);

} // namespace shape
