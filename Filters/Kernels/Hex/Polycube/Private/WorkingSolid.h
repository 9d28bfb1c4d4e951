#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace shape
{

/// Tetrahedra in a solid, and its surface over the same points.
struct WorkingSolid
{
  Eigen::MatrixXd Points;     ///< n x 3; those of the surface come first
  Eigen::MatrixXi Tetrahedra; ///< m x 4, positive
  Eigen::MatrixXi Triangles;  ///< k x 3: the surface, facing outwards
  int SurfacePointCount = 0;

  Mesh Surface() const;
  Mesh Surface(const Eigen::MatrixXd& points) const; ///< with the points elsewhere
};

/**
 * A coarse tetrahedralisation of the solid inside a closed surface: of a surface of about this many
 * triangles of even size near it, which keeps its creases. Every tetrahedron has an inner point,
 * and so has every inner edge, so that the boundary may be flattened.
 *
 * Where the coarse surface would cross itself, it becomes finer. Throws as Tetrahedralize.
 */
WorkingSolid BuildWorkingSolid(
  const Surface& surface, int triangles, const Progress& progress = {});

/// Puts a point into each of these edges of the surface (each once), in `positions`, too; the parts
/// of a triangle have its label.
void SplitSurfaceEdges(WorkingSolid& solid, const std::vector<std::pair<int, int>>& edges,
  Eigen::MatrixXd& positions, Eigen::VectorXi& labels);

} // namespace shape
