#pragma once

#include "Base/Progress.h"
#include "Mesh/Mesh.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace shape
{

/// Points closer than this fraction of their bounding box's diagonal are coincident.
constexpr double WeldTolerance = 1e-9;

/// Returns, for each point (n x 3, finite), the first point coincident with it, usually itself.
/// Throws Aborted.
std::vector<int> FindPointsWithinTolerance(
  const Eigen::MatrixXd& points, const Progress& progress = {});

/// The same, for points closer than `distance`, in the points' units.
std::vector<int> FindPointsWithinDistance(
  const Eigen::MatrixXd& points, double distance, const Progress& progress = {});

/**
 * A surface whose seams are closed. Two boundary edges are welded if their ends are coincident. The
 * two ends of an edge without length are welded, too. A triangle soup thus becomes the connected
 * surface that it represents, while points that only touch stay separate. Welded points take the
 * position of the first of them. Triangles with fewer than three distinct points are removed.
 */
struct WeldedSurface
{
  /// Points that no triangle uses do not affect the tolerance. Throws InvalidInput if no triangle
  /// has three distinct positions, an index is out of range, or a coordinate (also of an unused
  /// point) is not finite; Aborted. name: denotes the surface in messages.
  explicit WeldedSurface(
    const Mesh& surface, const Progress& progress = {}, const std::string& name = "the surface");

  Mesh Surface;               ///< with all points; its triangles have three distinct points
  std::vector<int> Triangles; ///< the original index of each triangle
  std::vector<int> First;     ///< for each point, the point it is welded to, or itself
  int WeldedPoints = 0;       ///< number of points that were replaced by another point
};

} // namespace shape
