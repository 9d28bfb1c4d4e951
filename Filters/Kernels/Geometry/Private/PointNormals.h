#pragma once

#include "Base/Progress.h"

#include <Eigen/Core>

namespace shape
{

struct PointNormalsOptions
{
  int Nearest = 16; ///< number of nearest points to which a plane and a paraboloid are fitted
};

/**
 * Estimates the unit normals of a surface at points that sample it (n x 3).
 *
 * A plane is fitted to the nearest points, and over it a paraboloid (Cazals and Pouget, "Estimating
 * differential quantities using polynomial fitting of osculating jets", 2005). Neighbours get
 * normals on the same side, along the minimum spanning tree of the neighbours with the weights 1 -
 * |n_i . n_j| (Hoppe et al., "Surface reconstruction from unorganized points", 1992). The normal at
 * the highest point of each connected part has z > 0, so the normals of a closed surface point
 * outwards. Points that lie nearly on a line have an arbitrary normal perpendicular to it.
 *
 * points: distinct and finite. Throws InvalidInput if Nearest is less than 6; Aborted.
 */
Eigen::MatrixXd EstimatePointNormals(const Eigen::MatrixXd& points,
  const PointNormalsOptions& options = {}, const Progress& progress = {});

} // namespace shape
