#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace shape
{

/// Triangles whose coincident points are joined.
struct JoinedSoup
{
  /// All points. A triangle uses the first of coincident points, and has three different points.
  Mesh Surface;
  std::vector<int> Triangles; ///< the index of each triangle in the soup

  std::vector<int> NotFinite; ///< points with a coordinate that is not finite
  std::vector<int> Loose;     ///< finite points that no triangle uses
  std::vector<int> Joined;    ///< points that are replaced by another point
  std::vector<int> Collapsed; ///< triangles with fewer than three different points
};

/// Joins the points of a soup. Triangles with a point that is not finite are omitted, and so are
/// triangles with fewer than three different points. tolerance: points closer than this are
/// coincident, in the soup's units; 0 means the fraction WeldTolerance of the diagonal. Throws
/// InvalidInput if an index is out of range, or if the extent is too small or too large
/// (RequireExtent); Aborted.
JoinedSoup JoinSoup(const Mesh& soup, double tolerance, const Progress& progress);

/// Returns, for each triangle (m x 3), the first triangle with the same three points, usually
/// itself.
std::vector<int> FindSameTriangles(const Eigen::MatrixXi& triangles);

} // namespace shape
