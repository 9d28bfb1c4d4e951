#pragma once

#include "Base/Progress.h"
#include "Geodesics/TriangleStrip.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <memory>
#include <optional>
#include <vector>

namespace shape
{

/**
 * Finds locally shortest paths on a surface: geodesics in the sense of Mitchell, Mount and
 * Papadimitriou ("The discrete geodesic problem", 1987). Such a path turns only on the boundary,
 * and at points where the surface's angle on each side of the path is at least pi.
 *
 * A strip of triangles towards the target is unfolded into the plane, where the shortest path
 * within the strip is computed (TriangleStrip). If this path turns at a point and the angle on the
 * outer side is less than pi, the path can be shortened. Then the strip is led around the other
 * side of the point (Xin and Wang, "Efficiently determining a locally exact shortest path on
 * polyhedral surfaces", 2007). This is repeated until there is no such point. A different path, for
 * example around the other side of a hill, may still be shorter. Of the paths between 1385 random
 * pairs of positions on seven models, one is 5 % longer than the shortest path, and 58 are 0.1 %
 * longer. The mean excess is 0.04 %.
 *
 * An object serves many searches, from one thread at a time. An edge counts as boundary unless it
 * has exactly two triangles, which traverse it in opposite directions.
 */
class SurfacePaths
{
public:
  /// surface: manifold or not. Throws InvalidInput when RequireIndices does.
  explicit SurfacePaths(const Surface& surface);
  ~SurfacePaths();
  SurfacePaths(const SurfacePaths&) = delete;
  SurfacePaths& operator=(const SurfacePaths&) = delete;

  /// Returns the path between two points of the surface. The time grows with the part of the
  /// surface that the path could cross. Throws InvalidInput if there is no path; Aborted.
  SurfacePath Find(const SurfacePoint& from, const SurfacePoint& to, const Progress& progress = {});

  /// The same, but returns nothing if there is no path.
  std::optional<SurfacePath> FindIfConnected(
    const SurfacePoint& from, const SurfacePoint& to, const Progress& progress = {});

  /// Returns the triangles that contain a point and are connected by edges around it.
  std::vector<int> TrianglesAt(const SurfacePoint& position) const;

  /// Returns the opposite half-edge of each half-edge 3 t + k, or -1 on the boundary.
  const std::vector<int>& Twins() const { return this->OppositeHalfEdges; }

private:
  Surface Searched;
  std::vector<int> OppositeHalfEdges;
  class StripSearch;
  std::unique_ptr<StripSearch> Search;
};

} // namespace shape
