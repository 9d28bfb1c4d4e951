#pragma once

#include "Base/Progress.h"
#include "Geometry/PointGraph.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

namespace shape
{

/// Unit normals of the points of a surface by the weights of Max, "Weights for computing vertex
/// normals from facet normals", 1999: exact inside where the points lie on a sphere, whatever the
/// triangles. Zero if no triangle there has an area.
Eigen::MatrixXd ComputeMaxNormals(const Mesh& surface);

/// Unit normals of the points of a surface (n x 3): the sums of the area vectors of the triangles
/// around each. Zero if that is zero. ComputePointNormals weights by angles.
Eigen::MatrixXd ComputeAreaWeightedNormals(const Surface& surface);

/**
 * Unit normals of a surface at the nodes of its graph (n x 3): those of ComputePointNormals, each
 * replaced by the mean of those at its neighbours, weighted by their inverse distances, and its
 * own, which counts as much as the nearest one's. This is repeated `rounds` times.
 *
 * A node without an area around it has the mean of its neighbours' normals, or (0, 0, 1) where no
 * node linked to it has one. triangles: m x 3, of nodes. Throws Aborted.
 */
Eigen::MatrixXd SmoothNormals(const PointGraph& graph, const Eigen::MatrixXi& triangles, int rounds,
  const Progress& progress = {});

/// A position in a triangle curved to normals at its corners (one a row): the cubic patch of
/// Vlachos and others, "Curved PN triangles", 2001.
Eigen::RowVector3d EvaluateCurvedTriangle(const Eigen::Matrix3d& corners,
  const Eigen::Matrix3d& normals, const Eigen::RowVector3d& barycentric);

} // namespace shape
