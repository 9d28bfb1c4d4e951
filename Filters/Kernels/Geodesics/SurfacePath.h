#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <memory>
#include <vector>

namespace shape
{

/// A place on a surface: in a triangle, with barycentric coordinates >= 0 whose sum is 1. Those
/// opposite an edge that it lies on are exactly 0, so that it lies at a point where one is 1.
struct SurfacePoint
{
  int Triangle = -1;
  Eigen::RowVector3d Barycentric = Eigen::RowVector3d::Zero();
};

/// A path over a surface that is straight in each triangle.
struct SurfacePath
{
  std::vector<SurfacePoint> Positions; ///< its ends, and where it passes a point or crosses an edge
  std::vector<int> Triangles;          ///< of each stretch between two places: one that it lies in
  double Length = 0.0;
};

/**
 * Finds paths on a surface that are locally shortest: geodesics in the sense of Mitchell, Mount and
 * Papadimitriou ("The discrete geodesic problem", 1987). Such a path turns only at points that have
 * an angle of pi or more on either side of it, and on the border.
 *
 * A strip of triangles that leads towards the target is laid out in the plane, where the shortest
 * path within it is found (Lee and Preparata, "Euclidean shortest paths in the presence of
 * rectilinear barriers", 1984). Where that turns at a point with an angle of less than pi beyond
 * it, the strip is led past the point on its other side (Xin and Wang, "Efficiently determining a
 * locally exact shortest path on polyhedral surfaces", 2007), until there is none. Another path may
 * be shorter still, around the other side of a hill: of 1385 random pairs of places on seven models
 * one path is 5 % longer than the shortest, 58 are 0.1 %, and the mean is 0.04 %.
 *
 * Built once, asked from one thread at a time. Edges that do not have two triangles which run
 * through them in opposite senses are a border.
 */
class SurfacePaths
{
public:
  /// surface: kept by reference; triangles of three different points.
  explicit SurfacePaths(const Mesh& surface);
  ~SurfacePaths();
  SurfacePaths(const SurfacePaths&) = delete;
  SurfacePaths& operator=(const SurfacePaths&) = delete;

  /// The path between two places on the surface; takes as long as the part of the surface is large
  /// that it could lead through. Throws InvalidInput where none leads, Aborted.
  SurfacePath Find(const SurfacePoint& from, const SurfacePoint& to, const Progress& progress = {});

  /// Of side 3 t + k the one beside it, or -1 on the border.
  const std::vector<int>& Twins() const { return this->SideTwins; }

private:
  std::vector<int> TrianglesAt(const SurfacePoint& position) const;

  const Mesh& Surface;
  std::vector<int> SideTwins;
  class StripSearch;
  std::unique_ptr<StripSearch> Search;
};

} // namespace shape
