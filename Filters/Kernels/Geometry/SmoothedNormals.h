#pragma once

#include "Base/Progress.h"
#include "Geometry/PointGraph.h"

#include <Eigen/Core>

namespace shape
{

/**
 * Unit normals of a surface at the nodes of its graph (n x 3): those of PointNormals, each replaced
 * by the mean of those at its neighbours, weighted by their inverse distances, and its own, which
 * counts as much as the nearest one's; in as many rounds as told.
 *
 * A node without an area around it has the mean of its neighbours' normals, or (0, 0, 1) where no
 * node linked to it has one. triangles: m x 3, of nodes. Throws Aborted.
 */
Eigen::MatrixXd SmoothNormals(const PointGraph& graph, const Eigen::MatrixXi& triangles, int rounds,
  const Progress& progress = {});

} // namespace shape
