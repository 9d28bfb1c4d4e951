#pragma once

#include "Base/Progress.h"
#include "Correspondence/CommonBase/SurfaceCurves.h"
#include "Correspondence/Pair/SurfaceMaps.h"
#include "Mesh/Mesh.h"
#include "Mesh/Surface.h"
#include "Mesh/SurfacePoints.h"

#include <Eigen/Core>

#include <array>
#include <vector>

namespace shape
{

/// A surface divided into the patches of a base domain.
struct PatchedSurface
{
  Mesh Surface; ///< the surface, with triangles split along the paths; the given points come first
  Eigen::VectorXi Patches; ///< for each triangle, its patch
  /// For each path, its points in order. Path e runs between the nodes BaseDomain::Paths[e].
  std::vector<std::vector<int>> Paths;
  /// The number of paths that are pieces of given curves. They come first, and their edges were not
  /// split, except at nodes.
  int CurvePaths = 0;
  /// For each point after the given ones, the ends of the edge that was split there. Splits of
  /// other edges came before or after it, in the order of the points.
  std::vector<std::array<int, 2>> SplitEdges;
  /// For each triangle, the given triangle that contains it.
  Eigen::VectorXi GivenTriangles;
  /// For each triangle, the barycentric coordinates of its corners in the given triangle, one per
  /// row.
  std::vector<Eigen::Matrix3d> GivenBarycentrics;

  /// Returns a position on a triangle as one on the given surface.
  SurfacePoint OnGiven(int triangle, const Eigen::RowVector3d& barycentric) const
  {
    return { this->GivenTriangles(triangle), barycentric * this->GivenBarycentrics[triangle] };
  }
};

/// Patches with three sides, the same ones on two surfaces.
struct BaseDomain
{
  int Genus = 0;
  /// The nodes at the ends of each path: landmarks, or points between them where a curve is
  /// divided.
  std::vector<std::array<int, 2>> Paths;
  /// For each patch, its sides, counter-clockwise. Side 2 e is path e, and side 2 e + 1 the same
  /// path in the other direction. The patch is to the left.
  std::vector<std::array<int, 3>> Patches;
  PatchedSurface A, B;
};

/**
 * Divides two closed surfaces of the same genus into the same triangular patches, whose corners are
 * landmarks (Praun, Sweldens and Schroeder, "Consistent mesh parameterizations", 2001; Kraevoy and
 * Sheffer, "Cross-parameterization and compatible remeshing of 3D models", 2004).
 *
 * Paths are traced on both surfaces at once, the shortest ones first. A new path starts and ends in
 * the same gaps between earlier paths on both surfaces, so the cyclic order around landmarks is the
 * same, and it crosses no earlier path. Triangles are split where a path passes through them, so
 * that no path is blocked.
 * 0. Given curves are paths from the start. A closed curve is divided into three.
 * 1. Paths between landmarks that are not yet connected, until they form a tree. What is left of
 *    each surface has one boundary cycle and all handles.
 * 2. For each handle, two paths: one that cuts the cycle in two, and one that joins these. If the
 *    first one and the tree close a loop that bounds inside the surface, the second one closes a
 *    loop that bounds outside, or the other way round (handle and tunnel loops of Dey, Li, Sun and
 *    Cohen-Steiner, "Computing geometry-aware handle and tunnel loops in 3D models", 2008). The
 *    linking numbers of loops tell which, so these paths are the same ones on both surfaces. What
 *    is left is a disk.
 *    A curve that closes a loop around a handle takes the place of the first path. Curves that
 *    close other loops leave several disks.
 * 3. Diagonals of the disks, until all patches have three sides.
 *
 * a, b: closed, connected and equally oriented 2-manifolds of genus at most 4. landmarks: at least
 * three pairs for genus 0 and two for higher genus. No point occurs twice. curves: they meet only
 * at landmarks and at their ends. Throws InvalidInput if the input is not as required, if a surface
 * of genus > 0 intersects itself, if curves meet elsewhere or leave a landmark in different orders
 * on both surfaces, or if a closed curve bounds neither inside nor outside, or not alike on both;
 * SolveFailure if curves separate landmarks on one surface only, or if no path cuts a handle
 * without crossing itself; Aborted.
 */
BaseDomain TraceBaseDomain(const Surface& a, const Surface& b, const Landmarks& landmarks,
  const std::vector<CurvePair>& curves = {}, const Progress& progress = {});

} // namespace shape
