#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

/// Reports the progress of a loop at item `i` of `count`, once in a while.
inline void ReportEvery(Eigen::Index i, Eigen::Index count, const Progress& progress)
{
  if (i % 65536 == 0)
  {
    progress(static_cast<double>(i) / count);
  }
}

/**
 * Finds the sets of tetrahedra that no surface separates. Returns, for each tetrahedron, the index
 * of its set, from 0. Throws SolveFailure if a triangle of the surfaces is no face of a
 * tetrahedron, or the tetrahedra end elsewhere.
 *
 * tetrahedra: m x 4 point indices. onSurfaces: k x 3 point indices of the surfaces' triangles.
 */
Eigen::VectorXi FindSetsBetweenSurfaces(const Eigen::MatrixXi& tetrahedra,
  const Eigen::MatrixXi& onSurfaces, const Progress& progress = {});

} // namespace shape
