#pragma once

#include "Base/Progress.h"
#include "Geodesics/TriangleStrip.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <memory>
#include <vector>

namespace shape
{

/**
 * Finds locally shortest paths on a surface: geodesics in the sense of Mitchell, Mount and
 * Papadimitriou ("The discrete geodesic problem", 1987). Such a path turns only on the boundary and
 * at points with an angle of at least pi on both sides of it.
 *
 * A TriangleStrip towards the target is unfolded into the plane, where the shortest path within it
 * is computed. Where this path turns at a point with an angle of less than pi on the outer side, it
 * can be shortened. Then the strip is led around the other side of the point (Xin and Wang,
 * "Efficiently determining a locally exact shortest path on polyhedral surfaces", 2007). This is
 * repeated until there is no such point. Another path, around the other side of a hill, may be even
 * shorter. Of 1385 random pairs of positions on seven models one path is 5 % longer than the
 * shortest, 58 are 0.1 % longer; the mean is 0.04 %.
 *
 * An object serves many searches, from one thread at a time. An edge is treated as boundary unless
 * it has two triangles that run through it in opposite directions.
 */
class SurfacePaths
{
public:
  /// surface: manifold or not. Throws InvalidInput as RequireIndices.
  explicit SurfacePaths(const Surface& surface);
  ~SurfacePaths();
  SurfacePaths(const SurfacePaths&) = delete;
  SurfacePaths& operator=(const SurfacePaths&) = delete;

  /// Returns the path between two points of the surface. The time grows with the part of the
  /// surface that the path could cross. Throws InvalidInput if there is no path; Aborted.
  SurfacePath Find(const SurfacePoint& from, const SurfacePoint& to, const Progress& progress = {});

  /// The opposite half-edge of each half-edge 3 t + k, or -1 on the boundary.
  const std::vector<int>& Twins() const { return this->OppositeHalfEdges; }

private:
  std::vector<int> TrianglesAt(const SurfacePoint& position) const;

  Surface Searched;
  std::vector<int> OppositeHalfEdges;
  class StripSearch;
  std::unique_ptr<StripSearch> Search;
};

} // namespace shape
