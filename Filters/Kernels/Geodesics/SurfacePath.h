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
 * Finds paths on a surface that are locally shortest: geodesics in the sense of Mitchell, Mount and
 * Papadimitriou ("The discrete geodesic problem", 1987). Such a path turns only at points that have
 * an angle of pi or more on either side of it, and on the boundary.
 *
 * A TriangleStrip that leads towards the target is laid out in the plane, where the shortest path
 * within it is found. Where that turns at a point with an angle of less than pi beyond it, the
 * strip is led past the point on its other side (Xin and Wang, "Efficiently determining a locally
 * exact shortest path on polyhedral surfaces", 2007), until there is no such point. Another path,
 * around the other side of a hill, may be shorter still: of 1385 random pairs of positions on seven
 * models one path is 5 % longer than the shortest, 58 are 0.1 % longer, and the mean is 0.04 %.
 *
 * Built once, asked from one thread at a time. Edges count as boundary unless they have two
 * triangles that run through them in opposite directions.
 */
class SurfacePaths
{
public:
  /// surface: manifold or not. Throws InvalidInput as RequireIndices.
  explicit SurfacePaths(const Surface& surface);
  ~SurfacePaths();
  SurfacePaths(const SurfacePaths&) = delete;
  SurfacePaths& operator=(const SurfacePaths&) = delete;

  /// The path between two points of the surface; takes time in proportion to the part of the
  /// surface that it could lead through. Throws InvalidInput if there is none, Aborted.
  SurfacePath Find(const SurfacePoint& from, const SurfacePoint& to, const Progress& progress = {});

  /// Of half-edge 3 t + k the opposite one, or -1 on the boundary.
  const std::vector<int>& Twins() const { return this->OppositeHalfEdges; }

private:
  std::vector<int> TrianglesAt(const SurfacePoint& position) const;

  Surface Searched;
  std::vector<int> OppositeHalfEdges;
  class StripSearch;
  std::unique_ptr<StripSearch> Search;
};

} // namespace shape
