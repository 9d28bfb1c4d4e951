#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// The tetrahedra of a solid, and its surface over the same points.
struct WorkingSolid
{
  Eigen::MatrixXd Points;     ///< n x 3; those of the surface come first
  Eigen::MatrixXi Tetrahedra; ///< m x 4, positive
  Eigen::MatrixXi Triangles;  ///< k x 3: the surface, facing outwards
  int SurfacePointCount = 0;

  Mesh Surface() const;
  Mesh Surface(const Eigen::MatrixXd& points) const; ///< the surface with other positions
};

/**
 * Builds a coarse tetrahedralisation of the solid inside a closed surface. Its surface has about
 * the given number of triangles, of even size, close to the original, and keeps its creases. Every
 * tetrahedron has an inner point, and every inner edge has one, so the boundary can be flattened.
 *
 * If the coarse surface would cross itself, it is made finer. Throws what Tetrahedralize throws.
 */
WorkingSolid BuildWorkingSolid(
  const Surface& surface, int triangles, const Progress& progress = {});

/// Inserts a point into each of the given surface edges (no repeats), in `positions` as well; the
/// parts of a triangle inherit its label.
void SplitSurfaceEdges(WorkingSolid& solid, const std::vector<std::pair<int, int>>& edges,
  Eigen::MatrixXd& positions, Eigen::VectorXi& labels);

} // namespace shape
