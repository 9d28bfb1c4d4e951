#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/**
 * The points where a function (n) on a surface has maxima that stand out: a maximum is as
 * persistent as it is high above the highest pass to a higher one (Edelsbrunner, Letscher and
 * Zomorodian, "Topological persistence and simplification", 2002); the highest one is as high as
 * the whole function. Those of at least `least` are returned, the most persistent first, at most
 * `count`. Of equal values the first point's is higher.
 */
std::vector<int> FindPersistentMaxima(
  const Eigen::MatrixXi& triangles, const Eigen::VectorXd& function, double minimum, int count);

} // namespace shape
