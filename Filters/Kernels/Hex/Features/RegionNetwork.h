#pragma once

#include "Mesh/HexMesh.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <vector>

namespace shape
{

/// The faces between the regions of hexahedra, and those of their boundary.
struct RegionFaces
{
  Eigen::MatrixXi Quads;  ///< q x 4, first those of the boundary
  Eigen::MatrixXi Labels; ///< q x 2: the labels on both sides; the normal leaves the first
  Eigen::Index Outer = 0; ///< the number of faces of the boundary
};

/// Finds these faces, in the order of their pairs of labels. The first label is the greater one,
/// but never the outside (ConformingRegions). regionOf: the label of each hexahedron.
RegionFaces FindRegionFaces(const HexMesh& mesh, const Eigen::VectorXi& regionOf);

/// The curves where three or more regions, of which the outside is one, meet, and their ends.
struct RegionNetwork
{
  struct Curve
  {
    std::vector<int> Points; ///< in order; a closed curve does not repeat its first point
    bool Closed = false;
    std::vector<int> Labels; ///< the labels around the curve, ascending
  };
  std::vector<Curve> Curves;
  std::vector<int> Corners;                   ///< points where curves meet or end, ascending
  std::vector<std::vector<int>> CornerLabels; ///< for each corner: the labels around it, ascending
};

/// Finds the network of polygons between regions: edges of more than two polygons. polygons: f x k
/// point indices. labels: f x 2.
RegionNetwork FindRegionNetwork(const Eigen::MatrixXi& polygons, const Eigen::MatrixXi& labels);

} // namespace shape
