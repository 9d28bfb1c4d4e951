#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

/// For each row of `queries` (q x d) the row of `rows` (n x d, at least one) nearest to it, by
/// products of matrices in single precision: in a hundred dimensions quicker than any tree, and
/// exact but for that rounding; the first of those equally near. Throws Aborted.
Eigen::VectorXi FindNearestRows(
  const Eigen::MatrixXd& queries, const Eigen::MatrixXd& rows, const Progress& progress = {});

} // namespace shape
