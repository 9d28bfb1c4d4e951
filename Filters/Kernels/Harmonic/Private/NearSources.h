#pragma once

#include "Distance/SignedDistance.h"

namespace shape
{

/// Charges close to a surface, each outside of the place (site) on it that it belongs to.
struct NearSources
{
  Eigen::MatrixXd Points;  ///< k x 3
  Eigen::VectorXi Sites;   ///< k, ascending: the row of its site
  Eigen::VectorXd Offsets; ///< k, > 0: the distance from its site
};

/**
 * A charge for each site on the normal, at the offset wanted there or as much nearer as it takes to
 * have at least 0.6 of its offset between it and any part of the surface: in narrow gaps. A site
 * with room for less than 0.24 of the offset, without a normal or with offset 0 gets none: charges
 * so close to the surface are spikes between its points.
 *
 * boundary: closed, facing out of the solid. sites: n x 3, on or near it. normals: n x 3, unit, or
 * zero. offsets: n, >= 0. Throws Aborted.
 */
NearSources InsertNearSources(const SignedDistance& boundary, const Eigen::MatrixXd& sites,
  const Eigen::MatrixXd& normals, const Eigen::VectorXd& offsets, const Progress& progress = {});

} // namespace shape
