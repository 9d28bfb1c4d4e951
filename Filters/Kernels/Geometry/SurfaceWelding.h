#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// Points nearer than this share of the diagonal of their box are at one place.
constexpr double WeldTolerance = 1e-9;

/// Of each point (n x 3, finite) the first one at its place: itself, mostly. Throws Aborted.
std::vector<int> FindPointsWithinTolerance(
  const Eigen::MatrixXd& points, const Progress& progress = {});

/**
 * A surface whose seams are closed: sides of triangles that are alone between their points become
 * one where their ends are at the same places, and so do the ends of sides that have no length. So
 * a soup hangs together as the surface that it is, while points that only touch stay apart. A
 * welded point is where the first one is. Triangles of fewer than three points are left out.
 */
struct WeldedSurface
{
  /// Points that no triangle uses do not count for the tolerance. Throws InvalidInput where there
  /// is no triangle of three places, an index is out of range or a coordinate, of those points too,
  /// is not finite; Aborted. name: what an error calls the surface.
  explicit WeldedSurface(
    const Mesh& surface, const Progress& progress = {}, const std::string& name = "the surface");

  Mesh Surface;               ///< the same points; triangles of three different ones
  std::vector<int> Triangles; ///< of each: the given one
  std::vector<int> First;     ///< of each point: the one that stands for those welded to it
  int WeldedPoints = 0;       ///< that another one stands for
};

} // namespace shape
