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
  Eigen::MatrixXd Points;     ///< n x 3: first the points of the surface, then the others
  Eigen::MatrixXi Tetrahedra; ///< m x 4, positive
  Eigen::MatrixXi Triangles;  ///< k x 3: the surface, facing outwards
  int SurfacePointCount = 0;

  Mesh Surface() const;
  Mesh Surface(const Eigen::MatrixXd& points) const; ///< with the points at other positions
};

/**
 * Builds a coarse tetrahedralisation of the solid inside a closed surface. The surface of the
 * result is close to the given one and keeps its creases. This surface has about `triangles`
 * triangles of nearly uniform size. Every tetrahedron and every inner edge has at least one point
 * off the boundary, so the boundary can be flattened.
 *
 * If the coarse surface crosses itself, a finer one is used. Throws whatever Tetrahedralize throws.
 */
WorkingSolid BuildWorkingSolid(
  const Surface& surface, int triangles, const Progress& progress = {});

/// Splits edges of the surface at their midpoints. edges: pairs of points, each edge once.
/// positions (n x 3): a second set of positions; midpoints are added to it, too. labels: the label
/// of each triangle; the parts of a split triangle inherit its label.
void SplitSurfaceEdges(WorkingSolid& solid, const std::vector<std::pair<int, int>>& edges,
  Eigen::MatrixXd& positions, Eigen::VectorXi& labels);

} // namespace shape
