#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <map>
#include <vector>

namespace shape
{

/**
 * The regions between the triangles of a conforming surface: each triangle separates two regions,
 * and regions that touch share triangles. The triangles are sorted by region once, so that the
 * surfaces of all regions together cost as much as twice the whole.
 */
class RegionSurfaces
{
public:
  static constexpr int Outside = 0; ///< the label of what is no region

  /// surfaces, labels: kept by reference. labels: m x 2, the labels on both sides of each triangle;
  /// the normal leaves the first. Throws InvalidInput if there is not one row for each triangle, or
  /// if both labels of a triangle are the same.
  RegionSurfaces(const Mesh& surfaces, const Eigen::MatrixXi& labels);

  /// The triangles of each region but Outside, ascending, by label.
  const std::map<int, std::vector<int>>& Triangles() const { return this->TrianglesOf; }

  /// Returns the surface of a region, facing outwards, with the points that it uses. Points and
  /// triangles keep their order. label: one of Triangles().
  Mesh Extract(int label) const;

private:
  const Mesh& Surfaces;
  const Eigen::MatrixXi& Labels;
  std::map<int, std::vector<int>> TrianglesOf;
};

} // namespace shape
